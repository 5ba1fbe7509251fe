// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "riprap/validation/ding/ballast_rows.hpp"
#include "riprap/validation/ding/planar_cases.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;

namespace {

/// Gives how ice comes to the bed, by the speed of the air cannon [m/s].
struct Approach {
    const char* words;
    Vec2 (*velocity)(double speed);
};

/// Bars of ice, 600 mm (4.85 kg) and 300 mm long, at train speeds [Ding2021, section 5.3].
void air_cannon(const Approach& approach, const CaseSetting& setting, CaseReport& report, const char* plot_name) {
    const std::vector<BallastBed> beds = beds_of(setting, 1.2, 0.2);
    report_bed(report, beds);
    Plot plot;
    plot.title = "Stones thrown higher than 330 mm by ice from an air cannon";
    plot.subtitle = approach.words;
    plot.x.label = "speed [km/h]";
    plot.y.label = "stones [-]";
    std::vector<double> heavy;
    double worst = 0;
    bool is_heavier_more = true, is_rising = true;
    for (const double length : {0.6, 0.3}) {
        Curve curve{fmt::format("{:.2f} kg", 934 * length * 0.105 * 0.0825), {}, {}, CurveStyle::markers, -1};
        double before = 0;
        for (const double speed : {20.0, 40.0, 60.0, 80.0, 100.0, 120.0}) {
            const Mean mean = mean_of(strikes_of(beds, {.velocity = approach.velocity(speed * kmh),
                                                        .height = 0.01,
                                                        .place = -0.25,
                                                        .corners = 0,
                                                        .size = {length, 0.105},
                                                        .after = 0.3}));
            const std::string name = fmt::format("{} mm of ice at {} km/h", 1e3 * length, speed);
            report.state(
                {fmt::format("{}, {}: stones above 330 mm", name, approach.words), "-", "the paper's figure is lost"},
                mean.above_330);
            if (speed < 30) {
                report.judge({name + ": stones above 330 mm", "-", {}, 0.0, {}}, mean.above_330, 0, 0);
            }
            is_rising = is_rising && mean.above_330 >= before;
            before = mean.above_330;
            if (length > 0.5) {
                heavy.push_back(mean.above_330);
            } else {
                is_heavier_more = is_heavier_more && heavy[curve.x.size()] >= mean.above_330;
            }
            worst = std::max(worst, mean.ledger);
            curve.x.push_back(speed);
            curve.y.push_back(mean.above_330);
        }
        plot.curves.push_back(curve);
    }
    judge_yes(report, "the number does not fall with speed", "increases with speed", is_rising);
    judge_yes(report, "heavier ice throws at least as many", "increases with mass", is_heavier_more);
    report_ledger(report, worst);
    write_plot(setting, plot_name, plot);
}

}  // namespace

void planar_air_cannon(const CaseSetting& setting, CaseReport& report) {
    const auto oblique = [](double speed) {
        constexpr double angle = 15 * std::numbers::pi / 180;
        return speed * Vec2{std::cos(angle), -std::sin(angle)};
    };
    air_cannon({"15 degrees", oblique}, setting, report, "planar_air_cannon");
}

void planar_air_cannon_level(const CaseSetting& setting, CaseReport& report) {
    const auto level = [](double speed) { return Vec2{speed, -std::sqrt(2 * 9.81 * 0.6)}; };
    air_cannon({"along the track, after a fall of 600 mm", level}, setting, report, "planar_air_cannon_level");
}

}  // namespace riprap::validation::ding
