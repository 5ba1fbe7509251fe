// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/loads.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/contact_physics.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/placed_parts.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::contact {

/// Input of the contact pipeline: all const, or fixed for the step.
struct ContactScene {
    const geometry::ShapeSet& shapes;
    const material::MaterialSet& materials;
    const body::BodySet& bodies;
    double grid_factor;  ///< gamma of the multi-level grid [-]
    double skin;         ///< of the pair cache, as a fraction of the median circumradius [-]
    /// Per body: it meets others by a physics of its own, and this pipeline leaves it out. Empty: none does.
    std::span<const std::uint8_t> left_out{};
};

/// The stages bounds -> broadphase -> pair cache -> pair physics -> history, shared by all solids: Scratch.
/// Only touching contacts, in the order of their keys, reach any result; candidates, chunks and caches do not.
class ContactPipeline {
 public:
    ContactPipeline() = default;
    ~ContactPipeline() = default;
    ContactPipeline(const ContactPipeline&) = delete;  // rows_ points into found_, which a move takes along
    ContactPipeline& operator=(const ContactPipeline&) = delete;
    ContactPipeline(ContactPipeline&&) = default;
    ContactPipeline& operator=(ContactPipeline&&) = default;
    /// Places every part with its body.
    void place_parts(const ContactScene& scene, const body::BodyState& state);
    /// Updates the candidate pairs. @returns true when they were searched afresh.
    bool find_pairs();
    /// Evaluates the physics of every candidate and replaces `history` by that of the contacts found. The body is in
    /// find_contacts.hpp; a physics instantiates it in its own source file.
    /// @param sliding_time  time since the last evaluation [s]
    /// @returns energy of springs whose contact was lost, dissipated [J]
    template <ContactPhysics Physics>
    double find_contacts(const Physics& physics, const ContactScene& scene, const body::BodyState& state,
                         const body::BodyKinematics& kinematics, double sliding_time, ContactHistory& history);
    /// Sums the contact loads of every body over its contacts in the order of their keys.
    void gather_loads(const ContactScene& scene, const body::BodyState& state, body::Loads& loads) const;
    /// Returns the energy that the dashpots take in a step of length dt [J]: force times the mean of the velocities
    /// before and after the kick, as that is its change. Call after the kick, with the kinematics before it.
    double dashpot_loss(const ContactScene& scene, const body::BodyState& state, const body::BodyKinematics& kinematics,
                        double dt) const;
    /// Returns the longest stable step of the present contacts, by Gershgorin's theorem (docs/theory/time-step.md) [s];
    /// infinity without contacts.
    double stable_step(const ContactScene& scene) const;

    /// Contacts found last; valid until they are sought again.
    ContactRows rows() const { return ContactRows(rows_); }
    std::int64_t pair_count() const { return static_cast<std::int64_t>(cache_.pairs().size()); }
    std::size_t bytes() const;

 private:
    /// Tells whether the last contacts found are those of `history`: not so once another State has been loaded.
    bool are_rows_of(const ContactHistory& history) const;
    void map_history(const ContactHistory& history);
    template <ContactPhysics Physics>
    void evaluate(const Physics& physics, const ContactScene& scene, const body::BodyState& state,
                  const body::BodyKinematics& kinematics, double sliding_time, const ContactHistory& history);
    /// Builds rows_, contact_begin_ and the history from the chunks.
    void collect(ContactHistory& history);
    double lost_energy(const ContactHistory& history) const;
    template <class Visit>
    void visit_contacts_of(std::size_t body, const body::BodySet& bodies, const Visit& visit) const;

    PairCache cache_;
    PlacedParts placed_;
    PairCache::Settings cache_settings_;
    std::vector<SeparatingCache> separating_;  // per candidate pair
    std::vector<std::int32_t> contact_begin_;  // per candidate pair and one more: its first contact
    /// The contacts, per chunk of `grain_` candidates. They stay where the thread that found them wrote them.
    std::vector<std::vector<FoundContact>> found_;
    std::int64_t grain_{1};
    std::vector<std::int32_t> chunk_begin_;  // per chunk: contacts in the chunks before it
    std::vector<const ContactRow*> rows_;    // into found_
    std::vector<std::uint8_t> is_carried_;   // per row of the old history
};

}  // namespace riprap::contact
