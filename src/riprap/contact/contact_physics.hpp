// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/contact/narrowphase/separating_cache.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::contact {

/// One side of a candidate pair: a part where it is, and the body that carries it.
struct PairSide {
    std::int32_t part;
    std::int32_t body;
    geometry::ConvexView shape;
    const Frame& frame;  ///< of the part
    const material::Material& material;
    const Vec3& center;    ///< of mass of the body [m]
    const Vec3& velocity;  ///< of the centre of mass [m/s]
    const Vec3& spin;      ///< angular velocity, world axes [rad/s]
    const double& inverse_mass;
    const Sym3& inverse_inertia;  ///< world axes; both zero for a body that forces do not move
};

/// Two parts that may touch, with all that a physics may want to know of them.
struct Candidate {
    PairSide a, b;
    const material::PairProperties& surfaces;
    double sliding_time;  ///< since the last evaluation [s]
};

/// A contact that the physics of a pair reports.
struct FoundContact {
    std::int32_t pair;         ///< number of the candidate
    std::int32_t old_contact;  ///< row of the last step, -1 = none
    std::uint64_t feature;
    ShearState springs;  ///< to be remembered
    ContactRow row;      ///< filled but for the parts
    bool is_old() const { return old_contact >= 0; }
};

/// Takes the contacts that the physics of a pair finds, none to many, in any order.
class FoundContacts {
 public:
    FoundContacts(const ContactHistory& history, std::vector<FoundContact>& found)
        : history_(&history), found_(&found) {}

    /// Adds contact `feature` of this pair, each at most once. Where it existed at the last step (is_old), its
    /// springs are copied from there. The reference is valid until the next add().
    FoundContact& add(std::uint64_t feature);

    /// Goes on to another candidate. @param old_begin  first row of the history that can be of this pair
    void begin_pair(std::int32_t pair, PartPair parts, std::int32_t old_begin);
    /// Normal of the first contact that this pair had at the last step; zero where it had none.
    Vec3 old_normal() const;
    /// Brings the contacts of the pair into the order of their features.
    void end_pair();

 private:
    const ContactHistory* history_;
    std::vector<FoundContact>* found_;
    PartPair parts_{};
    std::int32_t pair_{0}, old_begin_{0};
    std::size_t first_{0};  ///< of this pair's contacts in *found_
};

/// Physics of a pair of parts: a narrowphase, which finds contacts, and a law, which responds to each with its forces
/// (respond.hpp). One object serves all threads; per candidate it has a SeparatingCache to remember what may save it
/// work. The common plane finds a contact per vertex on face and edge on edge, the distance potential one per pair.
///
/// `meet` adds the contacts of a candidate, `springs` and `row` filled, forces on A. The pipeline finds the candidates,
/// carries the springs from step to step by (part, part, feature), sums the loads in the order of that key, and knows
/// nothing of what a feature is.
template <class T>
concept ContactPhysics = requires(const T& physics, const Candidate& pair, SeparatingCache& cache,
                                  FoundContacts& found) {
    { physics.meet(pair, cache, found) } -> std::same_as<void>;
};

}  // namespace riprap::contact
