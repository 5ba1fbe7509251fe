// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joints/placed_fours.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/sweep/box_tree.hpp"

namespace riprap::coupling {

/// Marks the bodies between which joints are looked for.
struct JointSolids {
    std::span<const std::uint8_t> is_still;  ///< per body: never moves; all of these are one solid
    std::span<const std::uint8_t> is_loose;  ///< per body: forces move it, now or once it is released
};

/// A joint: all that a loose solid shares with another loose one, or with everything that is not loose. Where a floor
/// meets a wall water goes on.
struct Joint {
    std::int32_t high, low;   ///< partners, the higher first; still_solid: all that is not loose
    std::int32_t first_side;  ///< of JointPairs::sides; the last one is before the first of the next joint
};
/// Four samples that may have part in a joint.
struct JointSide {
    std::int32_t four;   ///< number in JointPairs::fours
    std::int32_t joint;  ///< number in JointPairs::joints
};

/// A group of four samples as a member of a unit.
struct JointSlot {
    std::int32_t four;
    std::int32_t unit;   ///< number in JointPairs::units
    std::int32_t side;   ///< number in JointPairs::sides; -1 where the unit is of no joint
    std::uint8_t lanes;  ///< a bit for each sample of the solid
};
/// A pair of fours, by their places among the slots of a unit: those of the own solid, and those of the other.
struct JointEntry {
    std::uint32_t both;
    std::uint32_t own() const { return both >> 25U; }
    std::uint32_t other() const { return both & 0x1FFFFFFU; }
};
/// Fours of a solid that follow each other, and all of another solid near them: what is summed in one go. Where units
/// are cut depends on the numbers of samples alone.
struct JointUnit {
    std::int32_t own_solid, other_solid;  ///< the higher one, and the lower one
    std::int32_t joint;                   ///< number in JointPairs::joints; -1: neither solid is loose
    std::int32_t first_slot, own_count, other_count;
    std::int64_t first_met, first_joined;  ///< entries, up to the first ones of the next unit
};

/// Which samples of different solids are within JointKernel::reach of each other, four by four, each pair of them once.
/// Listed with a skin that follows from how fast samples move, and kept while none has moved half of it. Sums add zero
/// for pairs that are listed in vain, in an order that is that of the samples, so nothing depends on when the list was
/// made.
class JointPairs {
 public:
    JointPairs();
    /// Reach of the search for members about loose bodies; periods of the domain must be at least twice that [m].
    /// @param has_driven  some body is driven: what it shuts off is looked for too
    static double reach(const fluid::ParticleSettings& settings, bool has_driven);

    /// Brings fours and pairs up to date with where samples are.
    void update(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
                const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings);
    /// Call where `near` is no longer the same.
    void forget() { paired_at_.clear(); }

    /// Samples that may meet those of another solid, in fours: all of loose bodies, and of others those near a loose
    /// one. Ascending; some are there for the skin only.
    const std::vector<JointFour>& fours() const { return fours_; }
    const std::vector<PlacedFour<float>>& placed() const { return placed_; }
    const fluid::FixedPoint& fixed() const { return fixed_; }

    const std::vector<Joint>& joints() const { return joints_; }
    std::span<const JointSide> sides() const { return sides_; }
    std::span<const JointSide> sides_of(std::size_t joint) const {
        const std::size_t end = joint + 1 < joints_.size() ? at(joints_[joint + 1].first_side) : sides_.size();
        return std::span(sides_).subspan(at(joints_[joint].first_side), end - at(joints_[joint].first_side));
    }
    /// Ascending by own solid, number of the first sample and other solid.
    const std::vector<JointUnit>& units() const { return units_; }
    const std::vector<JointSlot>& slots() const { return slots_; }
    /// Slots of a four, in the order of the units.
    std::span<const std::int32_t> slots_of(std::size_t four) const {
        return std::span(slots_of_fours_)
            .subspan(at(first_of_four_[four]), at(first_of_four_[four + 1] - first_of_four_[four]));
    }
    /// Pairs that may be within JointKernel::reach of each other, ascending.
    std::span<const JointEntry> met(std::size_t unit) const {
        return entries_of(met_, units_[unit].first_met,
                          unit + 1 < units_.size() ? units_[unit + 1].first_met : std::ssize(met_));
    }
    /// Lists those of them that may be within the support or have opposite faces: half. No other pair is part of a
    /// joint.
    std::span<const JointEntry> joined(std::size_t unit) const {
        return entries_of(joined_, units_[unit].first_joined,
                          unit + 1 < units_.size() ? units_[unit + 1].first_joined : std::ssize(joined_));
    }
    /// Tells whether a solid of which some samples are here is driven: neither still nor loose.
    bool has_driven() const { return has_driven_; }
    std::size_t bytes() const;

 private:
    struct Search;

    static std::span<const JointEntry> entries_of(const std::vector<JointEntry>& all, std::int64_t first,
                                                  std::int64_t end) {
        return std::span(all).subspan(at(first), at(end - first));
    }
    bool has_turned(const body::Motion& motion) const;
    double farthest_way(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls) const;
    bool keep(const SampleView& near, const JointSolids& solids, const body::Motion& motion,
              const fluid::BoundaryParticles& walls, double spacing);
    void find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::ParticleSettings& settings);
    void find_pairs(const fluid::BoundaryParticles& walls, const fluid::ParticleSettings& settings);
    void list_joints();
    void list_slots_of_fours();

    fluid::FixedPoint fixed_;
    std::vector<JointFour> fours_;
    std::vector<PlacedFour<float>> placed_;
    std::vector<Joint> joints_;
    std::vector<JointSide> sides_;
    std::vector<JointUnit> units_;
    std::vector<JointSlot> slots_;
    std::vector<JointEntry> met_, joined_;
    std::vector<std::int32_t> first_of_four_, slots_of_fours_;
    std::vector<Vec3> paired_at_;  ///< places of all samples then; empty = nothing found yet [m]
    std::vector<Pose> posed_at_;   ///< of all bodies then
    double skin_;                  ///< of the lists [spacings]
    std::int64_t age_{0};          ///< updates since they were made
    bool has_driven_{false};
};

}  // namespace riprap::coupling
