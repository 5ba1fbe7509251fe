// SPDX-License-Identifier: Apache-2.0
// Sums over contact points, and the equations that they make, against the sub-matrices one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "riprap/core/index.hpp"
#include "riprap/solid/implicit_dda/system.hpp"

namespace riprap::solid::implicit_dda {
namespace {

const Vec3 arm_a{0.3, -0.2, 0.5}, arm_b{-0.4, 0.1, -0.3};
const Mat3 soft{{{2, 0.3, -0.2}, {0.3, 3, 0.4}, {-0.2, 0.4, 5}}}, hard{{{7, -1, 0.5}, {-1, 4, 0}, {0.5, 0, 1}}};
PointStiffness numbers_of(const Mat3& n) { return {n(0, 0), n(1, 1), n(2, 2), n(0, 1), n(1, 2), n(2, 0)}; }

TEST(SpringSums, springs_between_two_blocks_are_those_of_the_displacement_matrix) {
    Matrix12 plain{}, block{}, transpose{};
    add_springs(displacement_matrix(arm_a), displacement_matrix(arm_b), soft, 1, plain.data());
    add_springs(displacement_matrix(arm_b), displacement_matrix(arm_a), hard, 1, plain.data());
    SharedSprings sum;
    for (const auto& [left, right, n] : {std::tuple{arm_a, arm_b, soft}, std::tuple{arm_b, arm_a, hard}}) {
        ArmSum arms;
        arms.add(with_one(left), right);
        sum.add(numbers_of(n), arms);
    }
    write_blocks(sum, block.data(), transpose.data());
    for (std::size_t c = 0; c < 12; ++c) {
        for (std::size_t r = 0; r < 12; ++r) {
            EXPECT_NEAR(block[12 * c + r], plain[12 * c + r], 1e-14) << r << " " << c;
            EXPECT_EQ(transpose[12 * r + c], block[12 * c + r]) << r << " " << c;
        }
    }
}

TEST(SpringSums, springs_of_one_block_are_those_of_the_displacement_matrix) {
    Matrix12 plain{}, block{};
    add_springs(displacement_matrix(arm_a), displacement_matrix(arm_a), soft, 1, plain.data());
    add_springs(displacement_matrix(arm_b), displacement_matrix(arm_b), soft, 1, plain.data());
    ArmSum arms;
    arms.add(with_one(arm_a), arm_a);
    arms.add(with_one(arm_b), arm_b);
    OwnSprings sum;
    sum.add(numbers_of(soft), arms);
    write_block(sum, block.data());
    for (std::size_t i = 0; i < 144; ++i) {
        EXPECT_NEAR(block[i], plain[i], 1e-14) << i;
    }
}

/// Three blocks, the third on what does not move: pairs of several points, locked, sliding and open ones among them.
std::vector<ContactTerm> some_contacts() {
    std::vector<ContactTerm> terms;
    double phase = 0;
    const auto wave = [&phase] { return std::sin(phase += 1.7); };
    const auto vector = [&] { return Vec3{wave(), wave(), wave()}; };
    for (const auto& [a, b, points] :
         {std::tuple{-1, 2, 3}, std::tuple{0, 1, 4}, std::tuple{0, 2, 2}, std::tuple{1, 2, 1}}) {
        const Vec3 normal = normalized(vector());
        for (int i = 0; i < points; ++i) {
            ContactTerm c{};
            c.row_a = a;
            c.row_b = b;
            c.arm_a = vector();
            c.arm_b = vector();
            c.normal = normal;
            c.gap = 0.01 * wave();
            c.springs = {50, 20, 0.4, 0, 0};
            c.trial.mode = i == 1 ? ContactMode::slide : i == 2 ? ContactMode::open : ContactMode::lock;
            c.trial.slip_before = 0.01 * cross(normal, vector());
            c.trial.friction = 0.3;
            c.trial.direction = normalized(cross(normal, vector()));
            c.trial.across = 13;
            terms.push_back(c);
        }
    }
    return terms;
}

Equations equations_of(const std::vector<ContactTerm>& terms) {
    Equations equations;
    Matrix12 inertia{};
    for (std::size_t i = 0; i < 12; ++i) {
        inertia[13 * i] = 100;
    }
    equations.diagonal.assign(3, inertia);
    equations.given.assign(3, Vector12{1, 2, 3});
    link_rows(3, terms, equations);
    assemble(terms, equations);
    return equations;
}

/// The matrix as 36 x 36 numbers, point by point.
std::vector<double> plain_matrix(const std::vector<ContactTerm>& terms) {
    std::vector<double> k(std::size_t{36} * 36, 0);
    for (std::size_t i = 0; i < 36; ++i) {
        k[37 * i] = 100;
    }
    for (const ContactTerm& c : terms) {
        if (c.trial.mode == ContactMode::open) {
            continue;
        }
        const Mat3 along = outer(c.normal, c.normal);
        const Vec3 across = cross(c.normal, c.trial.direction);
        const Mat3 n =
            c.springs.normal * along + (c.trial.mode == ContactMode::lock ? c.springs.shear * (Mat3::identity() - along)
                                                                          : c.trial.across * outer(across, across));
        const auto add = [&](std::int32_t row, const Vec3& arm, std::int32_t column, const Vec3& other, double factor) {
            Matrix12 block{};
            add_springs(displacement_matrix(arm), displacement_matrix(other), n, factor, block.data());
            for (std::size_t i = 0; row >= 0 && column >= 0 && i < 144; ++i) {
                k[36 * (12 * at(row) + i % 12) + 12 * at(column) + i / 12] += block[i];
            }
        };
        add(c.row_a, c.arm_a, c.row_a, c.arm_a, 1);
        add(c.row_a, c.arm_a, c.row_b, c.arm_b, -1);
        add(c.row_b, c.arm_b, c.row_a, c.arm_a, -1);
        add(c.row_b, c.arm_b, c.row_b, c.arm_b, 1);
    }
    return k;
}

double number_of(const Equations& equations, std::size_t row, std::size_t column) {
    const auto entry =
        equations.matrix.pattern().find(static_cast<std::int64_t>(row / 12), static_cast<std::int64_t>(column / 12));
    return entry < 0 ? 0 : equations.matrix.at(entry, static_cast<int>(row % 12), static_cast<int>(column % 12));
}

TEST(Assembly, the_matrix_is_the_sum_of_sub_matrices_of_all_points) {
    const std::vector<ContactTerm> terms = some_contacts();
    const Equations equations = equations_of(terms);
    const std::vector<double> plain = plain_matrix(terms);
    for (std::size_t i = 0; i < 36; ++i) {
        for (std::size_t j = 0; j < 36; ++j) {
            EXPECT_NEAR(number_of(equations, i, j), plain[36 * i + j], 1e-12) << i << " " << j;
        }
    }
}

TEST(Assembly, a_pair_that_changes_leaves_the_equations_of_a_fresh_start) {
    std::vector<ContactTerm> terms = some_contacts();
    Equations equations = equations_of(terms);
    for (const std::size_t pair : {std::size_t{1}, std::size_t{3}}) {
        const PairTerm& changed = equations.pairs[pair];
        for (std::int32_t i = changed.first; i < changed.end; ++i) {
            terms[at(i)].trial.mode = pair == 3 ? ContactMode::open : ContactMode::slide;
        }
        equations.is_stale[pair] = 1;
        std::fill(equations.is_new.begin(), equations.is_new.end(), std::uint8_t{0});
        assemble(terms, equations);
        EXPECT_EQ(equations.is_new[0], pair == 3 ? 0 : 1);  // the last pair is of rows 1 and 2
        const Equations fresh = equations_of(terms);
        EXPECT_EQ(equations.right, fresh.right);
        for (std::size_t i = 0; i < 36; ++i) {
            for (std::size_t j = 0; j < 36; ++j) {
                EXPECT_EQ(number_of(equations, i, j), number_of(fresh, i, j)) << i << " " << j;
            }
        }
    }
}

}  // namespace
}  // namespace riprap::solid::implicit_dda
