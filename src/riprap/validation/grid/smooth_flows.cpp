// SPDX-License-Identifier: Apache-2.0
// Viscous flows of one fluid against exact solutions and against [Ghia1982].
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

namespace {

/// u on the vertical middle line of the cavity at Re = 400 and 1000 [Ghia1982, table I].
struct CavityRow {
    double y;
    std::array<double, 2> u;
};
constexpr std::array<CavityRow, 8> cavity_rows{{{0.0625, {-0.09266, -0.20196}},
                                                {0.1719, {-0.24299, -0.38289}},
                                                {0.2813, {-0.32726, -0.27805}},
                                                {0.4531, {-0.17119, -0.10648}},
                                                {0.6172, {0.02135, 0.05702}},
                                                {0.7344, {0.16256, 0.18719}},
                                                {0.8516, {0.29093, 0.33304}},
                                                {0.9609, {0.61756, 0.51117}}}};

/// Edges whose cells are 1 - share to 1 + share times as wide as their mean.
std::vector<double> graded_edges(double low, double high, int cells, double share) {
    std::vector<double> edges = uniform_edges(low, high, cells);
    for (std::size_t i = 1; i + 1 < edges.size(); ++i) {
        const double turn = 2 * M_PI * static_cast<double>(i) / cells;
        edges[i] -= share * (high - low) / (2 * M_PI) * std::sin(turn);
    }
    return edges;
}

GridSettings one_fluid(const Vec3& size, const std::array<int, 3>& cells, double viscosity) {
    GridSettings settings = make_tank({}, size, cells);
    settings.has_surface = false;
    settings.gravity = {};
    settings.water = {1, viscosity};
    return settings;
}
GridState at_rest(const GridSettings& settings) {
    return make_state(
        settings, [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3{}; });
}

constexpr double gap = 1e-3, viscosity = 1e-6, body_force = 1e-4, plate_speed = 1.25e-5;

double poiseuille_speed(double y, double t) {
    double u = body_force / (2 * viscosity) * y * (gap - y);
    for (int n = 1; n < 200; n += 2) {
        const double k = n * M_PI / gap;
        u -= 4 * body_force * gap * gap / (viscosity * std::pow(n * M_PI, 3)) * std::sin(k * y) *
             std::exp(-k * k * viscosity * t);
    }
    return u;
}
double couette_speed(double y, double t) {
    double u = plate_speed * y / gap;
    for (int n = 1; n < 200; ++n) {
        const double k = n * M_PI / gap;
        u += 2 * plate_speed / (n * M_PI) * (n % 2 == 0 ? 1 : -1) * std::sin(k * y) * std::exp(-k * k * viscosity * t);
    }
    return u;
}

void between_plates(CaseReport& report, bool is_driven, double (*exact)(double, double)) {
    double before = 0;
    for (const int n : {12, 25, 50}) {
        GridSettings settings = one_fluid({gap, gap, gap}, {2, n, 1}, viscosity);
        settings.water.density = 1000;
        settings.side[0].kind = settings.side[1].kind = SideKind::open;
        settings.side[0].is_from_rest = settings.side[1].is_from_rest = false;  // plates without end
        settings.side[2].kind = settings.side[3].kind = SideKind::no_slip;
        if (is_driven) {
            settings.gravity = {body_force, 0, 0};
        } else {
            settings.side[3].velocity = {plate_speed, 0, 0};
        }
        GridTrial trial(settings, at_rest(settings));
        double error = 0;
        for (const double moment : {0.0225, 0.045, 0.1125, 0.225}) {
            trial.run(moment);
            double largest = 0, difference = 0;
            for (int j = 0; j < n; ++j) {
                const double y = settings.mesh.centre(1, j);
                const double u = trial.state().velocity[0][at(settings.mesh.box.index(1, j, 0))];
                largest = std::max(largest, std::abs(exact(y, moment)));
                difference = std::max(difference, std::abs(u - exact(y, moment)));
            }
            error = difference / largest;
            if (n == 50) {
                report.judge({fmt::format("speed in the middle at {} s, 50 cells", moment),
                              "m/s",
                              {},
                              exact(0.5 * gap, moment),
                              {}},
                             read_velocity(settings, trial.state(), {0.5 * gap, 0.5 * gap, 0}).x, Relative{1e-3});
            }
        }
        if (before > 0) {
            report.state({fmt::format("order from the last resolution to {} cells (error {:.2g})", n, error)},
                         std::log(before / error) / std::log(n > 40 ? 2.0 : 25.0 / 12));
        }
        before = error;
    }
}

}  // namespace

void cavity(const CaseSetting& setting, CaseReport& report) {
    const std::array<double, 2> reynolds{400, 1000};
    Plot plot{"Lid-driven cavity", "lines: Riprap; marks: Ghia and others", {"u/U", false}, {"y/L", false}, {}, false};
    for (std::size_t r = 0; r < reynolds.size(); ++r) {
        // narrow cells beside the walls, where layers are thin
        const int n = setting.is_full ? 128 : r == 1 ? 80 : 64;
        GridSettings settings = one_fluid({1, 1, 1}, {n, n, 1}, 1 / reynolds[r]);
        const std::vector<double> edges = graded_edges(0, 1, n, 0.5);
        settings.mesh = Mesh({edges, edges, {0, 1}}, 2);
        for (int side = 0; side < 4; ++side) {
            settings.side[at(side)].kind = SideKind::no_slip;
        }
        settings.side[3].velocity = {1, 0, 0};
        GridTrial trial(settings, at_rest(settings));
        trial.run(setting.is_full ? 60 : r == 0 ? 40 : 50);
        double worst = 0;
        Curve theirs{"", {}, {}, CurveStyle::markers, static_cast<int>(r)};
        for (const CavityRow& row : cavity_rows) {
            const double u = read_velocity(settings, trial.state(), {0.5, row.y, 0.5}).x;
            worst = std::max(worst, std::abs(u - row.u[r]));
            theirs.x.push_back(row.u[r]);
            theirs.y.push_back(row.y);
        }
        Curve ours{fmt::format("Re = {}", reynolds[r]), {}, {}, CurveStyle::line, static_cast<int>(r)};
        for (int j = 0; j < n; ++j) {
            ours.y.push_back(settings.mesh.centre(1, j));
            ours.x.push_back(read_velocity(settings, trial.state(), {0.5, ours.y.back(), 0.5}).x);
        }
        plot.curves.push_back(ours);
        plot.curves.push_back(theirs);
        report.judge_below(
            {fmt::format("Re = {}, {} x {} cells: largest error of u on the middle line over U", reynolds[r], n, n),
             "-",
             {},
             0.0,
             {}},
            worst, 0.01);
        trial.report_books(report);
    }
    write_plot(setting, "cavity", plot);
}

void poiseuille(const CaseSetting& setting, CaseReport& report) {
    (void)setting;
    between_plates(report, true, poiseuille_speed);
}

void couette(const CaseSetting& setting, CaseReport& report) {
    (void)setting;
    between_plates(report, false, couette_speed);
}

namespace {

/// Velocity of the flow behind a row of bars at Re = 40, wave length 1 [Kovasznay1948].
Vec3 kovasznay_velocity(const Vec3& x) {
    const double rate = 20 - std::sqrt(400 + 4 * M_PI * M_PI), decay = std::exp(rate * x.x);
    return {1 - decay * std::cos(2 * M_PI * x.y), rate / (2 * M_PI) * decay * std::sin(2 * M_PI * x.y), 0};
}

/// Error of the steady flow on n cells to the wave length, rms over the faces across x.
double kovasznay_error(int n, double share) {
    GridSettings settings = one_fluid({1, 1, 1}, {4, 4, 1}, 1.0 / 40);
    settings.mesh = Mesh({graded_edges(-0.5, 1, 3 * n / 2, share), graded_edges(-0.5, 0.5, n, share), {0, 1}}, 2);
    settings.outer_corrections = 2;  // steady states do not depend on the step
    for (const std::size_t side : {0U, 1U}) {
        settings.side[side].kind = SideKind::inflow;
        settings.side[side].inflow = [](const Vec3& x, double) { return Inflow{kovasznay_velocity(x), 1}; };
    }
    GridTrial trial(settings, make_state(
                                  settings, [](const Vec3&) { return 1.0; }, kovasznay_velocity));
    trial.run(5);
    double square = 0, count = 0;
    for_faces(settings.mesh.box, 0, [&](std::int64_t f, int i, int j, int) {
        const Vec3 place{settings.mesh.edge[0][at(i)], settings.mesh.centre(1, j), 0};
        square += std::pow(trial.state().velocity[0][at(f)] - kovasznay_velocity(place).x, 2);
        count += 1;
    });
    return std::sqrt(square / count);
}

}  // namespace

void kovasznay(const CaseSetting& setting, CaseReport& report) {
    const std::array<int, 3> cells = setting.is_full ? std::array{24, 48, 96} : std::array{12, 24, 48};
    for (const double share : {0.0, 0.4}) {
        std::array<double, 3> errors{};
        for (std::size_t i = 0; i < 3; ++i) {
            errors[i] = kovasznay_error(cells[i], share);
        }
        const std::string name = share > 0 ? "cells of 0.6 to 1.4 times their mean" : "equal cells";
        report.judge({fmt::format("{}: order from {} to {} cells (errors {:.3g}, {:.3g}, {:.3g})", name, cells[1],
                                  cells[2], errors[0], errors[1], errors[2]),
                      "-",
                      {},
                      2.0,
                      {}},
                     std::log2(errors[1] / errors[2]), 1.8, 10);
    }
}

namespace {

/// Cells of the vortex between slip walls, x and y from 0 to pi: rms error of u at the end on n x n cells.
double vortex_error(int n, double nu, double end) {
    GridSettings settings = one_fluid({M_PI, M_PI, 1}, {n, n, 1}, nu);
    settings.outer_corrections = 2;
    settings.longest_step = 0.2 * M_PI / n;
    GridTrial trial(settings, make_state(
                                  settings, [](const Vec3&) { return 1.0; },
                                  [](const Vec3& x) {
                                      return Vec3{std::sin(x.x) * std::cos(x.y), -std::cos(x.x) * std::sin(x.y), 0};
                                  }));
    trial.run(end);
    double square = 0, count = 0;
    for_faces(settings.mesh.box, 0, [&](std::int64_t f, int i, int j, int) {
        const double exact =
            std::exp(-2 * nu * end) * std::sin(settings.mesh.edge[0][at(i)]) * std::cos(settings.mesh.centre(1, j));
        square += std::pow(trial.state().velocity[0][at(f)] - exact, 2);
        count += 1;
    });
    return std::sqrt(square / count);
}

std::array<double, 3> vortex_errors(const std::array<int, 3>& cells, double nu, double end) {
    return {vortex_error(cells[0], nu, end), vortex_error(cells[1], nu, end), vortex_error(cells[2], nu, end)};
}

void judge_order(CaseReport& report, const std::string& name, const std::array<double, 3>& errors) {
    report.judge(
        {fmt::format("{} (errors {:.3g}, {:.3g}, {:.3g})", name, errors[0], errors[1], errors[2]), "-", {}, 2.0, {}},
        std::log2(errors[1] / errors[2]), 1.8, 10);
}

}  // namespace

void taylor_green(const CaseSetting& setting, CaseReport& report) {
    const double end = 2, nu = 2 * M_PI / 100;  // Re = U L/nu = 100 with L = 2 pi
    const std::array<int, 3> cells = setting.is_full ? std::array{32, 64, 128} : std::array{16, 32, 64};
    const std::array<double, 3> errors = vortex_errors(cells, nu, end);
    report.judge_below({fmt::format("rms error of u at t = 2, {} x {} cells", cells[2], cells[2]), "-", {}, 0.0, {}},
                       errors[2], 1e-3);
    judge_order(report, "order of convergence", errors);
    report.state({"the same over two halvings", "-", ""}, 0.5 * std::log2(errors[0] / errors[2]));
    // Viscosity lets the vortex live too long, transport lets it die too soon: at Re = 100 both cancel at 32 cells.
    judge_order(report, "order of transport, without viscosity", vortex_errors(cells, 0, end));
    judge_order(report, "order of viscosity, Re = 10",
                vortex_errors({cells[0] / 2, cells[1] / 2, cells[2] / 2}, 10 * nu, end));
}

}  // namespace riprap::validation::grid
