// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/kernel.hpp"
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
    double volume, depth;  ///< of the sample [m^D], [m]
    Vec3 place, normal;    ///< world
};
inline constexpr std::int32_t still_solid = -1;

/// Joints are between a loose solid and another, or all that is not loose: where a floor meets a wall water goes on.
inline std::int32_t partner_of(const JointMember& member) { return member.is_loose ? member.solid : still_solid; }

/// Share of what is open at a wall that moving water fills with particles, at least.
inline constexpr double well_filled = 0.85;

/// Link between two members i and j, with faces as they are or brought together.
struct JointLink {
    Vec3 apart;    ///< x_i - x_j, or the same + s n_ij, see JointPressure [m]
    double slope;  ///< (dW/dr)/r there; 0 = not in reach
};

/// Between opposite faces.
struct JointGap {
    Vec3 across;   ///< n_ij, unit
    double width;  ///< negative where they overlap [m]
};

/// Kernel and limits of the search for links, made once for many.
class JointKernel {
 public:
    explicit JointKernel(const fluid::ParticleSettings& settings);
    /// Distance from which on two samples do nothing to each other, brought together or not [m]. Deeper layers of faces
    /// 1.5 to 2 spacings apart would be within the support from a little farther, by less than 1e-4 of the kernel's
    /// slope.
    static double reach(const fluid::ParticleSettings& settings);
    /// @param square  |apart|^2 [m^2]
    JointLink link(const Vec3& apart, double square) const {
        return {apart, square < square_of_support_ ? kernel_.slope_over_r(std::sqrt(square)) : 0};
    }
    /// Tells whether the faces of two samples face each other.
    static bool are_facing(const JointMember& i, const JointMember& j) { return dot(i.normal, j.normal) < -0.5; }
    /// Nothing where faces do not face each other or are too far apart to share a joint.
    std::optional<JointGap> gap(const JointMember& i, const JointMember& j, const JointLink& link) const {
        return are_facing(i, j) ? gap_of_facing(i, j, link) : std::nullopt;
    }
    /// The link with such faces brought together as far as they are to feel the joint, by s: see JointPressure.
    JointLink closed(const JointLink& link, const JointGap& gap) const;
    /// The link with such faces brought together until they touch.
    JointLink touching(const JointLink& link, const JointGap& gap) const;

 private:
    std::optional<JointGap> gap_of_facing(const JointMember& i, const JointMember& j, const JointLink& link) const;
    JointLink nearer(const JointLink& link, const Vec3& shift) const;

    fluid::WendlandC2 kernel_;
    double square_of_support_, farthest_, spacing_;
};

/// Which samples of different solids are within JointKernel::reach of each other. Listed with a skin and kept while no
/// sample has moved half of it; what is handed out is chosen from the list by the distance at hand, so nothing depends
/// on when it was listed.
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
    /// Tells whether is(j) holds for any member j of other solids that member i may meet.
    template <class F>
    bool may_meet(std::size_t i, const F& is) const {
        for (const std::int32_t pair : pairs_of(i)) {
            if (is(member_of(pair))) {
                return true;
            }
        }
        return false;
    }
    /// f(j, x_i - x_j, |x_i - x_j|^2) for all members j of other solids within JointKernel::reach of member i,
    /// ascending.
    template <class F>
    void for_each_met(std::size_t i, const F& f) const {
        visit<false>(i, [&](std::size_t j, const Vec3& apart, double square) { f(j, apart, square); });
    }
    /// The same, but only for those within the support of each other or with opposite faces: half of
    /// them. No other pair is part of a joint.
    template <class F>
    void for_each_joined(std::size_t i, const F& f) const {
        const JointMember& member = members_[i];
        visit<true>(i, [&](std::size_t j, const Vec3& apart, double square) {
            if (square < square_of_support_ || JointKernel::are_facing(member, members_[j])) {
                f(j, apart, square);
            }
        });
    }
    std::size_t bytes() const;

 private:
    static std::size_t member_of(std::int32_t pair) { return static_cast<std::size_t>(pair / 2); }
    std::span<const std::int32_t> pairs_of(std::size_t i) const {
        return std::span(pairs_).subspan(static_cast<std::size_t>(pair_begin_[i]),
                                         static_cast<std::size_t>(pair_begin_[i + 1] - pair_begin_[i]));
    }
    template <bool OnlyJoined, class F>
    void visit(std::size_t i, const F& f) const {
        const Vec3 place = members_[i].place;
        for (const std::int32_t pair : pairs_of(i)) {
            if (OnlyJoined && pair % 2 == 0) {
                continue;  // without a look at the member: that is most of the time
            }
            const std::size_t j = member_of(pair);
            const Vec3 apart = nearest_(place - members_[j].place);
            const double square = norm_squared(apart);
            if (square < square_of_reach_) {
                f(j, apart, square);
            }
        }
    }
    bool is_up_to_date(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                       const fluid::BoundaryParticles& walls, double spacing) const;
    void find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::ParticleSettings& settings);
    void place_members(const SampleView& near, const body::Motion& motion, const fluid::BoundaryParticles& walls);
    void find_pairs(const fluid::ParticleSettings& settings);
    void find_who_is_at_joints();

    fluid::NearestImage nearest_{fluid::Domain{}};
    double square_of_reach_{0}, square_of_support_{0};  ///< [m^2]
    std::vector<JointMember> members_;
    std::vector<std::uint8_t> is_at_joint_;  ///< of each member
    std::vector<std::int64_t> pair_begin_;   ///< of each member in pairs_, one more at the end
    std::vector<std::int32_t> pairs_;        ///< twice the members of other solids, skin included, ascending; and 1
                                             ///< where the two may be joined
    std::vector<Vec3> paired_at_;            ///< places of all samples then; empty = nothing found yet [m]
    std::vector<Pose> posed_at_;             ///< of all bodies then
};

}  // namespace riprap::coupling
