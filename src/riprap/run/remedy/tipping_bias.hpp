// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Angle by which a free body tips early because its foot is elastic (contact/elastic_foot.hpp).
struct TippingBias {
    BodyId body;
    std::int64_t above{0};  ///< bodies that stand on it, directly or on others
    double rigid{0};        ///< slope of its foot at which a rigid body tips [rad]
    double elastic{0};      ///< slope at which it tips with the stiffness of the case [rad]
    double factor{0};       ///< by which normal_stiffness must grow for a bias of tolerated_tipping_bias [-]
    double lean{0};         ///< largest angle of gravity off the normal of its foot during the run [rad]

    double bias() const { return rigid - elastic; }       ///< [rad]
    double share() const { return 1 - elastic / rigid; }  ///< of the slope at which a rigid body tips [-]
};

/// A free body that stands flat, on the face that is most aligned with gravity, no more than 60 degrees off it.
struct LoadedFoot {
    BodyId body;
    std::int64_t above{0};  ///< bodies that stand on it, directly or on others
    double weight{0};       ///< of the body and those above [N]
    double area{0};         ///< of its foot [m^2]
    std::int64_t corners{0};
};

/// Returns the feet of all bodies that stand, from the lowest up. None without gravity.
std::vector<LoadedFoot> loaded_feet(const sim::Model& model, const sim::State& state);

inline constexpr double tolerated_tipping_bias = 0.1 * 3.14159265358979323846 / 180;  ///< [rad]

/// The bias that is the largest share of its slope among free bodies that stand flat: on the face that is most aligned
/// with gravity, no more than 60 degrees off it, alone with the bodies stacked on them. Joints count with the field of
/// the upper body alone, as on a half-space: between two blocks the loss is a fifth less. None without gravity or such
/// bodies.
std::optional<TippingBias> largest_tipping_bias(const sim::Model& model, const sim::State& state);

}  // namespace riprap::run
