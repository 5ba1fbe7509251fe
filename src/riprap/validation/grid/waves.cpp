// SPDX-License-Identifier: Apache-2.0
// Waves that come in through a side, travel, run up and go out.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"
#include "riprap/fluid/grid/wave_side.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::validation::grid {

namespace {

GridTrial::Gauge level_at(double x, double depth) {
    return [=](const GridTrial& t) { return read_level(t.settings(), t.state(), {x, 0, 0}, 1) - depth; };
}

/// Highest level of a record and its time.
struct Crest {
    double level{-1e9}, time{0};
};
Crest crest_of(const GridTrial& trial, const std::string& name) {
    Crest crest;
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        if (trial.column(name)[i] > crest.level) {
            crest = {trial.column(name)[i], trial.time()[i]};
        }
    }
    return crest;
}

}  // namespace

void regular_waves(const CaseSetting& setting, CaseReport& report) {
    // Shallow waves, kd = 0.3: within the range of the absorber. H = 0.02 m in 0.3 m, six wave lengths.
    const double d = 0.3, height = 0.02, period = 2 * M_PI / std::sqrt(9.81 * (0.3 / d) * std::tanh(0.3));
    const wave::SteadyWave wave = wave::regular_wave(height, period, d, 9.81);
    const double length = wave.length(), h = height / (setting.is_full ? 20 : 8);
    std::vector<double> y{0};
    while (y.back() < d - 3 * height) {
        y.push_back(std::min(d - 3 * height, y.back() + 4 * h));
    }
    while (y.back() < d + 3 * height - 1e-9) {
        y.push_back(y.back() + h);
    }
    GridSettings settings;
    const double end = 4 * length;
    settings.mesh = Mesh({uniform_edges(0, end, setting.is_full ? 800 : 400), y, {0, 0.1}}, 2);  // 100 to a length
    settings.side[3].kind = SideKind::open;
    settings.side[0] = wave_side(settings.mesh, 0, 1, 0, d, waves_of(wave, 0.25 * period), true);
    settings.side[1] = absorbing_side(settings.mesh, 1, 1, 0, d);
    GridTrial trial(settings, make_state(settings, [=](const Vec3& x) { return x.y < d; }));
    const std::array<double, 3> places{2 * length, 2.2 * length, 2.4 * length};
    for (const double x : places) {
        trial.add(fmt::format("{}", x), level_at(x, d));
    }
    trial.add("near", level_at(0.5 * length, d));
    trial.run(12 * period);
    std::vector<std::complex<double>> amplitudes;
    std::vector<double> late_time;
    const auto first = static_cast<std::size_t>(std::lower_bound(trial.time().begin(), trial.time().end(), 8 * period) -
                                                trial.time().begin());
    late_time.assign(trial.time().begin() + static_cast<std::ptrdiff_t>(first), trial.time().end());
    const double omega = 2 * M_PI / period;
    const auto amplitude = [&](const std::string& name) {
        const auto& column = trial.column(name);
        return wave::harmonic(
            late_time, std::vector<double>(column.begin() + static_cast<std::ptrdiff_t>(first), column.end()), omega);
    };
    for (const double x : places) {
        amplitudes.push_back(amplitude(fmt::format("{}", x)));
    }
    const wave::Separation parts = wave::separate_reflection(places, amplitudes, wave.wave_number);
    report.judge({"incident amplitude two lengths from the inlet over H/2", "-", {}, 1.0, {}},
                 2 * parts.incident / height, Relative{0.05});
    report.judge_below({"reflection by the absorbing side, kd = 0.3", "-", {}, 0.0, {}}, parts.reflection, 0.03);
    trial.report_books(report);
}

void wave_propagation(const CaseSetting& setting, CaseReport& report) {
    // Waves of H/d = 0.2 and kd = 1.2 over ten lengths, 10 cells to their height, 20 with --full, equal cells around
    // the surface and wider ones below; a sponge of two lengths behind.
    const double d = 0.5, height = 0.1, k = 1.2 / d, period = 2 * M_PI / std::sqrt(9.81 * k * std::tanh(1.2));
    const int per_height = setting.is_full ? 20 : 10;
    const wave::SteadyWave wave = wave::regular_wave(height, period, d, 9.81);
    const double length = wave.length(), h = height / per_height, end = 13.5 * length, calm = 11.5 * length;
    std::vector<double> y{0};
    while (y.back() < d - height - 1e-9) {
        y.push_back(std::min(d - height, y.back() + 4 * h));
    }
    while (y.back() < d + 1.2 * height - 1e-9) {
        y.push_back(y.back() + h);
    }
    while (y.back() < d + 2 * height - 1e-9) {
        y.push_back(y.back() + 2 * h);
    }
    GridSettings settings;
    settings.mesh = Mesh({uniform_edges(0, end, static_cast<int>(end / (3 * h))), y, {0, 0.1}}, 2);
    settings.side[3].kind = SideKind::open;
    settings.side[0] = wave_side(settings.mesh, 0, 1, 0, d, waves_of(wave, 0.25 * period), false);
    settings.sponges.push_back({[=](const Vec3& x) {
        const double share = std::max(0.0, (x.x - calm) / (end - calm));
        return 7 * std::sqrt(9.81 * d) / (end - calm) * share * share;
    }});
    GridTrial trial(settings, make_state(settings, [=](const Vec3& x) { return x.y < d; }));
    trial.add("near", level_at(length, d));
    trial.add("far", level_at(11 * length, d));
    const double group = wave::linear_wave(height, period, d, 9.81).group_velocity();
    const double arrival = 11 * length / group;
    trial.run(arrival + 7 * period);
    // mean height of the waves of three periods at either place, once the front has passed
    const auto height_of = [&](const char* name, double from) {
        double sum = 0;
        for (int n = 0; n < 3; ++n) {
            double low = 1e9, high = -1e9;
            for (std::size_t i = 0; i < trial.time().size(); ++i) {
                const double turns = (trial.time()[i] - from) / period - n;
                if (turns >= 0 && turns < 1) {
                    low = std::min(low, trial.column(name)[i]);
                    high = std::max(high, trial.column(name)[i]);
                }
            }
            sum += (high - low) / 3;
        }
        return sum;
    };
    const double near = height_of("near", length / group + 4 * period), far = height_of("far", arrival + 4 * period);
    const std::string name = fmt::format("{} cells to the height", per_height);
    report.judge({name + ": height one length from the inlet over H", "-", {}, 1.0, {}}, near / height, Relative{0.05});
    report.judge_below({name + ": loss of height over ten lengths", "-", {}, 0.0, {}}, 1 - far / near, 0.02);
    trial.report_books(report);
    Plot plot{"Surface one and eleven lengths from the inlet", "", {"t/T", false}, {"elevation/H", false}, {}, false};
    for (const char* place : {"near", "far"}) {
        Curve curve{place, {}, {}, CurveStyle::line, place[0] == 'n' ? 0 : 1};
        for (std::size_t i = 0; i < trial.time().size(); ++i) {
            curve.x.push_back(trial.time()[i] / period);
            curve.y.push_back(trial.column(place)[i] / height);
        }
        plot.curves.push_back(std::move(curve));
    }
    write_plot(setting, "wave_propagation", plot);
}

void run_up(const CaseSetting& setting, CaseReport& report) {
    // [Synolakis1987]: a solitary wave of H/d = 0.0185 on a slope of 1:19.85; R/d = 2.831 sqrt(cot b) (H/d)^1.25.
    const double d = 0.3, ratio = 0.0185, cot = 19.85, toe = 8 * d,
                 exact = 2.831 * std::sqrt(cot) * std::pow(ratio, 1.25);
    const double h = d / (setting.is_full ? 60 : 40), top = 1.2 * d, end = toe + cot * top;
    GridSettings settings =
        make_tank({}, {end, top, 0.1}, {static_cast<int>(end / (4 * h)), static_cast<int>(std::lround(top / h)), 1});
    settings.side[3].kind = SideKind::open;
    const wave::SteadyWave wave = wave::solitary_wave(ratio * d, d, 9.81);
    const double start = 16 * d / wave.celerity;
    settings.side[0] = wave_side(settings.mesh, 0, 1, 0, d, waves_of(wave, start), false);
    coupling::GridBody slope;
    slope.parts.push_back({{{toe, -1, -1},
                            {end + 1, -1, -1},
                            {end + 1, (end + 1 - toe) / cot, -1},
                            {toe, 0, -1},
                            {toe, -1, 1},
                            {end + 1, -1, 1},
                            {end + 1, (end + 1 - toe) / cot, 1},
                            {toe, 0, 1}},
                           {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
                           {}});
    GridState state = make_state(settings, [=](const Vec3& x) { return x.y < d; });
    GridTrial trial(settings, state);
    const coupling::CutBodies cut = coupling::cut_bodies(settings.mesh, {slope});
    set_open_shares(settings, trial.state(), trial.scratch(), cut.open);
    trial.add("reach", [=](const GridTrial& t) {  // highest place on the slope that is wet
        double reach = 0;
        const Mesh& mesh = t.settings().mesh;
        for (int i = mesh.box.cells[0] - 1; i >= 0; --i) {
            const double x = mesh.centre(0, i), bed = std::max(0.0, (x - toe) / cot);
            const int j = mesh.cell_at(1, bed);
            double depth = 0;
            for (int k = j; k < mesh.box.cells[1]; ++k) {
                const auto c = at(mesh.box.index(i, k, 0));
                depth += t.state().fraction[c] * t.scratch().open.volume[c] * mesh.h(1, k);
            }
            if (depth > 0.1 * h) {
                reach = bed + depth;
                break;
            }
        }
        return reach - d;
    });
    trial.run(start + 60 * d / wave.celerity);
    report.judge({"run-up over the depth", "-", {}, exact, {}}, crest_of(trial, "reach").level / d, Relative{0.08});
    trial.report_books(report);
}

}  // namespace riprap::validation::grid
