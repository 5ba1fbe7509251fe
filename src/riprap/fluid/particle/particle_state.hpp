// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/blocks.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/fluid/particle/flow_clock.hpp"

namespace riprap::fluid {

/// Particles of a fluid: State. All carry the same mass, which is Model. The order of the arrays is part of the State:
/// sums over neighbours follow it, and it is renewed (sorted by place) on steps given by the step number alone. Lists
/// of neighbours are Scratch and decide no bit.
struct ParticleState {
    std::vector<Vec3> position;   ///< x_n [m]
    std::vector<Vec3> velocity;   ///< v_n [m/s]
    std::vector<double> density;  ///< rho_(n-1/2), half a step behind the rest [kg/m^3]
    /// SPH: share of density that the last shift took, due at the next update of density. WC-MPS: damped compression in
    /// half of the last step, whose heat is due then. MPS: density that the pressure at the start lacks [-].
    std::vector<double> dilution;
    /// SPH: what the damping of sound took in the last kick per compression, V a s h rho_0 c_0 (-div v), whose other
    /// half is due at the next update of density; empty = none [J].
    std::vector<double> damping;
    std::vector<Vec3> shift;       ///< half of the last shift, due after the next update of density; empty = none [m]
    std::vector<std::int32_t> id;  ///< of the particle for life: 0 to size() - 1 at the start
    double max_acceleration{0};    ///< in the last step; limits the next [m/s^2]
    FlowClock flow;                ///< of a scheme with two clocks
    parallel::BlockTable held;     ///< blocks that these arrays keep; no State, and empty where they keep all

    std::int64_t size() const { return static_cast<std::int64_t>(position.size()); }
    /// Returns the particles by blocks of their order: what loops, sums and sweeps run over.
    parallel::Blocks blocks() const { return {held, size()}; }

    void add(const Vec3& x, const Vec3& v, double rho, std::int32_t particle) {
        position.push_back(x);
        velocity.push_back(v);
        density.push_back(rho);
        dilution.push_back(0);
        if (!damping.empty()) {
            damping.push_back(0);
        }
        if (!shift.empty()) {
            shift.emplace_back();
        }
        id.push_back(particle);
        flow.clear();  // no geometry knows it
    }

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("fluid.position", self.position);
        visit("fluid.velocity", self.velocity);
        visit("fluid.density", self.density);
        visit("fluid.dilution", self.dilution);
        visit("fluid.damping", self.damping);
        visit("fluid.shift", self.shift);
        visit("fluid.id", self.id);
        visit("fluid.max_acceleration", self.max_acceleration);
        FlowClock::visit_fields(self.flow, visit);
    }
};

}  // namespace riprap::fluid
