// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/motion.hpp"
#include "riprap/coupling/particle_walls/touch.hpp"
#include "riprap/coupling/wall_passages.hpp"

namespace riprap::coupling {

/// Velocity of a body at a place [m/s].
inline Vec3 velocity_at(const body::Motion& motion, std::int32_t body, const Vec3& x) {
    const auto b = static_cast<std::size_t>(body);
    return motion.velocity[b] + cross(motion.angular_velocity[b], x - motion.pose[b].position);
}

/// All parts of a scene, for the passages of particles within one step.
struct PassageScene {
    const body::BodySet& bodies;
    const body::Motion& motion;
    std::span<const PlacedPart> parts;     ///< of all bodies, in the order of bodies.parts
    std::span<const std::uint8_t> is_dry;  ///< per body; empty = none
    const fluid::PeriodicImages& images;
    double spacing;  ///< of the particles [m]
    double dt;       ///< [s]
};

/// The wet parts of bodies that no force moves about a block of particles, looked up when one of these may have gone
/// through.
class PartsAround {
 public:
    PartsAround(const PassageScene& scene, std::span<const Vec3> particles) : scene_(scene), particles_(particles) {}
    /// Returns those within a distance of any of the particles [m], and perhaps some more, in the order of parts.
    std::span<const std::int32_t> within(double distance);

 private:
    const PassageScene& scene_;
    std::span<const Vec3> particles_;
    double distance_{-1};  ///< that parts_ is for
    std::vector<std::int32_t> parts_;
};

/// Tells whether a particle has gone through solid on its way of the last step: through a body that forces move, or
/// through all bodies that none moves, which are one solid where they touch (SolidAround). Joints between a body that
/// forces move and others are not shut, nor are gaps wider than a tenth of a spacing.
/// @param touches  of the particle with all parts and grounds that are near it
/// @param around   parts about particles of which it is one
WallPassages passage_of(const PassageScene& scene, const Vec3& x, const Vec3& velocity, std::span<const Touch> touches,
                        PartsAround& around);

}  // namespace riprap::coupling
