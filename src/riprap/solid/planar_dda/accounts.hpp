// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// Energy of the springs of the closed contacts of a State, at their present gaps and slips [J].
double contact_energy(const Model& model, const State& state, const std::vector<Vec2>& corners);
/// Energy of the springs of the contacts that a search found and remembers as closed [J].
double remembered_energy(const Scratch& scratch);
/// Kinetic energy of free blocks [J].
double kinetic_energy(const Model& model, const State& state);

/// Books one accepted step before the blocks move: works and losses over the linear displacements. The loss of a
/// spring is what the force at the end of the step, which acts during the whole step, takes beyond what is stored:
/// 1/2 k (change of length)^2.
/// @returns the energy stored in blocks, contacts, points and bolts after the linear step [J]
double book_step(const Model& model, const Step& step, const State& state, const Scratch& scratch, Accounts& accounts);

/// Energy stored in strain, contacts, fixed points and bolts [J].
double stored_energy(const Model& model, const State& state, const std::vector<Vec2>& corners);

}  // namespace riprap::solid::planar_dda
