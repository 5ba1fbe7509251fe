// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/grid_fluid/fields.hpp"
#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/explicit_dda/state.hpp"
#include "riprap/solid/implicit_dda/state.hpp"
#include "riprap/solid/planar_dda/state.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

namespace riprap::sim {

namespace detail {
template <class Settings>
struct FieldsOf;
template <class... Settings>
struct FieldsOf<std::variant<Settings...>> {
    using Variant = std::variant<typename Settings::Fields...>;
};
}  // namespace detail

/// Fields that one method alone keeps, in the order of the lists of sim/settings.hpp.
using SolidFields = detail::FieldsOf<SolidSettings>::Variant;
using FluidFields = detail::FieldsOf<FluidSettings>::Variant;

/// Running totals of the ledger that must survive a restart; see ledger.hpp for their meaning.
struct LedgerState {
    std::vector<double> totals;  ///< indexed by LedgerTotal
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("ledger.totals", self.totals);
    }
};

/// Decides the length of the next step, besides the fields themselves; see time_step.hpp.
struct StepControl {
    std::int64_t halvings{0};  ///< the automatic step is 2^-halvings of what is allowed
    std::int64_t accepted{0};  ///< steps accepted since `halvings` changed; counted while it is not 0
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("stepping.halvings", self.halvings);
        visit("stepping.accepted", self.accepted);
    }
};

/// What instruments that respond slowly show; see gauge_reading.hpp.
struct GaugeState {
    std::vector<double> shown;  ///< three for each gauge, once one that responds slowly has followed a step
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("gauges.shown", self.shown);
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
    GaugeState gauges;
    fluid::ParticleState fluid;  ///< empty without water
    fluid::OpenState open;       ///< of its inflows and outflows
    coupling::CouplingState coupling;
    SolidFields solid_fields;
    FluidFields fluid_fields;

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
        GaugeState::visit_fields(self.gauges, visit);
        fluid::ParticleState::visit_fields(self.fluid, visit);
        fluid::OpenState::visit_fields(self.open, visit);
        coupling::CouplingState::visit_fields(self.coupling, visit);
        const auto visit_own = [&](auto& own) { std::remove_cvref_t<decltype(own)>::visit_fields(own, visit); };
        std::visit(visit_own, self.solid_fields);
        std::visit(visit_own, self.fluid_fields);
    }
};

}  // namespace riprap::sim
