// SPDX-License-Identifier: Apache-2.0
// Output fields and contacts of blocks.
#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/piece_books.hpp"

namespace riprap::solid {

using geometry::Vec2;
using planar_dda::Mode;

std::span<const ShownField> PlanarDda::shown() {
    static constexpr std::array table{
        ShownField{"stress_xx", "Pa", "of the Cauchy stress of the block, tension positive, world axes"},
        ShownField{"stress_yy", "Pa", "likewise"},
        ShownField{"stress_xy", "Pa", "likewise"},
        ShownField{"von_mises", "Pa", "von Mises' stress of the stresses in the plane"},
        ShownField{"strain_xx", "-", "of the strain (F F^T - I)/2 of the block, world axes"},
        ShownField{"strain_yy", "-", "likewise"},
        ShownField{"strain_xy", "-", "likewise"},
    };
    return table;
}

double PlanarDda::show(const body::BodyState& /*bodies*/, const Fields& fields, std::size_t body, std::size_t field) {
    const planar_dda::State& s = fields.blocks;
    const double x = s.stress_x[body], y = s.stress_y[body], xy = s.stress_xy[body];
    const auto block = static_cast<std::int32_t>(body);
    const Vec2 a = offset_of(s, block, {1, 0}), b = offset_of(s, block, {0, 1});  // columns of F
    switch (field) {
        case 0:
            return x;
        case 1:
            return y;
        case 2:
            return xy;
        case 3:
            return std::sqrt(x * x - x * y + y * y + 3 * xy * xy);
        case 4:
            return 0.5 * (a.x * a.x + b.x * b.x - 1);
        case 5:
            return 0.5 * (a.y * a.y + b.y * b.y - 1);
        default:
            return 0.5 * (a.x * a.y + b.x * b.y);
    }
}

std::vector<contact::ShownContact> PlanarDda::contacts(const SolidScene& /*scene*/, const Settings& /*settings*/,
                                                       const Fields& /*fields*/, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    const planar_dda::Scratch& engine = scratch.engine;
    for (std::size_t k = 0; k < engine.contacts.size(); ++k) {
        const planar_dda::Contact& c = engine.contacts[k];
        const planar_dda::Trial& trial = engine.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        const Vec3 away{c.gap.a[0], c.gap.a[1], 0}, along{c.slip.a[0], c.slip.a[1], 0};
        shown.push_back(contact::shown_contact(BodyId{c.a}, BodyId{c.b}, {c.place.x, c.place.y, 0},
                                               trial.normal * away + shear_of(c, trial) * along, -1.0 * away));
        shown.back().overlap = std::max(0.0, -trial.gap);
        shown.back().is_sliding = trial.mode == Mode::sliding;
    }
    return shown;
}

}  // namespace riprap::solid
