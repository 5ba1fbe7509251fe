// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <random>

#include "riprap/core/parallel.hpp"
#include "riprap/linear/multigrid.hpp"

namespace riprap::linear {
namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

template <class F>
void for_cells(const CellBox& box, const F& f) {
    for (int k = 0; k < box.cells[2]; ++k) {
        for (int j = 0; j < box.cells[1]; ++j) {
            for (int i = 0; i < box.cells[0]; ++i) {
                f(i, j, k, box.index(i, j, k));
            }
        }
    }
}

/// Conductances of a unit box, 1/density between the means of cells; open at the top, closed elsewhere.
/// @param depth_of  distance of a place from the surface, > 0 in water, with z upwards [-]
template <class Depth>
FaceConductance water_and_air(const std::array<int, 3>& cells, int axes, double ratio, const Depth& depth_of) {
    FaceConductance a(CellBox(cells, 2, axes));
    const int up = axes - 1;
    const auto density = [&](int i, int j, int k) {
        const double x = (i + 0.5) / cells[0], y = axes == 3 ? (j + 0.5) / cells[1] : 0;
        const double z = ((up == 1 ? j : k) + 0.5) / cells[at(up)], h = 1.0 / cells[at(up)];
        const double share = std::clamp(depth_of(x, y, z) / h + 0.5, 0.0, 1.0);
        return share * ratio + (1 - share);
    };
    for_cells(a.box, [&](int i, int j, int k, std::int64_t c) {
        const std::array<int, 3> place{i, j, k};
        for (int d = 0; d < axes; ++d) {
            std::array<int, 3> below = place;
            below[at(d)] -= 1;
            const double h = 1.0 / cells[at(d)], area = 1.0 / (cells[0] * double(cells[1]) * cells[2]) / h;
            if (place[at(d)] > 0) {
                const double mean = 0.5 * (density(i, j, k) + density(below[0], below[1], below[2]));
                a.face[at(d)][at(c)] = area / h / mean;
            }
            if (d == up && place[at(d)] == cells[at(d)] - 1) {
                a.face[at(d)][at(c + a.box.stride[at(d)])] = 2 * area / h / density(i, j, k);
            }
        }
    });
    return a;
}

/// Water below air under a wavy surface.
FaceConductance water_under_air(const std::array<int, 3>& cells, int axes, double ratio) {
    return water_and_air(cells, axes, ratio,
                         [](double x, double y, double z) { return 0.5 + 0.2 * std::sin(9 * x + 4 * y) - z; });
}

std::vector<double> random_field(const CellBox& box, unsigned seed) {
    std::vector<double> field(at(box.size), 0.0);
    std::mt19937 random(seed);
    for_cells(
        box, [&](int, int, int, std::int64_t c) { field[at(c)] = static_cast<double>(random()) / 4294967296.0 - 0.5; });
    return field;
}

TEST(Multigrid, solves_as_a_sparse_cholesky_factorisation_does) {
    for (const auto& cells : {std::array{13, 9, 1}, std::array{7, 6, 9}}) {
        const int axes = cells[2] > 1 ? 3 : 2;
        const FaceConductance a = water_under_air(cells, axes, 833);
        const CellBox& box = a.box;
        const std::vector<double> b = random_field(box, 5);
        std::vector<int> number(at(box.size), -1);
        int count = 0;
        for_cells(box, [&](int, int, int, std::int64_t c) { number[at(c)] = count++; });
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd right(count);
        for_cells(box, [&](int, int, int, std::int64_t c) {
            right[number[at(c)]] = b[at(c)];
            for (int d = 0; d < axes; ++d) {
                for (const int side : {0, 1}) {
                    const std::int64_t s = box.stride[at(d)], other = side == 0 ? c - s : c + s;
                    const double g = a.face[at(d)][at(side == 0 ? c : c + s)];
                    entries.emplace_back(number[at(c)], number[at(c)], g);
                    if (number[at(other)] >= 0) {
                        entries.emplace_back(number[at(c)], number[at(other)], -g);
                    }
                }
            }
        });
        Eigen::SparseMatrix<double> matrix(count, count);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::VectorXd exact = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
        PoissonSolver solver;
        solver.set_operator(a);
        std::vector<double> p(at(box.size), 0.0);
        EXPECT_TRUE(solver.solve(a, b, p, 1e-12, 100).converged);
        double worst = 0;
        for_cells(box, [&](int, int, int, std::int64_t c) {
            worst = std::max(worst, std::abs(p[at(c)] - exact[number[at(c)]]));
        });
        EXPECT_LT(worst, 1e-9 * exact.cwiseAbs().maxCoeff());
    }
}

TEST(Multigrid, takes_six_digits_off_white_noise_in_ten_iterations_at_a_density_ratio_of_833) {
    for (const auto& cells : {std::array{64, 64, 1}, std::array{128, 96, 1}, std::array{200, 50, 1},
                              std::array{32, 32, 32}, std::array{40, 24, 33}}) {
        const FaceConductance a = water_under_air(cells, cells[2] > 1 ? 3 : 2, 833);
        PoissonSolver solver;
        solver.set_operator(a);
        std::vector<double> p(at(a.box.size), 0.0);
        const PoissonReport report = solver.solve(a, random_field(a.box, 7), p, 1e-6, 50);
        EXPECT_LE(report.iterations, 10) << cells[0] << " x " << cells[1] << " x " << cells[2];
        EXPECT_TRUE(report.converged);
    }
}

// Story: coarse cells joined the air on both sides of a film thinner than they are. Where a wave folded over, each air
// pocket cost an iteration or two: 13 in place of 5 in the impact of a dam break on a wall.
TEST(Multigrid, sees_air_pockets_below_films_thinner_than_its_coarse_cells) {
    struct Pocket {
        double x, z, radius;
    };
    const std::array<Pocket, 6> pockets{{{0.2, 0.44, 0.12},
                                         {0.5, 0.5, 0.08},
                                         {0.64, 0.52, 0.06},
                                         {0.78, 0.47, 0.1},
                                         {0.4, 0.2, 0.05},
                                         {0.9, 0.2, 0.04}}};
    for (const bool is_plane : {true, false}) {
        const std::array<int, 3> cells = is_plane ? std::array{128, 128, 1} : std::array{48, 48, 48};
        const int axes = is_plane ? 2 : 3;
        const FaceConductance a = water_and_air(cells, axes, 833, [&](double x, double y, double z) {
            double depth = 0.6 - z;
            for (const Pocket& pocket : pockets) {
                depth =
                    std::min(depth, std::hypot(x - pocket.x, axes == 3 ? y - 0.5 : 0, z - pocket.z) - pocket.radius);
            }
            return depth;
        });
        PoissonSolver solver;
        solver.set_operator(a);
        std::vector<double> p(at(a.box.size), 0.0);
        const PoissonReport report = solver.solve(a, random_field(a.box, 7), p, 1e-6, 50);
        EXPECT_TRUE(report.converged);
        EXPECT_LE(report.iterations, is_plane ? 14 : 19);  // 19 and 21 by sums alone
    }
}

TEST(Multigrid, converges_as_fast_where_conductances_differ_by_a_hundred_between_axes) {
    for (const double ratio : {1.0, 10.0}) {
        FaceConductance a = water_under_air({96, 96, 1}, 2, 833);
        for (double& c : a.face[0]) {
            c /= ratio;
        }
        for (double& c : a.face[1]) {
            c *= ratio;
        }
        PoissonSolver solver;
        solver.set_operator(a);
        std::vector<double> p(at(a.box.size), 0.0);
        EXPECT_LE(solver.solve(a, random_field(a.box, 7), p, 1e-6, 50).iterations, 8) << ratio;
    }
}

TEST(Multigrid, as_a_preconditioner_is_symmetric) {
    const FaceConductance a = water_under_air({21, 14, 1}, 2, 833);
    Multigrid multigrid;
    multigrid.build(a);
    const std::vector<double> x = random_field(a.box, 1), y = random_field(a.box, 2);
    std::vector<double> mx(x.size()), my(x.size());
    multigrid.apply(x, mx);
    multigrid.apply(y, my);
    const double xy = dot_cells(a.box, y, mx), yx = dot_cells(a.box, x, my);
    EXPECT_NEAR(xy / yx, 1, 1e-4);  // single precision
}

TEST(Multigrid, closed_cells_keep_zero_and_a_closed_box_is_solved_up_to_a_constant) {
    FaceConductance a = water_under_air({24, 24, 1}, 2, 1);
    const CellBox& box = a.box;
    for (int i = 0; i < 24; ++i) {
        a.face[1][at(box.index(i, 24, 0))] = 0;
    }
    const std::int64_t solid = box.index(9, 9, 0);
    a.face[0][at(solid)] = a.face[0][at(solid + 1)] = 0;
    a.face[1][at(solid)] = a.face[1][at(solid + box.stride[1])] = 0;
    std::vector<double> b(at(box.size), 0.0), p(at(box.size), 0.0);
    b[at(box.index(2, 3, 0))] = 1;
    b[at(box.index(20, 13, 0))] = -1;
    PoissonSolver solver;
    solver.set_operator(a);
    EXPECT_TRUE(solver.solve(a, b, p, 1e-9, 50).converged);
    EXPECT_EQ(p[at(solid)], 0);
}

TEST(Multigrid, stops_at_the_round_off_of_cells_that_are_cut_off) {
    // The right-hand side of a closed box has a mean by round-off, which no pressure takes away.
    FaceConductance a = water_under_air({24, 24, 1}, 2, 1);
    for (int i = 0; i < 24; ++i) {
        a.face[1][at(a.box.index(i, 24, 0))] = 0;
    }
    std::vector<double> b = random_field(a.box, 3), p(at(a.box.size), 0.0);
    double mean = 0;
    for_cells(a.box, [&](int, int, int, std::int64_t c) { mean += b[at(c)] / (24 * 24); });
    for_cells(a.box, [&](int, int, int, std::int64_t c) { b[at(c)] += 1e-12 - mean; });
    PoissonSolver solver;
    solver.set_operator(a);
    EXPECT_LT(solver.solve(a, b, p, 1e-14, 2000).residual, 1e-6);
}

TEST(Multigrid, solves_with_the_same_bits_at_any_thread_count) {
    const FaceConductance a = water_under_air({150, 90, 1}, 2, 833);
    const std::vector<double> b = random_field(a.box, 7);
    std::vector<double> first;
    for (const int threads : {1, 2, 4}) {
        parallel::set_thread_count(threads);
        PoissonSolver solver;
        solver.set_operator(a);
        std::vector<double> p(at(a.box.size), 0.0);
        solver.solve(a, b, p, 1e-8, 50);
        if (first.empty()) {
            first = p;
        }
        EXPECT_EQ(first, p);
    }
    parallel::set_thread_count(1);
}

}  // namespace
}  // namespace riprap::linear
