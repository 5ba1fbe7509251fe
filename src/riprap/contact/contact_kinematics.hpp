// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap::contact {

/// Motion of two bodies at a contact point, and their effective masses there.
struct ContactKinematics {
    Vec3 relative_velocity;   ///< v_A - v_B at the point of action [m/s]
    Vec3 mean_spin;           ///< (omega_A + omega_B)/2 [rad/s]
    Vec3 relative_spin;       ///< omega_A - omega_B [rad/s]
    double sliding_time;      ///< time between the last contact evaluation and this one [s]
    double effective_mass;    ///< 1/m_e = n.(1/m_A + 1/m_B)n + (r_A x n) J_A^-1 (r_A x n) + same of B [kg]
    double tangential_mass;   ///< the same with a mean over all directions across n [kg]
    Vec3 mean_velocity{};     ///< (v_A + v_B)/2 there [m/s]
    double twist_inertia{0};  ///< 1/J_e = n.(J_A^-1 + J_B^-1) n [kg m^2]
};

}  // namespace riprap::contact
