// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string_view>

#include "riprap/core/chosen.hpp"

// Laws of the joints between blocks of discontinuous deformation analysis: the largest shear force that a contact point
// bears. Below it the shear spring holds, at it the point slides with it; both are the same for every law.

namespace riprap::contact {

/// Describes a contact point to a joint law.
struct JointPoint {
    double push{0};      ///< N, normal force, pressing positive [N]
    double friction{0};  ///< tan phi of the pair of materials [-]
    double cohesion{0};  ///< C = c A while the point is bonded, A the area that it stands for; else 0 [N]
};

/// S = N tan phi + C, at least 0.
struct MohrCoulomb {
    static constexpr std::string_view word = "coulomb", help = "friction of Coulomb, and cohesion while bonded";
    static double strength(const JointPoint& point) {
        return std::max(0.0, point.push * point.friction + point.cohesion);
    }
};

/// Joint laws of all three methods: one line registers a law. Beside its word, help and keys (core/chosen.hpp) it has
/// `strength(point)` [N].
using JointLaws = Chosen<  //
    MohrCoulomb            //
    >;

/// Returns the strength of a contact point by the chosen law [N].
inline double shear_strength(const JointLaws& laws, const JointPoint& point) {
    return laws.visit([&point](const auto& law) { return law.strength(point); });
}

}  // namespace riprap::contact
