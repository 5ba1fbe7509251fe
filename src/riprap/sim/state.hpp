// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::sim {

/// Running totals of the ledger that must survive a restart; see ledger.hpp for their meaning.
struct LedgerState {
    std::vector<double> totals;  ///< indexed by LedgerTotal
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("ledger.totals", self.totals);
    }
};

/// What decides the length of the next step besides the fields themselves; see time_step.hpp.
struct StepControl {
    std::int64_t halvings{0};  ///< the automatic step is 2^-halvings of what is allowed
    std::int64_t accepted{0};  ///< steps accepted since `halvings` changed; counted while it is not 0
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("stepping.halvings", self.halvings);
        visit("stepping.accepted", self.accepted);
    }
};

/// What the coupling of water and bodies remembers; one entry per body, none without water.
struct CouplingState {
    double previous_dt{0};                       ///< of the water; 0 at the start [s]
    std::vector<Vec3> acceleration;              ///< mean over the last step: the first guess of the next [m/s^2]
    std::vector<Vec3> angular_acceleration;      ///< [rad/s^2]
    std::vector<Vec3> dry_acceleration;          ///< the part of it that is not due to water [m/s^2]
    std::vector<Vec3> dry_angular_acceleration;  ///< [rad/s^2]
    std::vector<std::int32_t> near_samples;      ///< that water or joints may feel, see coupling::near_samples
    double near_travel{-1};  ///< farthest that water or faces can have come since they were found; negative: never [m]

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("coupling.previous_dt", self.previous_dt);
        visit("coupling.acceleration", self.acceleration);
        visit("coupling.angular_acceleration", self.angular_acceleration);
        visit("coupling.dry_acceleration", self.dry_acceleration);
        visit("coupling.dry_angular_acceleration", self.dry_angular_acceleration);
        visit("coupling.near_samples", self.near_samples);
        visit("coupling.near_travel", self.near_travel);
    }
};

/// Everything that changes and must be saved to continue. Restart = write State, read State.
struct State {
    double time{0};       ///< [s]
    double time_rest{0};  ///< what `time` has in excess of the exact sum of the steps, known to more digits [s]
    std::int64_t step{0};
    double previous_dt{0};  ///< [s]; a contact's sliding between two kicks lasts (previous_dt + dt)/2
    StepControl stepping;
    body::BodyState bodies;
    contact::ContactHistory contacts;
    LedgerState ledger;
    fluid::ParticleState fluid;  ///< empty without water
    fluid::OpenState open;       ///< of its inflows and outflows
    CouplingState coupling;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("time", self.time);
        visit("time_rest", self.time_rest);
        visit("step", self.step);
        visit("previous_dt", self.previous_dt);
        StepControl::visit_fields(self.stepping, visit);
        body::BodyState::visit_fields(self.bodies, visit);
        contact::ContactHistory::visit_fields(self.contacts, visit);
        LedgerState::visit_fields(self.ledger, visit);
        fluid::ParticleState::visit_fields(self.fluid, visit);
        fluid::OpenState::visit_fields(self.open, visit);
        CouplingState::visit_fields(self.coupling, visit);
    }
};

}  // namespace riprap::sim
