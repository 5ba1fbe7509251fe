// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/pieces.hpp"

#include <optional>
#include <utility>

namespace riprap::sim {

namespace {

/// Most halvings of a refused piece: 2^10 = 1024 parts.
constexpr int most_cuts = 10;

Outcome move_over(Solid& solids, State& state, const TimeSpan& span, const body::LoadView& loads,
                  solid::Measure measure, const std::function<void(const solid::SolidReport&)>& take, int cuts) {
    std::optional<Kept> kept;
    if (solids.takes_back()) {
        kept = keep(state);
    }
    solid::SolidReport piece;
    Outcome outcome = solids.advance(span, loads, measure, piece);
    if (outcome.ok() || !kept || outcome.shorten <= 0 || cuts == most_cuts) {
        take(piece);
        return outcome;
    }
    take_back(std::move(*kept), state);
    const double half = 0.5 * span.dt;
    outcome = move_over(solids, state, {span.time, half}, loads, solid::Measure::flow, take, cuts + 1);
    return outcome.ok() ? move_over(solids, state, {span.time + half, half}, loads, measure, take, cuts + 1) : outcome;
}

}  // namespace

Kept keep(const State& state) { return {state.bodies, state.contacts, state.solid_fields, state.previous_dt}; }

void take_back(Kept&& kept, State& state) {
    state.bodies = std::move(kept.bodies);
    state.contacts = std::move(kept.contacts);
    std::swap(state.solid_fields, kept.fields);
    state.previous_dt = kept.previous_dt;
}

Outcome move_over(Solid& solids, State& state, const TimeSpan& span, const body::LoadView& loads,
                  solid::Measure measure, const std::function<void(const solid::SolidReport&)>& take) {
    return move_over(solids, state, span, loads, measure, take, 0);
}

}  // namespace riprap::sim
