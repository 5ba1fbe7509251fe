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

TEST(PlanarDdaEquations, FactorsOfASquareStaySparseWhateverTheOrderOfItsRows) {
    // 24 x 24 rows scattered over their numbers: inside an envelope they need 24 blocks a row.
    constexpr std::int32_t side = 24, count = side * side;
    const auto number = [](std::int32_t i) { return i * 5 % count; };
    std::vector<std::pair<std::int32_t, std::int32_t>> couplings;
    for (std::int32_t i = 0; i < count; ++i) {
        if (i % side + 1 < side) {
            couplings.emplace_back(number(i), number(i + 1));
        }
        if (i + side < count) {
            couplings.emplace_back(number(i + side), number(i));
        }
    }
    BlockCholesky factors;
    factors.set_pattern(count, couplings);
    EXPECT_LT(factors.stored_blocks(), side * count / 2);
    EXPECT_GE(factors.stored_blocks(), count + static_cast<std::int64_t>(couplings.size()));
}

TEST(PlanarDdaEquations, AnotherPatternIsTakenAfterwards) {
    // Three rows in a chain, then the same three with the first and the last coupled: K x = b of known x.
    const std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> patterns{
        {{0, 1}, {1, 2}}, {{2, 0}, {0, 1}, {1, 2}}, {{0, 1}}};
    Equations equations;
    for (const auto& couplings : patterns) {
        equations.set_pattern(3, couplings, Way::direct);
        equations.set_zero();
        Block6 four{};
        for (std::size_t k = 0; k < 6; ++k) {
            four[7 * k] = 4;
        }
        std::vector<Unknowns> x(3), b(3);
        for (std::int32_t row = 0; row < 3; ++row) {
            equations.add_diagonal(row, four);
            for (std::size_t k = 0; k < 6; ++k) {
                b[static_cast<std::size_t>(row)][k] = 4.0 * (row + 1);
            }
        }
        for (const auto& [i, j] : couplings) {
            for (std::size_t k = 0; k < 6; ++k) {
                Unknowns unit{};
                unit[k] = 1;
                equations.add_outer(i, j, -1, unit, unit);
                b[static_cast<std::size_t>(i)][k] -= j + 1;
                b[static_cast<std::size_t>(j)][k] -= i + 1;
            }
        }
        ASSERT_EQ(equations.prepare(), -1);
        ASSERT_EQ(equations.solve(b, x), -1);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t k = 0; k < 6; ++k) {
                EXPECT_NEAR(x[row][k], static_cast<double>(row + 1), 1e-14);
            }
        }
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
