// SPDX-License-Identifier: Apache-2.0
// A floating cylinder that was held down and let go comes to rest by the waves that it makes [Ursell1949],
// [MaskellUrsell1970].
#include <cmath>
#include <string>
#include <vector>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/heaving_cylinder.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double radius = 0.1, level = 0.6, held = -0.03;  ///< of case.toml [m]

/// A moment at which a record turns, and what it is there.
struct Turn {
    double time, value;
};

/// Where y turns, by the parabola through a row and its neighbours; what comes before `start` is left out.
std::vector<Turn> turns_of(const std::vector<double>& time, const std::vector<double>& y, double start) {
    std::vector<Turn> turns;
    for (std::size_t i = 1; i + 1 < y.size(); ++i) {
        const double before = y[i] - y[i - 1], after = y[i + 1] - y[i];
        if (time[i] > start && before * after < 0) {
            const double rows = 0.5 * (before + after) / (before - after);
            turns.push_back({time[i] + rows * (time[i + 1] - time[i]), y[i] + 0.25 * rows * (before + after)});
        }
    }
    return turns;
}

}  // namespace

void heave_decay(const CaseSetting& setting, CaseReport& report) {
    const double unit = std::sqrt(radius / 9.81);
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.005"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    const HeaveDecay theory;
    std::vector<double> time, ours, exact;
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        time.push_back(trial.time()[i] / unit);
        ours.push_back((trial.column("cylinder.position.y")[i] - level) / held);
        exact.push_back(theory.at(time.back()));
    }
    constexpr double released = 1;  // before, what was at rest only begins to move
    const std::vector<Turn> expected = turns_of(time, exact, released), found = turns_of(time, ours, released);
    const auto turn = [](const std::vector<Turn>& turns, std::size_t n) {
        return n < turns.size() ? turns[n] : Turn{std::nan(""), std::nan("")};
    };
    const Turn first = turn(expected, 0), second = turn(expected, 1), third = turn(expected, 2);
    report.judge({"turns above its place at t sqrt(g/a)", "-", {}, first.time, "Ursell"}, turn(found, 0).time,
                 Relative{0.03});
    report.judge({"and below it again: its period", "-", {}, second.time, {}}, turn(found, 1).time, Relative{0.03});
    report.judge({"height there over that at the start, above", "-", {}, -first.value, "Ursell"}, -turn(found, 0).value,
                 Relative{0.15});
    report.judge({"below", "-", {}, second.value, {}}, turn(found, 1).value, Relative{0.15});
    report.state({"above, a period later", "-", {}, -third.value, "its tank is not without end"},
                 -turn(found, 2).value);
    judge_ledger(report, trial);
    write_plot(setting, "heave_decay",
               {"A floating cylinder comes to rest",
                "linear theory: Ursell 1949, Maskell and Ursell 1970",
                {"t sqrt(g/a) [-]", false},
                {"height of its centre over that at the start [-]", false},
                {{"theory", time, exact, CurveStyle::dashed, -1}, {"ours", time, ours, CurveStyle::line, -1}}});
}

}  // namespace riprap::validation::water
