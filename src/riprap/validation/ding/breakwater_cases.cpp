// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/ding/breakwater.hpp"
#include "riprap/wave/steady_wave.hpp"

namespace riprap::validation::ding {

using namespace grid;

namespace {

constexpr double gauge_1 = 26;  // P1 [m]

/// Highest value of a record and its time.
std::array<double, 2> peak_of(const GridTrial& trial, const std::string& name) {
    const auto& column = trial.column(name);
    const auto best = std::max_element(column.begin(), column.end());
    return {*best, trial.time()[static_cast<std::size_t>(best - column.begin())]};
}

/// Wave alone on a flat bed; returns the error of the surface at P1 over the pulse, relative in L2.
double run_profile(const Breakwater& breakwater, const std::string& name, CaseReport& report) {
    GridTrial trial = make_breakwater(breakwater);
    trial.add("P1", [](const GridTrial& t) {
        return read_level(t.settings(), t.state(), {gauge_1, 0, 0}, 1) - Breakwater::depth;
    });
    trial.add("U1", [](const GridTrial& t) { return read_velocity(t.settings(), t.state(), {gauge_1, 5, 0}).x; });
    trial.run(10);
    const wave::SteadyWave wave = wave::solitary_wave(Breakwater::wave_height, Breakwater::depth, 9.81);
    double error = 0, size = 0;
    for (std::size_t i = 1; i < trial.time().size(); ++i) {
        const double t = trial.time()[i], dt = t - trial.time()[i - 1];
        const double exact = wave.elevation(gauge_1 - wave.celerity * (t - crest_at_inlet));
        error += dt * std::pow(trial.column("P1")[i] - exact, 2);
        size += dt * exact * exact;
    }
    const auto [crest, time] = peak_of(trial, "P1");
    const double arrival = crest_at_inlet + gauge_1 / wave.celerity;
    if (breakwater.by_boussinesq) {
        report.judge({name + ": crest at P1 above still water", "m", {}, 6.0, {}}, crest, Relative{0.12});
        report.judge({name + ": arrival of the crest at P1", "s", {}, arrival, {}}, time, Absolute{0.3});
    } else {
        report.judge({name + ": crest at P1 above still water", "m", {}, 6.0, {}}, crest, Relative{0.05});
        report.judge({name + ": arrival of the crest at P1", "s", {}, arrival, {}}, time, Absolute{0.15});
        const double speed = wave.velocity(0, 5).along;
        report.judge({name + ": velocity at P1, half depth, largest", "m/s", {}, speed, {}}, peak_of(trial, "U1")[0],
                     Relative{0.15});
    }
    trial.report_books(report);
    return std::sqrt(error / size);
}

}  // namespace

void solitary_profile(const CaseSetting& setting, CaseReport& report) {
    // Ratios of sqrt 2 as the thesis has them: 430 x 57, 600 x 80, 840 x 112 with --full, a third of that without.
    const double coarse = setting.is_full ? 1 : 2.5;
    std::array<double, 3> errors{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double h = coarse * 0.56 / std::pow(std::sqrt(2.0), static_cast<double>(i));
        errors[i] = run_profile({h, h * 0.625, 2, 2, false, false}, fmt::format("cells of {:.2f} m", h), report);
        report.state({fmt::format("cells of {:.2f} m: error of the surface at P1 over the pulse, L2", h)}, errors[i]);
    }
    report.judge_below({"error of the surface at P1, middle mesh", "-", {}, 0.0, {}}, errors[1], 0.08);
    const double order = std::log(errors[0] / errors[2]) / std::log(2.0);
    report.judge({"order of convergence of the surface at P1", "-", {}, 1.0, {}}, order, 0.8, 3.0);
    const double h = coarse * 0.4;
    run_profile({h, h * 0.625, 2, 2, false, true}, "input of the thesis", report);
}

void caisson_pressure(const CaseSetting& setting, CaseReport& report) {
    const double h = setting.is_full ? 0.4 : 1.0;
    GridTrial trial = make_breakwater({h, h * 0.625, 2, 2, true, false});
    const double front = Breakwater::caisson_front, third = Breakwater::caisson_height / 3;
    const std::array<const char*, 4> names{"A", "B", "C", "D"};
    const auto pressure_at = [=](const GridTrial& t, double y) {
        return read_pressure(t.settings(), t.state(), {front - 0.6 * h, y, 0});
    };
    // At the toe the line through the two lowest cells ends at the bed: exact for water at rest.
    const double low = 0.5 * h * 0.625;
    trial.add(names[0], [=](const GridTrial& t) { return 1.5 * pressure_at(t, low) - 0.5 * pressure_at(t, 3 * low); });
    for (std::size_t i = 1; i < 4; ++i) {
        const double y = std::min(static_cast<double>(i) * third, 13 - 0.5 * h);
        trial.add(names[i], [=](const GridTrial& t) { return pressure_at(t, y); });
    }
    for (const double x : {143.0, 201.5}) {
        trial.add(fmt::format("{}", x), [=](const GridTrial& t) {
            return read_level(t.settings(), t.state(), {x, 0, 0}, 1) - Breakwater::depth;
        });
    }
    trial.add("jet", height_at_front);
    trial.run(28);
    const double still = 9810 * Breakwater::depth;
    report.judge({"pressure at A, 10 s, before the wave", "Pa", {}, still, {}}, trial.at_time("A", 10), Relative{0.01});
    std::array<double, 4> peaks{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [peak, time] = peak_of(trial, names[i]);
        peaks[i] = peak;
        report.state({fmt::format("largest pressure at {}, at {:.1f} s", names[i], time), "Pa"}, peak);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        report.judge_below(
            {fmt::format("largest pressure at {} over that at {}", names[i + 1], names[i]), "-", {}, 1.0, {}},
            peaks[i + 1] / peaks[i], 1.0);
    }
    report.judge({"time of the largest pressure at A", "s", 21.0, {}, {}}, peak_of(trial, "A")[1], 20, 22.5);
    report.judge({"pressure at A, 27 s, over that of still water", "-", 1.0, {}, {}}, trial.at_time("A", 27) / still,
                 0.9, 1.1);
    report.judge({"crest at P5 over crest at P2", "-", 1.0, {}, {}},
                 peak_of(trial, "201.5")[0] / peak_of(trial, "143")[0], 1.0, 2.0);
    report.judge({"highest water at the front, 21 to 22 s", "m", 16.0, {}, {}},
                 std::max({trial.at_time("jet", 21), trial.at_time("jet", 21.5), trial.at_time("jet", 22)}), 16.0,
                 30.0);
    trial.report_books(report);
}

void seaward_slopes(const CaseSetting& setting, CaseReport& report) {
    // Printed heights are those of a plot in whole units of a seventh of the caisson; its formula does not give them.
    const std::array<double, 4> printed{1.86, 3.71, 5.57, 9.28};
    const double h = setting.is_full ? 0.4 : 1.0;
    std::array<double, 4> heights{}, over{};
    for (std::size_t i = 0; i < 4; ++i) {
        GridTrial trial = make_breakwater({h, h * 0.625, static_cast<double>(i + 1), 2, true, false});
        double highest = 0, spilled = 0;
        trial.run(26, [&](GridTrial& t) {
            highest = std::max(highest, height_at_front(t) - Breakwater::caisson_height);
            double sum = 0;
            const Mesh& mesh = t.settings().mesh;
            for (int j = mesh.cell_at(1, Breakwater::caisson_height); j < mesh.box.cells[1]; ++j) {
                for (int k = mesh.cell_at(0, 150); k < mesh.box.cells[0]; ++k) {
                    sum += t.state().fraction[at(mesh.box.index(k, j, 0))] * mesh.volume(k, j, 0);
                }
            }
            spilled = std::max(spilled, sum);
        });
        heights[i] = highest;
        over[i] = spilled;
        report.judge({fmt::format("highest water above the caisson, slope 1:{}", i + 1), "m", printed[i], {}, {}},
                     highest, 0.65 * printed[i], 1.35 * printed[i]);
        report.state({fmt::format("largest volume above the height of the caisson, slope 1:{}", i + 1), "m^2"},
                     spilled);
    }
    for (std::size_t i = 0; i + 1 < 4; ++i) {
        report.judge_below({fmt::format("height at 1:{} over that at 1:{}", i + 1, i + 2), "-", {}, 1.0, {}},
                           heights[i] / heights[i + 1], 1.0);
        report.judge_below({fmt::format("volume at 1:{} over that at 1:{}", i + 2, i + 1), "-", {}, 1.0, {}},
                           over[i + 1] / over[i], 1.0);
    }
}

void layer_thickness(const CaseSetting& setting, CaseReport& report) {
    const double h = setting.is_full ? 0.4 : 1.0;
    std::array<double, 4> energy{};
    for (std::size_t i = 0; i < 4; ++i) {
        GridTrial trial = make_breakwater({h, h * 0.625, 2, static_cast<double>(i), true, false});
        trial.run(24);
        const Mesh& mesh = trial.settings().mesh;
        energy[i] = reduce_cells(
            mesh.box, 0.0,
            [&](std::int64_t c, int, int, int) {
                return trial.state().turbulent_energy[at(c)] * trial.state().fraction[at(c)] *
                       trial.scratch().room.capacity[at(c)];
            },
            sum_of);
        report.state(
            {fmt::format("turbulent energy of the water at 24 s over its density, layer of {} m", i), "m^4/s^2"},
            energy[i]);
    }
    for (std::size_t i = 0; i + 1 < 4; ++i) {
        report.judge_below({fmt::format("turbulent energy with {} m over that with {} m", i + 1, i), "-", {}, 1.0, {}},
                           energy[i + 1] / energy[i], 1.0);
    }
}

}  // namespace riprap::validation::ding
