// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/coupling/joints/joint_kernel.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::coupling {

/// Who takes part in joints.
struct JointSolids {
    std::span<const std::uint8_t> is_still;  ///< per body: never moves; all of these are one solid
    std::span<const std::uint8_t> is_loose;  ///< per body: forces move it, now or once it is released
};

/// A sample that may meet those of another solid: all of loose bodies, and of others those near a loose one.
struct JointMember {
    std::int32_t sample;
    std::int32_t solid;  ///< number of the body, or still_solid
    bool is_loose;
};
inline constexpr std::int32_t still_solid = -1;

/// Joints are between a loose solid and another, or all that is not loose: where a floor meets a wall water goes on.
inline std::int32_t partner_of(const JointMember& member) { return member.is_loose ? member.solid : still_solid; }

/// Share of what is open at a wall that moving water fills with particles, at least.
inline constexpr double well_filled = 0.85;

/// Which samples of different solids are within JointKernel::reach of each other. Listed with a skin and kept while no
/// sample has moved half of it; what is handed out is chosen from the list by the distance at hand, and comes in fours
/// of samples by their numbers, so nothing depends on when it was listed.
class JointPairs {
 public:
    /// Reach of the search for members about loose bodies; periods of the domain must be at least twice that [m].
    /// @param has_driven  some body is driven: what it shuts off is looked for too
    static double reach(const fluid::ParticleSettings& settings, bool has_driven);

    /// Brings members and pairs up to date with where samples are.
    void update(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings);
    /// Call where `near` is no longer the same.
    void forget() { paired_at_.clear(); }

    /// Ascending by sample; some are there for the skin only.
    const std::vector<JointMember>& members() const { return members_; }
    /// Tells whether member i is of a loose body or meets one. Others have no part in joints but shut off what these
    /// see.
    bool is_at_joint(std::size_t i) const { return is_at_joint_[i] != 0; }
    JointSelf self(std::size_t i) const {
        const auto sample = at(members_[i].sample);
        const SampleFour& four = fours_[sample / four_size];
        const std::size_t lane = sample % four_size;
        return {four.place.lane(lane), four.normal.lane(lane), four.depth[static_cast<std::int64_t>(lane)]};
    }
    double volume(std::size_t i) const {
        const auto sample = at(members_[i].sample);
        return fours_[sample / four_size].volume[static_cast<std::int64_t>(sample % four_size)];
    }
    /// All samples, those that are no members among them.
    const std::vector<SampleFour>& fours() const { return fours_; }

    /// Tells whether member i may meet one of some members of other solids.
    /// @param chosen  of each four, a bit for each of those in it
    bool may_meet(std::size_t i, std::span<const std::uint8_t> chosen) const {
        return std::ranges::any_of(entries_of(i),
                                   [&](std::uint32_t entry) { return (met_of(entry) & chosen[four_of(entry)]) != 0; });
    }
    /// f(number of the four, near) for all fours with members of other solids within JointKernel::reach of member i,
    /// ascending; faces that look at each other are not told of.
    template <class F>
    void for_each_met(std::size_t i, const F& f) const {
        const Vec3 place = self(i).place;
        for (const std::uint32_t entry : entries_of(i)) {
            const std::size_t four = four_of(entry);
            JointFour near = look(place, fours_[four]);
            near.is_there = mask_of(met_of(entry)) & (near.square < Four(square_of_reach_));
            f(four, near);
        }
    }
    /// The same, but only for those within the support of each other or with opposite faces: half of
    /// them. No other pair is part of a joint.
    template <class F>
    void for_each_joined(std::size_t i, const JointSelf& self, const F& f) const {
        for (const std::uint32_t entry : entries_of(i)) {
            if (joined_of(entry) == 0) {
                continue;
            }
            const std::size_t four = four_of(entry);
            JointFour near = look(self.place, fours_[four]);
            near.are_facing = dot(Four3(self.normal), fours_[four].normal) < Four(-0.5);
            near.is_there = mask_of(joined_of(entry)) & (near.square < Four(square_of_reach_)) &
                            ((near.square < Four(square_of_support_)) | near.are_facing);
            if (bits_of(near.is_there) != 0) {
                f(four, near);
            }
        }
    }
    std::size_t bytes() const;

 private:
    // An entry of a list: the number of a four, which of it are met, skin included, and which may be joined.
    static std::uint32_t entry_of(std::size_t sample, bool may_join) {
        const std::uint32_t bit = 1U << (sample % four_size);
        return static_cast<std::uint32_t>(sample / four_size) << 8U | bit << 4U | (may_join ? bit : 0);
    }
    static std::size_t four_of(std::uint32_t entry) { return entry >> 8U; }
    static std::uint32_t met_of(std::uint32_t entry) { return entry >> 4U & 15U; }
    static std::uint32_t joined_of(std::uint32_t entry) { return entry & 15U; }

    std::span<const std::uint32_t> entries_of(std::size_t i) const {
        return std::span(entries_).subspan(at(begin_[i]), at(begin_[i + 1] - begin_[i]));
    }
    JointFour look(const Vec3& place, const SampleFour& four) const {
        JointFour near{};
        near.apart = Four3(place) - four.place;
        if (is_periodic_) {
            for (std::size_t lane = 0; lane < four_size; ++lane) {
                near.apart.set(lane, nearest_(near.apart.lane(lane)));
            }
        }
        near.square = dot(near.apart, near.apart);
        return near;
    }
    bool is_up_to_date(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                       const fluid::BoundaryParticles& walls, double spacing) const;
    void find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::ParticleSettings& settings);
    void place_samples(const SampleView& near, const body::Motion& motion, const fluid::BoundaryParticles& walls);
    void find_pairs(const fluid::ParticleSettings& settings);
    void find_who_is_at_joints();

    fluid::NearestImage nearest_{fluid::Domain{}};
    bool is_periodic_{false};
    double square_of_reach_{0}, square_of_support_{0};  ///< [m^2]
    std::vector<JointMember> members_;
    std::vector<SampleFour> fours_;
    std::vector<std::uint8_t> is_at_joint_;  ///< of each member
    std::vector<std::int64_t> begin_;        ///< of each member in entries_, one more at the end
    std::vector<std::uint32_t> entries_;     ///< ascending
    std::vector<Vec3> paired_at_;            ///< places of all samples then; empty = nothing found yet [m]
    std::vector<Pose> posed_at_;             ///< of all bodies then
};

}  // namespace riprap::coupling
