// SPDX-License-Identifier: Apache-2.0
// A floating cylinder that was held down and let go comes to rest by the waves that it makes [Ursell1949],
// [MaskellUrsell1970].
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/heaving_cylinder.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double radius = 0.1, level = 0.6;  ///< of case.toml [m]

/// Turning points of an oscillation about zero: one between any two crossings and one after the last; NaN where there
/// is none yet.
std::vector<Crest> turns_of(std::span<const double> time, std::span<const double> y) {
    std::vector<double> ends = crossings(time, y, 0);
    ends.push_back(time.back());
    std::vector<Crest> turns;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        std::vector<double> when, height;
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (time[i] >= ends[k] && time[i] <= ends[k + 1]) {
                when.push_back(time[i]);
                height.push_back(k % 2 == 0 ? -y[i] : y[i]);  // it starts above zero
            }
        }
        turns.push_back(crest_of(when, height));
    }
    return turns;
}

/// The first three turning points; the first and the third lie on the other side.
struct Swings {
    std::array<double, 3> time;
    double first, second;  ///< from turn to turn, whatever the swing is about [-]
    double offset;         ///< of the middle of the second one, towards the start [-]

    explicit Swings(std::vector<Crest> turns) {
        turns.resize(3, {std::nan(""), std::nan("")});
        time = {turns[0].time, turns[1].time, turns[2].time};
        first = turns[0].level + turns[1].level;
        second = turns[1].level + turns[2].level;
        offset = 0.5 * (turns[1].level - turns[2].level);
    }
};

}  // namespace

void heave_decay(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.005"};
    }
    WaterTrial trial(setting, finer);
    const double unit = std::sqrt(radius / norm(trial.model().gravity.value));
    const double held = trial.initial().bodies.position.back().y - level;
    trial.run();
    const HeaveDecay theory;
    std::vector<double> time, ours, exact;
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        time.push_back(trial.time()[i] / unit);
        ours.push_back((trial.column("cylinder.position.y")[i] - level) / held);
        exact.push_back(theory.at(time.back()));
    }
    const Swings expected(turns_of(time, exact)), found(turns_of(time, ours));
    for (std::size_t turn = 0; turn < 3; ++turn) {
        report.judge({fmt::format("turn {} at t sqrt(g/a)", turn + 1), "-", {}, expected.time[turn], "Ursell"},
                     found.time[turn], Relative{0.03});
    }
    report.judge({"swing from turn 1 to 2 over the first height", "-", {}, expected.first, {}}, found.first,
                 Relative{0.15});
    report.judge({"swing from turn 2 to 3", "-", {}, expected.second, {}}, found.second, Relative{0.15});
    report.judge({"middle of that swing, on the side of the start", "-", {}, expected.offset, "water without end"},
                 found.offset, Relative{0.15});
    judge_ledger(report, trial);
    write_plot(setting, "heave_decay",
               {"A floating cylinder comes to rest",
                "linear theory: Ursell 1949, Maskell and Ursell 1970",
                {"t sqrt(g/a) [-]", false},
                {"depth below its place over that at the start [-]", false},
                {{"theory", time, exact, CurveStyle::dashed, -1}, {"ours", time, ours, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
