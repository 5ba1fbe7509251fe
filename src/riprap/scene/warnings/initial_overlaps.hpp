// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/contact/contact_set.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::scene {

/// Two bodies that start inside each other.
struct InitialOverlap {
    BodyId a, b;
    double depth;  ///< largest depth of one below a face of the other, or of its centre of mass [m]
    double share;  ///< depth over the smaller inscribed radius of the two parts [-]
};

/// Pairs of bodies whose parts overlap by more than `max_share` of the smaller inscribed radius, each pair once with
/// its deepest parts, in the order of the bodies. Pairs that can never move against each other do not count.
///
/// The depth of a contact says nothing when two equal blocks lie on the same place: each surface then has depth zero
/// in the other. The centre of mass of one part inside the other catches this.
std::vector<InitialOverlap> find_initial_overlaps(const sim::Model& model, const sim::State& state, double max_share);

/// Two parts that lie in each other.
struct PartOverlap {
    contact::PartPair parts;
    double depth, share;     ///< as those of InitialOverlap [m], [-]
    Vec3 point{}, normal{};  ///< of the push of the distance potential, from A to B; zero where it has none [m], [-]
};

/// Pairs of parts that overlap by more than `max_share` of the smaller inscribed radius, in the order of the parts.
std::vector<PartOverlap> find_part_overlaps(const sim::Model& model, const sim::State& state, double max_share);

}  // namespace riprap::scene
