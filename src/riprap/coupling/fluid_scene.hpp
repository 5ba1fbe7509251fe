// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/gravity.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Parts of the Model that every fluid reads.
struct FluidScene {
    const geometry::ShapeSet& shapes;
    const body::BodySet& bodies;
    const body::Gravity& gravity;
};

/// State of the coupling of a fluid and bodies. One entry per body, none without a fluid.
struct CouplingState {
    double previous_dt{0};                       ///< of the fluid; 0 at the start [s]
    std::vector<Vec3> acceleration;              ///< mean over the last step: the first guess of the next [m/s^2]
    std::vector<Vec3> angular_acceleration;      ///< [rad/s^2]
    std::vector<Vec3> dry_acceleration;          ///< the part of it that is not due to the fluid [m/s^2]
    std::vector<Vec3> dry_angular_acceleration;  ///< [rad/s^2]
    /// Way and turn of the last step that the fluid did not see, for walls of particles; else empty [m], [rad].
    std::vector<Vec3> missed_way, missed_turn;
    /// Way and turn that walls made since the last update of density, beyond what that was told of them [m], [rad].
    std::vector<Vec3> untold_way, untold_turn;
    std::vector<double> surge;               ///< of paddles that absorb a sea, along their waves; else empty [m/s^2]
    std::vector<std::int32_t> near_samples;  ///< that water or joints may feel, see coupling::near_samples
    double near_travel{-1};  ///< farthest that water or faces can have come since they were found; negative: never [m]

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("coupling.previous_dt", self.previous_dt);
        visit("coupling.acceleration", self.acceleration);
        visit("coupling.angular_acceleration", self.angular_acceleration);
        visit("coupling.dry_acceleration", self.dry_acceleration);
        visit("coupling.dry_angular_acceleration", self.dry_angular_acceleration);
        if (!self.missed_way.empty()) {
            visit("coupling.missed_way", self.missed_way);
            visit("coupling.missed_turn", self.missed_turn);
            visit("coupling.untold_way", self.untold_way);
            visit("coupling.untold_turn", self.untold_turn);
        }
        if (!self.surge.empty()) {
            visit("coupling.surge", self.surge);
        }
        visit("coupling.near_samples", self.near_samples);
        visit("coupling.near_travel", self.near_travel);
    }
};

/// Parts of the State that a fluid may change. Fluids without particles leave the first two alone.
struct FluidState {
    fluid::ParticleState& particles;
    fluid::OpenState& open;
    CouplingState& coupling;
    body::BodyState& bodies;  ///< drive_rate of driven bodies that absorb waves, nothing else
};

}  // namespace riprap::coupling
