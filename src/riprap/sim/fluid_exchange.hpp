// SPDX-License-Identifier: Apache-2.0
#pragma once

// Exchange between bodies and a fluid in a step, whatever their methods: for the sources of this folder only.

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

/// Adds pressure and viscosity, within the plane of a planar scene.
void add_up(const body::BodySet& bodies, const coupling::FluidLoads& loads, body::Loads& sum);

/// Adds the loads of one of `spans` equal spans to their mean over the step: momentum is kept.
void add_share(const body::Loads& span, std::int64_t spans, body::Loads& step);

/// Returns the work of the loads on free bodies that move as predicted: of all fluids that move by themselves walls go
/// on without the rate of stretch [J].
double work_on_free(const Prediction& prediction, const body::Loads& loads, double dt);

/// Work of loads that are held over a step on free bodies [J].
struct WorkDone {
    double motion{0};  ///< along the way and the turn of bodies
    double strain{0};  ///< of the pull on the change of their stretch
    double all() const { return motion + strain; }
};
/// Returns the work that the loads of the fluid did on free bodies over the step that took them to the State.
WorkDone work_done(const StepContext& step);

/// Notes the mean accelerations over the step that took bodies to the State: the first guess of the next.
void note_accelerations(StepContext& step);

/// Keeps impacts that are over out of the next step: where the last contact loads are less than half of
/// what else than the fluid accelerated a body over the step, or against it, they take its place. An impact is shorter
/// than a step of the fluid; expected once more, the fluid would do its work on a motion that the body does not make.
void forget_impacts(StepContext& step);

/// Books the work on free bodies along the way that they went in place of that foreseen, for a fluid that has an
/// account of what its balance lacks and feels the bodies: its energy is that of the room that they leave it, and
/// follows their true way.
/// @param rest  number of that account
void book_true_way(double work_given, std::size_t rest, std::span<FluidSpan> spans);

/// Books the work on the strain of blocks for a fluid whose walls do not move as they stretch: it comes from nothing
/// that the fluid has, which the account straining_name shows.
/// @param straining  number of that account
void book_straining(double work, std::size_t straining, std::span<FluidSpan> spans);

/// Books the spans of the fluid. @param work_given  on free bodies over the step, as the bodies say [J]
void book_fluid(StepContext& step, double work_given);

/// Empties what a fresh State keeps for the coupling.
void reset(const Model& model, coupling::CouplingState& coupling);

}  // namespace riprap::sim
