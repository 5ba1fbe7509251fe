// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "riprap/core/vec3.hpp"
#include "riprap/core/wide.hpp"

// Sums of add_springs() over the contact points of two blocks. T is linear in (1, r), so that what points of one
// stiffness N amount to is the product of the numbers of N by those of
//
//     S_cd = sum of (1, r_a)_c (1, r_b)_d,      c, d = 0, 1, 2, 3,
//
// 96 products where the block of the matrix has 144 numbers, and 16 multiplications a point.

namespace riprap::solid::implicit_dda {

/// A symmetric stiffness N of a contact point: xx, yy, zz, xy, yz, zx [N/m].
using PointStiffness = std::array<double, 6>;
/// Number of entry (i, j) in it.
constexpr std::size_t stiffness_place(std::size_t i, std::size_t j) {
    return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5;
}

using Four = Wide<double, 4>;
/// (1, r)
inline Four with_one(const Vec3& r) {
    const double numbers[4]{1, r.x, r.y, r.z};
    return Four::load(numbers);
}

/// S of contact points of one stiffness [-, m, m^2].
struct ArmSum {
    Four column[4]{};  ///< number c of column d is S_cd

    void add(const Four& left, const Vec3& right) {
        column[0] += left;
        column[1] += right.x * left;
        column[2] += right.y * left;
        column[3] += right.z * left;
    }
};

/// N_k S_cd of the points that two blocks meet at.
struct SharedSprings {
    std::array<double, 96> value{};  ///< k, then d, then c

    void add(const PointStiffness& n, const ArmSum& arms) {
        for (std::size_t k = 0; k < 6; ++k) {
            for (std::size_t d = 0; d < 4; ++d) {
                double* const to = &value[16 * k + 4 * d];
                (Four::load(to) + n[k] * arms.column[d]).store(to);
            }
        }
    }
};

/// The same where both blocks are one: S is symmetric.
struct OwnSprings {
    std::array<double, 60> value{};  ///< k, then S_00, S_10, S_20, S_30, S_11, S_21, S_31, S_22, S_32, S_33

    void add(const PointStiffness& n, const ArmSum& arms) {
        double s[16];
        for (std::size_t d = 0; d < 4; ++d) {
            arms.column[d].store(s + 4 * d);
        }
        const double lower[10]{s[0], s[1], s[2], s[3], s[5], s[6], s[7], s[10], s[11], s[15]};
        for (std::size_t k = 0; k < 6; ++k) {
            for (std::size_t l = 0; l < 10; l += 2) {
                using Two = Wide<double, 2>;
                double* const to = &value[10 * k + l];
                (Two::load(to) + n[k] * Two::load(lower + l)).store(to);
            }
        }
    }
};

/// Writes the 12 x 12 numbers of a sum, by columns in the unknowns, and their transpose.
void write_blocks(const SharedSprings& sum, double* block, double* transpose);
/// Writes those of a sum over one block, which are symmetric.
void write_block(const OwnSprings& sum, double* block);

}  // namespace riprap::solid::implicit_dda
