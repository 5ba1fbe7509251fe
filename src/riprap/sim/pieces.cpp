// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/pieces.hpp"

#include <optional>
#include <utility>

namespace riprap::sim {

namespace {

/// Most halvings of a refused piece: 2^10 = 1024 parts.
constexpr int most_cuts = 10;

Outcome move_over(StepContext& step, const Piece& piece, const std::function<void(const solid::SolidReport&)>& take,
                  int cuts) {
    std::optional<Kept> kept;
    if (step.solid.takes_back()) {
        kept = keep(step.state);
    }
    solid::SolidReport report;
    Outcome outcome = step.solid.advance(piece.span, piece.loads, piece.measure, report);
    if (outcome.ok() || !kept || outcome.shorten <= 0 || cuts == most_cuts) {
        take(report);
        return outcome;
    }
    take_back(std::move(*kept), step.state);
    const auto [time, dt] = piece.span;
    const double half = 0.5 * dt;
    outcome = move_over(step, {{time, half}, piece.loads, Measure::flow}, take, cuts + 1);
    return outcome.ok() ? move_over(step, {{time + half, half}, piece.loads, piece.measure}, take, cuts + 1) : outcome;
}

}  // namespace

Kept keep(const State& state) { return {state.bodies, state.contacts, state.solid_fields, state.previous_dt}; }

void take_back(Kept&& kept, State& state) {
    state.bodies = std::move(kept.bodies);
    state.contacts = std::move(kept.contacts);
    std::swap(state.solid_fields, kept.fields);
    state.previous_dt = kept.previous_dt;
}

Outcome move_over(StepContext& step, const Piece& piece, const std::function<void(const solid::SolidReport&)>& take) {
    return move_over(step, piece, take, 0);
}

}  // namespace riprap::sim
