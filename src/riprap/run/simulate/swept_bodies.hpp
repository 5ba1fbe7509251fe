// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Two bodies of which one goes through the other within a step, or deep into it.
struct Sweep {
    BodyId body, other;
    double way;  ///< of the first one in the step [m]
};

/// Follows the bodies over a step, free ones on straight lines at the speeds that they have, driven ones to where their
/// motions put them. Looks at them as often as they approach each other by half the inscribed radius of the thinner
/// one. @returns the first pair that is ever deeper in each other than that and moves by more than an inscribed radius
std::optional<Sweep> find_sweep(const sim::Model& model, const sim::State& state, double dt);

}  // namespace riprap::run
