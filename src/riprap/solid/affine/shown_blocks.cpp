// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/shown_blocks.hpp"

#include <array>
#include <cmath>

namespace riprap::solid::affine {

namespace {

struct Place {
    int row, column;
};
constexpr std::array<Place, 6> components{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

double von_mises(const Mat3& stress) {
    const double mean = (stress(0, 0) + stress(1, 1) + stress(2, 2)) / 3;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double s = stress(i, j) - (i == j ? mean : 0);
            sum += s * s;
        }
    }
    return std::sqrt(1.5 * sum);
}

}  // namespace

std::span<const ShownField> shown_of_blocks() {
    static constexpr std::array table{
        ShownField{"stress_xx", "Pa", "of the Cauchy stress of the block, tension positive, world axes"},
        ShownField{"stress_yy", "Pa", "likewise"},
        ShownField{"stress_zz", "Pa", "likewise"},
        ShownField{"stress_xy", "Pa", "likewise"},
        ShownField{"stress_yz", "Pa", "likewise"},
        ShownField{"stress_zx", "Pa", "likewise"},
        ShownField{"von_mises", "Pa", "von Mises' stress of the block"},
        ShownField{"strain_xx", "-", "of the strain (F F^T - I)/2 of the block, world axes"},
        ShownField{"strain_yy", "-", "likewise"},
        ShownField{"strain_zz", "-", "likewise"},
        ShownField{"strain_xy", "-", "likewise"},
        ShownField{"strain_yz", "-", "likewise"},
        ShownField{"strain_zx", "-", "likewise"},
    };
    return table;
}

double show_block(const BlockState& blocks, std::size_t block, std::size_t field) {
    const std::size_t count = components.size();
    if (field <= count) {
        const Mat3 stress = rows_at(blocks.stress, block);
        return field == count ? von_mises(stress) : stress(components[field].row, components[field].column);
    }
    const Place at = components[field - count - 1];
    const Mat3 f = rows_at(blocks.deformation, block);
    const Mat3 strain = f * transpose(f);
    return 0.5 * (strain(at.row, at.column) - (at.row == at.column ? 1 : 0));
}

}  // namespace riprap::solid::affine
