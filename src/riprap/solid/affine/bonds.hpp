// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/solid/affine/block_contacts.hpp"

// Bonds of faces that touch at the start. Cohesion and tensile strength belong to them alone: a contact that comes
// about later, or again, has neither.
//
// A bond has two ends. Its tensile strength is brittle: where it is passed the bond is torn. Its cohesion is a strength
// in shear: a point that is loaded to it slides and keeps it, so that the rest of the face can take over what is more,
// as limit equilibrium has it, until the point has slid by bond_length in all. One without tensile strength opens
// without force and parts where the gap is wider than that; what it slides while it is open counts as well. A length is
// needed, not a force: springs overshoot under a load that comes suddenly, and a face that shakes lifts by nanometres.
// A real joint reaches its peak strength after a slip of about a hundredth of its length [BartonChoubey1977]; the
// ten-thousandth taken here lies well below that, and above the overshoot of the springs.

namespace riprap::solid::affine {

/// Gap up to which two faces count as touching, over the smaller of their blocks [-].
constexpr double bond_tolerance = 1e-4;

/// Returns the pairs of blocks that touch and whose surfaces have cohesion or tensile strength, ascending.
std::vector<std::uint64_t> bonded_pairs(const BlockSystem& system, const BlockState& state);

/// Returns the slip or gap by which a bond of two blocks without tensile strength is lost, that up to which their faces
/// touch [m]: a share of the edge of the smaller one, the cube root of its volume; ground has no size. Other blocks of
/// the scene have no part in it.
double bond_length(const BlockSystem& system, std::int32_t a, std::int32_t b);

/// Returns the largest of all pairs [m].
double largest_bond_length(const BlockSystem& system);

/// Returns how far apart a bonded contact may be before it tears [m]: T A/k, A bounded by the largest block.
double tearing_gap(const BlockSystem& system);

/// Tells whether a contact point that has no history begins bonded.
bool begins_bonded(const BlockContactHistory& history, std::int32_t a, std::int32_t b);

/// Records which bonded pairs held and which broke in a step. Pairs are told in ascending order, more than once at
/// will.
struct BondChanges {
    std::vector<std::uint64_t> touching;  ///< have a point that holds, or that is no farther apart than the tolerance
    std::vector<std::uint64_t> broken;    ///< a point of theirs has opened or slid
    void look_at(const BlockContact& contact, bool was_intact, bool is_closed, bool is_intact, double tolerance);
};

/// Keeps of the bonded pairs those that touch and have no broken point.
std::vector<std::uint64_t> bonds_left(const std::vector<std::uint64_t>& bonded, const BondChanges& changes);

/// Counts the pairs that touch: those of rows that are not open.
std::int64_t count_touching(const BlockContactHistory& history);

/// Tells whether a contact point still holds by its bond.
bool has_intact(const BlockContactHistory& history);

/// Tells whether row `row` of `old`, which was not found again, held by a bond, and its pair has no contact left in
/// `now`.
bool has_come_apart(const BlockContactHistory& old, std::size_t row, const BlockContactHistory& now);

}  // namespace riprap::solid::affine
