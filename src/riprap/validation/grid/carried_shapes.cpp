// SPDX-License-Identifier: Apache-2.0
// Water carried by a given velocity: the slotted disc of [Zalesak1979] and the vortex of [Rider1998].
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

namespace {

using Stream = double (*)(double x, double y, double t);

struct Outcome {
    double change;  ///< sum of |change of the fraction| times the area [m^2]
    double area, volume_error, beyond;
};

Outcome carry(int n, VofScheme scheme, const std::function<bool(const Vec3&)>& shape, double end, int steps,
              Stream psi) {
    GridSettings settings = make_tank({}, {1, 1, 1.0 / n}, {n, n, 1});
    settings.vof = scheme;
    GridState state = make_state(settings, shape);
    GridScratch scratch;
    prepare(settings, state, scratch);
    const std::vector<double> before = state.fraction;
    const double volume = water_volume(settings, state, scratch), dt = end / steps, h = 1.0 / n;
    double beyond = 0;
    for (int step = 0; step < steps; ++step) {
        const double t = (step + 0.5) * dt;
        for (int a = 0; a < 2; ++a) {
            for_faces(settings.mesh.box, a, [&](std::int64_t f, int i, int j, int) {
                const double x = i * h, y = j * h;
                const bool on_rim = (a == 0 ? i : j) % n == 0;
                scratch.start.carrier[at(a)][at(f)] = on_rim   ? 0
                                                      : a == 0 ? (psi(x, y + h, t) - psi(x, y, t)) / h
                                                               : -(psi(x + h, y, t) - psi(x, y, t)) / h;
            });
        }
        move_water(settings, state, scratch, dt);
        state.step += 1;
        for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
            beyond = std::max({beyond, -state.fraction[at(c)], state.fraction[at(c)] - 1});
        });
    }
    Outcome outcome{0, 0, water_volume(settings, state, scratch) / volume - 1, beyond};
    for_cells(settings.mesh.box, [&](std::int64_t c, int, int, int) {
        outcome.change += std::abs(state.fraction[at(c)] - before[at(c)]) * h * h;
        outcome.area += before[at(c)] * h * h;
    });
    return outcome;
}

void report_bounds(CaseReport& report, const Outcome& outcome) {
    report.judge_below({"error of the volume", "-", {}, 0.0, {}, Kind::bookkeeping}, outcome.volume_error, 1e-12);
    report.judge_below({"fraction of water, farthest beyond 0 and 1", "-", {}, 0.0, {}, Kind::bookkeeping},
                       outcome.beyond, 1e-12);
}

}  // namespace

void slotted_disc(const CaseSetting& setting, CaseReport& report) {
    (void)setting;
    const auto shape = [](const Vec3& x) {
        return std::hypot(x.x - 0.5, x.y - 0.75) < 0.15 && !(std::abs(x.x - 0.5) < 0.025 && x.y < 0.85);
    };
    const Stream turn = [](double x, double y, double) {
        return -M_PI * (std::pow(x - 0.5, 2) + std::pow(y - 0.5, 2));
    };
    const Outcome planes = carry(100, VofScheme::plic, shape, 1, 1000, turn);
    report.judge_below({"change of the shape over a turn over its area, 100 x 100 cells", "-", {}, 0.0, {}},
                       planes.change / planes.area, 0.02);
    report_bounds(report, planes);
    const Outcome algebraic = carry(100, VofScheme::compressive, shape, 1, 1000, turn);
    report.state({"the same with the compressive scheme"}, algebraic.change / algebraic.area);
    report_bounds(report, algebraic);
}

void vortex(const CaseSetting& setting, CaseReport& report) {
    const auto shape = [](const Vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.75) < 0.15; };
    const Stream turn = [](double x, double y, double t) {
        return -std::pow(std::sin(M_PI * x) * std::sin(M_PI * y), 2) / M_PI * std::cos(M_PI * t / 8);
    };
    double before = 0;
    for (const int n : setting.is_full ? std::vector{64, 128, 256} : std::vector{64, 128}) {
        const Outcome outcome = carry(n, VofScheme::plic, shape, 8, 20 * n, turn);
        if (n == 128) {
            report.judge_below(
                {"change of the shape over the area of the domain, T = 8, 128 x 128 cells", "-", {}, 0.0, {}},
                outcome.change, 2e-3);
        }
        if (before > 0) {
            report.state({fmt::format("order from {} to {} cells", n / 2, n)}, std::log2(before / outcome.change));
        }
        before = outcome.change;
        report_bounds(report, outcome);
    }
}

}  // namespace riprap::validation::grid
