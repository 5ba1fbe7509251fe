// SPDX-License-Identifier: Apache-2.0
// The front of a column of water twice as high as wide, let go on a dry floor.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

/// Z = x/a against T = t sqrt(2g/a), as digitised.
struct Measured {
    std::string_view source;
    std::vector<double> time, front;
};

const std::vector<Measured>& experiments() {
    static const std::vector<Measured> all{
        {"Koshizuka and Oka 1996",
         {0.769, 1.153, 1.537, 1.935, 2.323, 2.719, 3.096},
         {1.252, 1.505, 1.892, 2.241, 2.615, 3.003, 3.624}},
        {"Martin and Moyce 1952, a = 2.25 in",
         {0.832, 1.219, 1.997, 2.547, 3.345, 4.034},
         {1.217, 1.474, 2.292, 2.995, 4.134, 4.944}},
        {"Martin and Moyce 1952, a = 1.125 in",
         {0.849, 1.212, 1.602, 2.283, 2.950, 3.598},
         {1.245, 1.443, 1.884, 2.689, 3.728, 4.528}},
    };
    return all;
}

/// Errors of T at given Z over T, 1.5 <= Z <= 4, after the one shift |dT| <= 0.3 that makes their mean least: a real
/// gate needs time.
struct FrontError {
    double mean{1e9}, max{1e9}, shift{0};
};

FrontError compare(const Measured& measured, std::span<const double> time, std::span<const double> front) {
    FrontError best;
    for (double shift = -0.3; shift < 0.3001; shift += 0.01) {
        double sum = 0, largest = 0, count = 0;
        for (std::size_t i = 0; i < measured.time.size(); ++i) {
            if (measured.front[i] < 1.5 || measured.front[i] > 4) {
                continue;
            }
            const double ours = interpolated(front, time, measured.front[i]) + shift;
            const double error = std::abs(ours / measured.time[i] - 1);
            sum += error;
            largest = std::max(largest, error);
            count += 1;
        }
        if (sum / count < best.mean) {
            best = {sum / count, largest, shift};
        }
    }
    return best;
}

}  // namespace

void dam_break_front(const CaseSetting& setting, CaseReport& report) {
    const double width = 0.146, scale = std::sqrt(2 * 9.81 / width);
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.001825"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    std::vector<double> time, front;
    for (std::size_t i = 0; i < trial.time().size(); ++i) {  // up to the far wall; a front never goes back
        const double z = trial.column("front")[i] / width;
        if (z < 3.97 && (front.empty() || z > front.back())) {
            time.push_back(trial.time()[i] * scale);
            front.push_back(z);
        }
    }
    Plot plot{"Front of a dam break on a dry floor",
              "column twice as high as wide; no gate in the simulation",
              {"t sqrt(2g/a) [-]", false},
              {"x/a [-]", false},
              {{"ours", time, front, CurveStyle::line, 0}},
              false};
    for (const Measured& measured : experiments()) {
        const FrontError error = compare(measured, time, front);
        report.judge_below({fmt::format("{}: mean error of the time of the front", measured.source),
                            "-",
                            {},
                            0.0,
                            "relative to the measured time, 1.5 <= x/a <= 4, after one shift"},
                           error.mean, 0.05);
        report.judge_below({fmt::format("{}: largest error", measured.source), "-", {}, 0.0, {}}, error.max, 0.10);
        report.state({fmt::format("{}: shift of t sqrt(2g/a) that fits best", measured.source), "-",
                      "a gate needs time: up to 0.3 either way is allowed"},
                     error.shift);
        plot.curves.push_back({std::string(measured.source), measured.time, measured.front, CurveStyle::markers, -1});
    }
    judge_ledger(report, trial);
    write_plot(setting, "dam_break_front", plot);
}

}  // namespace riprap::validation::water
