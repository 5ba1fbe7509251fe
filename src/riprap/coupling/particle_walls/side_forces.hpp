// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/scheme_settings.hpp"

namespace riprap::coupling {

/// The water on both sides of the plane of a face.
struct WaterAtFace {
    const fluid::SchemeSettings& scheme;
    const fluid::ParticleState& particles;
    Vec3 gravity;  ///< [m/s^2]
};

/// Pressure forces on boundary particles by the water before a plane alone, in every scheme by its own law of a pair.
///
/// Solid thinner than the support stands for a wall to the water on either side of it, so its boundary particles feel
/// both. What the water behind does is summed here a second time, from the State, and taken off. What is left is the
/// reaction to all that the water in front feels: where that is at rest, exactly what holds it, however unevenly its
/// particles stand at the face and whatever stands behind.
class SideForces {
 public:
    /// @param place   on the plane; water within `reach` of it is looked at [m]
    /// @param normal  of the plane, towards its front
    SideForces(const WaterAtFace& water, const fluid::BoundaryParticles& walls, const Vec3& place, const Vec3& normal,
               double reach);

    /// Tells whether there is water behind the plane.
    bool has_water_behind() const { return has_water_behind_; }
    /// Returns what is to be added to the force of the last step on a boundary particle, so that the water behind has
    /// no part in it [N].
    Vec3 correction(std::size_t wall) const;

 private:
    struct Near {
        Vec3 place;  ///< the image beside the plane [m]
        double pressure, volume, density;
        std::array<double, 6> correction;  ///< B of SPH
        bool is_in_front;
    };

    template <class Scheme>
    Vec3 correction_by(const Scheme& settings, std::size_t wall) const;
    Vec3 correction_by(const fluid::SphSettings& settings, std::size_t wall) const;
    void correct_gradients(const fluid::SphSettings& settings);

    const WaterAtFace& water_;
    const fluid::BoundaryParticles& walls_;
    Vec3 place_;
    double reach_;
    bool has_water_behind_{false};
    std::vector<Near> near_;
};

}  // namespace riprap::coupling
