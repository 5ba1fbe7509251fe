// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// Moves a free block by the unknowns of a step and turns stress and strain rates with it; see advance().
void move_block(const Model& model, double dt, const Unknowns& motion, std::int32_t block, State& state);

/// Moves a fixed block as told: rigidly, with the rates motion/dt.
void drive_block(double dt, const Unknowns& motion, std::int32_t block, State& state);

/// Adds one contact to those that the state keeps. @param lock  see State::contact_lock
void keep_contact(const Contact& contact, const Trial& trial, double lock, State& state);

/// Writes modes, lock points and forces of the contacts back, closed ones and bonds only. A sliding contact keeps the
/// lock point at which its shear spring carries its friction.
void keep_contacts(const Scratch& scratch, State& state);

}  // namespace riprap::solid::planar_dda
