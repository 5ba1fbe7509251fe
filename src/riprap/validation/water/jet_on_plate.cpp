// SPDX-License-Identifier: Apache-2.0
// A steady plane jet on a plate, without end and of finite width, against free-streamline theory [MilneThomson1968].
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double density = 1000, speed = 1, half = 0.1;  ///< [kg/m^3], [m/s], half the thickness [m]
constexpr double head = 0.5 * density * speed * speed;   ///< [Pa]
constexpr double settled = 3;                            ///< what the first impact stirred up is gone [s]

/// Half of a jet on half of a plate, whose edge turns it by an angle beta: a quarter turn where the plate has no end.
///
/// In the plane of (u - i v)/U the flow is half a disc, the plate its diameter, the jet a source at 1 and the two that
/// leave sinks at exp(-+i beta). At the place where the water runs along the plate with s U,
///
///     dz/ds = (4 b/pi) (1/(1 + s^2) - (s^2 + cos 2 beta)/(s^4 + 2 s^2 cos 2 beta + 1)),   p = rho U^2 (1 - s^2)/2.
struct Stream {
    double turn;  ///< beta [rad]

    /// Place on the plate, from its middle [m]
    double place(double s) const {
        constexpr int cells = 2000;
        double z = 0;
        for (int i = 0; i < cells; ++i) {
            const double m = s * (i + 0.5) / cells, c = std::cos(2 * turn);
            z += 1 / (1 + m * m) - (m * m + c) / (m * m * m * m + 2 * m * m * c + 1);
        }
        return 4 * half / M_PI * z * s / cells;
    }
    /// [Pa]
    double pressure(double z) const {
        double low = 0, high = 1;
        for (int i = 0; i < 60; ++i) {
            const double s = 0.5 * (low + high);
            (place(s) < z ? low : high) = s;
        }
        return head * (1 - low * low);
    }
    /// [N/m]
    double force() const { return density * speed * speed * half * (1 - std::cos(turn)); }
};

/// The stream that a plate turns whose edge is this far from its middle [m].
Stream at_edge(double edge) {
    double low = 0.1, high = 0.5 * M_PI;
    for (int i = 0; i < 50; ++i) {
        const double turn = 0.5 * (low + high);
        (Stream{turn}.place(1) < edge ? low : high) = turn;
    }
    return {low};
}

struct Gauge {
    const char* name;
    double place;  ///< from the middle of the plate [m]
};
constexpr std::array gauges{Gauge{"middle", 0}, Gauge{"p_100", 0.1}, Gauge{"p_150", 0.15}, Gauge{"p_200", 0.2}};

void judge_stream(CaseReport& report, const WaterTrial& trial, const Stream& exact, const std::string& plate) {
    const double end = trial.now();
    report.judge({fmt::format("{}: force on half of it", plate), "N/m", {}, exact.force(), "rho U^2 b (1 - cos beta)"},
                 trial.mean("plate.fluid_pressure_force.x", settled, end), Relative{0.02});
    for (const Gauge& gauge : gauges) {
        const double pressure = exact.pressure(gauge.place);
        const double band = 0.03 * (pressure > 1e-3 * head ? pressure : head);  // at an edge the exact pressure is zero
        report.judge({fmt::format("{}: pressure at {:.1f} b", plate, gauge.place / half), "Pa", {}, pressure, {}},
                     trial.mean(gauge.name, settled, end), pressure - band, pressure + band);
    }
    judge_ledger(report, trial, plate);
}

/// Pressure along the plate, as theory has it and as the gauges read it.
void add_curves(const WaterTrial& trial, const Stream& exact, double edge, const std::string& plate, int color,
                Plot& plot) {
    std::vector<double> along, theory, places, ours;
    for (int i = 0; i <= 60; ++i) {
        along.push_back(edge * i / 60);
        theory.push_back(exact.pressure(along.back()));
    }
    for (const Gauge& gauge : gauges) {
        places.push_back(gauge.place);
        ours.push_back(trial.mean(gauge.name, settled, trial.now()));
    }
    plot.curves.push_back({plate + ", theory", along, theory, CurveStyle::line, color});
    plot.curves.push_back({plate + ", ours", places, ours, CurveStyle::markers, color});
}

}  // namespace

void jet_on_plate(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.003125"};
    }
    WaterTrial endless(setting, finer);
    endless.run();
    Plot plot{"A steady jet on a plate",
              "half thickness 0.1 m, 1 m/s",
              {"from the middle of the plate [m]", false},
              {"pressure [Pa]", false},
              {},
              false};
    const Stream quarter_turn{0.5 * M_PI};
    judge_stream(report, endless, quarter_turn, "long plate");
    add_curves(endless, quarter_turn, 3 * half, "long plate", 0, plot);

    finer.insert(finer.end(), {"body.plate.shape={box=[0.3,0.2]}", "body.plate.position=[0.15,0.1]"});
    WaterTrial edged(setting, finer);
    edged.run();
    const Stream turned = at_edge(2 * half);
    judge_stream(report, edged, turned, "plate 4 b wide");
    add_curves(edged, turned, 2 * half, "plate 4 b wide", 1, plot);
    write_plot(setting, "jet_on_plate", plot);
}

}  // namespace riprap::validation::water
