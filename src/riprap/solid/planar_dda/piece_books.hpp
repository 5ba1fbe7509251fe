// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/planar_dda.hpp"

// Loads, energies, momenta and losses of one piece of a step, for the ledger.

namespace riprap::solid::planar_dda {

/// Returns the tangential force of a closed contact along its slip [N].
double shear_of(const Contact& contact, const Trial& trial);

/// Adds force and torque of every closed contact to both of its blocks.
void sum_contacts(const Scratch& engine, body::Loads& loads);

/// Adds force and torque of fixed points and bolts at the end of the piece. Forces of fixed points come from outside:
/// their impulses are booked, too.
/// @param start  state before the piece
void sum_supports(const Model& model, const State& start, const Scratch& engine, double dt, body::Loads& loads,
                  KickReport& impulses);

/// Books energy and momentum of blocks that are newly released.
void book_released(const Model& model, const PlanarDda::Fields& fields, const Vec3& gravity, KickReport& kick);

/// Books energies, momenta and impulses at the end of the piece.
/// @param given  loads from outside, empty without any
void book_blocks(const Model& model, const State& state, const Vec3& gravity, const std::vector<Unknowns>& given,
                 const body::Loads& contacts, double dt, KickReport& kick);

/// Books works and losses of the piece: the differences of the accounts.
void book_accounts(const Accounts& before, const Accounts& after, const Energies& energies, SolidReport& report);

}  // namespace riprap::solid::planar_dda
