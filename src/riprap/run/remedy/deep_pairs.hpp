// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "riprap/contact/shown_contact.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Depth of an overlap over the inscribed radius from which on it is remembered where the pair met [-]: more than the
/// weight of a block presses its contacts together, less than what squeezes it through a gap of 0.95 of its width.
inline constexpr double deep_overlap = 0.02;

/// Remembers where pairs of parts that are deep in each other met, and which way.
///
/// The depth of a contact is that below the *nearest* face. A block that is squeezed through a gap narrower than itself
/// is soon nearer to the sides of the gap than to its mouth: no contact is ever deep, and they push on instead of back.
/// So the way counts that two parts have gone against the push of their first contact: where the points of both that
/// met have passed each other by solid::most_overlap of an inscribed radius, along the normal then, as either of them
/// has carried it since, and still lie in the other part, one has gone through the other. A block that rolls, slides or
/// tips over an edge takes its point out of the other part, or its normal along; one that slides over a seam while its
/// weight presses it deep into its floor is not held from the other side: only a body that is pressed from two sides
/// goes through a gap.
///
/// A round body that is squeezed through a gap of nine tenths of its width never goes that far against its first
/// pushes: they turn as it passes. So it has gone through as well where two sides that cannot yield, deep in it all the
/// time, pushed it back when it came and push it on now.
///
/// Part of a checkpoint: a run that goes on must end as the whole one does.
class DeepPairs {
 public:
    /// Two parts as they lie in each other at one time.
    struct Meeting {
        contact::PartPair parts;
        Vec3 point, normal;  ///< somewhere in the overlap [m]; against the way that they came, from A to B [-]
        Vec3 push;           ///< normal of the contact, from A to B [-]
        double depth;        ///< [m]
        double share;        ///< depth over an inscribed radius [-]
    };
    /// Takes all pairs deeper than deep_overlap, in the order of contact::pair_key. @returns how one part has gone
    /// through another; empty where none has
    std::string look(const sim::Model& model, const sim::State& state, std::span<const Meeting> meetings);
    /// No pair is deep.
    void clear() { *this = {}; }

    /// Returns whether the fields fit each other and the scene, as those of a checkpoint may not.
    bool fits(const sim::Model& model) const;

    friend bool operator==(const DeepPairs&, const DeepPairs&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("run.deep_pair", self.pair_);
        visit("run.deep_point_a", self.point_a_);
        visit("run.deep_point_b", self.point_b_);
        visit("run.deep_normal_a", self.normal_a_);
        visit("run.deep_normal_b", self.normal_b_);
    }

 private:
    std::vector<std::uint64_t> pair_;        ///< contact::pair_key, increasing
    std::vector<Vec3> point_a_, point_b_;    ///< where they met, in body axes of either [m]
    std::vector<Vec3> normal_a_, normal_b_;  ///< then, from A to B, in body axes of either [-]
};

/// The pairs of a step that tell how deep they are, rows in the order of State::contacts: at the mean of their points,
/// pushed as their deepest is. Where they go farther in a step of `dt` than they are deep, the first push that is seen
/// may be that of any face by now: the way that they come counts in its place.
std::vector<DeepPairs::Meeting> deep_meetings(const sim::Model& model, const sim::State& state,
                                              std::span<const contact::ShownContact> rows, double dt);

/// The pairs of parts whose shapes overlap where they are, pushed as the distance potential would push them.
std::vector<DeepPairs::Meeting> deep_meetings(const sim::Model& model, const sim::State& state);

}  // namespace riprap::run
