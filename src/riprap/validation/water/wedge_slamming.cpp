// SPDX-License-Identifier: Apache-2.0
// A wedge goes through a flat surface at constant speed, without gravity: similarity solution [ZhaoFaltinsen1993].
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

void wedge_slamming(const CaseSetting& setting, CaseReport& report) {
    // Force over rho V^3 t per metre, deadrise 30 degrees. Wagner's limit of small angles, pi^3/(4 tan^2 beta) = 23.3,
    // is too high here.
    constexpr double published = 14.14, density = 1000, speed = 1;
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.005"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    // Force grows as time from the touch of the tip: slopes of straight lines through the origin.
    const auto coefficient = [&](double start, double end) {
        std::vector<double> moment;
        for (std::size_t i = 0; i < trial.time().size(); ++i) {
            moment.push_back(trial.column("wedge.fluid_pressure_force.y")[i]);
        }
        const double mean = integral(trial.time(), moment, start, end) / (end - start);
        const double touch = 0.0025 / speed;  // of case.toml
        return mean / (density * speed * speed * speed * (0.5 * (start + end) - touch));
    };
    const double all = coefficient(0.06, 0.16), early = coefficient(0.06, 0.11), late = coefficient(0.11, 0.16);
    report.judge({"force over rho V^3 t, 0.06 to 0.16 s", "-", published, {}, "similarity solution"}, all,
                 0.93 * published, 1.07 * published);
    report.judge({"the same, second half over first", "-", {}, 1.0, "force grows as time"}, late / early,
                 Relative{0.05});
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
