// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// Numbers the free blocks and lists which of them a contact or a bolt couples.
void number_rows(const Model& model, Scratch& scratch);

/// Fills stiffness and force of every row with all terms but contacts: strain, stress, mass, gravity, loads, fixed
/// points. Bolts couple rows and are added by assemble().
void assemble_blocks(const Model& model, const State& state, const Step& step, Scratch& scratch);

/// Builds the matrix from the blocks, bolts and closed contacts.
void assemble_matrix(const Model& model, const State& state, double dt, Scratch& scratch);
/// Builds the right side for the present modes, multipliers and friction.
void assemble_right_side(const Model& model, const State& state, double dt, Scratch& scratch);

/// Stretch of a bolt at the start of the step and what changes it.
Linear bolt_length(const State& state, const body::Bolt& bolt);

}  // namespace riprap::solid::planar_dda
