// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "riprap/contact/contact_kinematics.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::contact {

/// Elastic contact with a dashpot along its normal, never tensile:
///
///     f_n = max(0, |F| + 2 xi sqrt(m_e K_n) v.n),   n from A to B.
struct NormalPush {
    Vec3 n;          ///< from A to B [-]
    Vec3 sliding;    ///< v - (v.n) n, v = v_A - v_B [m/s]
    double elastic;  ///< |F| [N]
    double force;    ///< f_n [N]
    double damping;  ///< 2 xi sqrt(m_e K_n) [N s/m]
};

inline NormalPush push_along_normal(const NormalContact& normal, const material::PairProperties& pair,
                                    const ContactKinematics& kinematics) {
    const double elastic = norm(normal.force);
    const Vec3 n = elastic > 0 ? -normal.force / elastic : Vec3{0, 0, 1};
    const double closing = dot(kinematics.relative_velocity, n);
    NormalPush push{n, kinematics.relative_velocity - closing * n, elastic, elastic, 0};
    if (pair.damping_ratio > 0) {
        push.damping = 2 * pair.damping_ratio * std::sqrt(kinematics.effective_mass * normal.stiffness);
        push.force = std::max(0.0, elastic + push.damping * closing);
    }
    return push;
}

/// Fills the row of a contact that sticks and has no couple about its normal, but for the parts and the stability.
/// @param tangential  force on A across the normal [N]
/// @param damping_force  the part of it that dashpots add [N]
inline void fill_row(const NormalContact& normal, const NormalPush& push, const Vec3& tangential,
                     const Vec3& damping_force, const ContactKinematics& kinematics, ContactRow& row) {
    const Vec3 dashpot = damping_force - (push.force - push.elastic) * push.n;
    row.point = normal.point;
    row.force = tangential - push.force * push.n;
    row.moment = normal.moment;
    row.elastic_energy = normal.energy;
    row.friction_loss = 0;
    row.dashpot = narrow(dashpot);
    row.dashpot_couple = {};
    row.dashpot_power = static_cast<float>(dot(dashpot, kinematics.relative_velocity));
    row.normal_force = static_cast<float>(push.force);
    row.shear_force = static_cast<float>(norm(tangential));
    row.overlap = static_cast<float>(normal.depth);
    row.potential = static_cast<float>(normal.potential);
    row.area = static_cast<float>(normal.area);
    row.is_sliding = 0;
}

}  // namespace riprap::contact
