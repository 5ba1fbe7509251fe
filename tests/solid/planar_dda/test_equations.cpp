// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "riprap/solid/planar_dda/equations.hpp"

namespace riprap::solid::planar_dda {
namespace {

/// Blocks in a square, each tied to those beside it by springs of random directions.
struct Heap {
    static constexpr std::int32_t side = 9, count = side * side;
    std::vector<std::pair<std::int32_t, std::int32_t>> couplings;
    std::vector<Unknowns> right{count}, solution{count};

    Heap() {
        for (std::int32_t i = 0; i < count; ++i) {
            for (const std::int32_t j : {i + 1, i + side}) {
                if (j < count) {
                    couplings.emplace_back(i, j);
                }
            }
            for (std::size_t k = 0; k < 6; ++k) {
                right[static_cast<std::size_t>(i)][k] = std::sin(6.0 * i + static_cast<double>(k));
            }
        }
    }
    /// @param inertia  on the diagonal; springs have a stiffness of 1
    std::int32_t solve(Way way, double inertia) {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> number(-1, 1);
        Equations equations;
        equations.set_pattern(count, couplings, way);
        equations.set_zero();
        for (std::int32_t i = 0; i < count; ++i) {
            Block6 diagonal{};
            for (std::size_t k = 0; k < 6; ++k) {
                diagonal[7 * k] = inertia;
            }
            equations.add_diagonal(i, diagonal);
        }
        for (const auto& [i, j] : couplings) {
            Unknowns u, v;
            for (std::size_t k = 0; k < 6; ++k) {
                u[k] = number(random);
                v[k] = number(random);
            }
            equations.add_outer(i, i, 1, u, u);
            equations.add_outer(j, j, 1, v, v);
            equations.add_outer(i, j, 1, u, v);
        }
        if (const std::int32_t row = equations.prepare(); row >= 0) {
            return row;
        }
        std::fill(solution.begin(), solution.end(), Unknowns{});
        return equations.solve(right, solution);
    }
};

TEST(PlanarDdaEquations, BothWaysFindTheSameSolution) {
    // Heavy blocks; and springs so stiff that conjugate gradients give up and factors are made after all.
    for (const double inertia : {1.0, 1e-11}) {
        Heap direct, iterative;
        ASSERT_EQ(direct.solve(Way::direct, inertia), -1);
        ASSERT_EQ(iterative.solve(Way::iterative, inertia), -1);
        double size = 0, off = 0;
        for (std::size_t i = 0; i < direct.solution.size(); ++i) {
            for (std::size_t k = 0; k < 6; ++k) {
                size = std::max(size, std::abs(direct.solution[i][k]));
                off = std::max(off, std::abs(direct.solution[i][k] - iterative.solution[i][k]));
            }
        }
        EXPECT_LT(off, 1e-10 * size) << inertia;
    }
}

TEST(PlanarDdaEquations, ARowWithoutStiffnessIsNamedByBothWays) {
    for (const Way way : {Way::direct, Way::iterative}) {
        Equations equations;
        equations.set_pattern(2, {}, way);
        equations.set_zero();
        Block6 one{};
        for (std::size_t k = 0; k < 6; ++k) {
            one[7 * k] = 1;
        }
        equations.add_diagonal(0, one);
        EXPECT_EQ(equations.prepare(), 1);
    }
}

}  // namespace
}  // namespace riprap::solid::planar_dda
