// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// The clock of the flow of a scheme that makes several sound steps on one geometry (docs/theory/sph.md, 12): State.
/// The geometry itself, weights and corrections of gradients, is Scratch and found again from these fields. All empty
/// and zero with one clock.
struct FlowClock {
    std::vector<Vec3> place;      ///< x^g: of the middle of the flow step, about which sums are made [m]
    std::vector<Vec3> velocity;   ///< v at its beginning, of which strain and slow forces are [m/s]
    std::vector<double> density;  ///< rho at its beginning, of which volumes are [kg/m^3]
    std::int64_t done{0};         ///< sound steps kicked in the flow step
    std::int64_t steps{0};        ///< sound steps of it
    double span{0};               ///< T, time of the flow step as foreseen [s]
    double travel{0};             ///< farthest that a particle has come in it [m]
    std::uint64_t stamp{0};       ///< tells this geometry from others

    /// The next step goes on in the same geometry.
    bool is_under_way() const { return done < steps; }
    /// There is a geometry, of the flow step under way or of the one that the last step has ended.
    bool has_geometry() const { return !place.empty(); }
    /// Ends the flow step before its time: the next step finds its geometry anew.
    void end() { steps = done; }
    /// Forgets the geometry, whose particles are no longer those of the water.
    void forget() {
        place.clear();
        velocity.clear();
        density.clear();
        end();
    }
    /// Goes back to one clock.
    void clear() { *this = {}; }

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("fluid.flow_place", self.place);
        visit("fluid.flow_velocity", self.velocity);
        visit("fluid.flow_density", self.density);
        visit("fluid.flow_done", self.done);
        visit("fluid.flow_steps", self.steps);
        visit("fluid.flow_span", self.span);
        visit("fluid.flow_travel", self.travel);
        visit("fluid.flow_stamp", self.stamp);
    }
};

}  // namespace riprap::fluid
