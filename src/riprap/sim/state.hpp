// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"

namespace riprap::sim {

/// Running totals of the ledger that must survive a restart; see ledger.hpp for their meaning.
struct LedgerState {
    std::vector<double> totals;  ///< indexed by LedgerTotal
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("ledger.totals", self.totals);
    }
};

/// Everything that changes and must be saved to continue. Restart = write State, read State.
struct State {
    double time{0};
    std::int64_t step{0};
    double previous_dt{0};  ///< [s]; a contact's sliding between two kicks lasts (previous_dt + dt)/2
    body::BodyState bodies;
    contact::ContactHistory contacts;
    LedgerState ledger;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("time", self.time);
        visit("step", self.step);
        visit("previous_dt", self.previous_dt);
        body::BodyState::visit_fields(self.bodies, visit);
        contact::ContactHistory::visit_fields(self.contacts, visit);
        LedgerState::visit_fields(self.ledger, visit);
    }
};

}  // namespace riprap::sim
