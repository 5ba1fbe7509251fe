// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/contact/broadphase/giants.hpp"
#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/law/coulomb.hpp"
#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/material/material_set.hpp"

namespace riprap::contact {

/// What the contact pipeline reads: all const, or fixed for the step.
struct ContactScene {
    const geometry::ShapeSet& shapes;
    const material::MaterialSet& materials;
    const body::BodySet& bodies;
    DistancePotentialOptions narrowphase;
    double grid_factor;  ///< gamma of the multi-level grid [-]
    double skin;         ///< of the pair cache, as a fraction of the median circumradius [-]
};

/// Forces and torques of all contacts on every body.
struct BodyLoads {
    std::vector<Vec3> force;   ///< [N]
    std::vector<Vec3> torque;  ///< about the centre of mass [N m]
};

/// The stages bounds -> broadphase -> pair cache -> narrowphase -> law -> history, shared by all solids: Scratch.
/// Only touching contacts, in the order of their keys, reach any result; candidates, chunks and caches do not.
class ContactPipeline {
 public:
    /// Puts every part where its body is.
    void place_parts(const ContactScene& scene, const body::BodyState& state);
    /// Brings the candidate pairs up to date. @returns true when they were searched afresh.
    bool find_pairs();
    /// Narrowphase and law on every candidate; `history` is replaced by that of the contacts found now.
    /// @param sliding_time  time since the last evaluation [s]
    /// @returns energy of springs whose contact was lost, dissipated [J]
    double find_contacts(const ContactScene& scene, const body::BodyState& state,
                         const body::BodyKinematics& kinematics, double sliding_time, ContactHistory& history);
    /// Sums the contact loads of every body over its contacts in the order of their keys.
    void gather_loads(const ContactScene& scene, const body::BodyState& state, BodyLoads& loads) const;
    /// Energy the dashpots take in a step of length dt: force times the mean of the closing speeds before and after the
    /// kick, which is what the kick did to the kinetic energy [J]. Call after the kick, `kinematics` still that before.
    double dashpot_loss(const ContactScene& scene, const body::BodyState& state, const body::BodyKinematics& kinematics,
                        const ContactHistory& history, double dt) const;
    /// Largest sum of Gershgorin terms over the contacts of one body, an upper bound of omega^2 [1/s^2].
    double gershgorin_bound(const ContactScene& scene) const;

    const std::vector<ContactRow>& rows() const { return rows_; }
    std::int64_t pair_count() const { return static_cast<std::int64_t>(cache_.pairs().size()); }
    std::size_t bytes() const;

 private:
    /// What one candidate became, before it finds its place in the sorted contacts.
    struct Record {
        ContactRow row;
        ShearState springs;
        std::int32_t pair;
        std::int32_t old_contact;  ///< row of the last step, -1 = none
    };

    /// The contacts of the last step are those of `history`: nobody has put another State in between.
    bool are_rows_of(const ContactHistory& history) const;
    void map_history(const ContactHistory& history);
    void run_wave(const ContactScene& scene, const body::BodyState& state, const body::BodyKinematics& kinematics,
                  double sliding_time, const ContactHistory& history, std::int64_t begin, std::int64_t end);
    void append_wave(std::int64_t begin, std::int64_t end);

    void describe_parts(const ContactScene& scene);

    PairCache cache_;
    PairCache::Settings cache_settings_;
    std::vector<Giant> giants_;
    std::vector<Frame> frames_;                  // per part
    std::vector<Vec3> centers_;                  // per part
    std::vector<double> radii_;                  // per part
    std::vector<std::int32_t> part_body_;        // per part
    std::vector<std::uint8_t> is_mobile_;        // per part
    std::vector<SeparatingCache> separating_;    // per candidate pair
    std::vector<std::int32_t> contact_of_pair_;  // per candidate pair: row of the last step, -1 = none
    std::vector<Record> wave_;                   // records of the wave in progress
    std::vector<std::int32_t> wave_count_;       // records per chunk of the wave
    std::vector<ContactRow> rows_;
    std::vector<std::uint8_t> is_carried_;  // per row of the old history
    ContactHistory next_;
};

}  // namespace riprap::contact
