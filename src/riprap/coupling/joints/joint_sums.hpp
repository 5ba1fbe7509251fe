// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums over pairs of samples in joints, unit by unit; in float, or in double for plain sums.

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joints/joint_kernel.hpp"
#include "riprap/coupling/joints/joint_pairs.hpp"

namespace riprap::coupling {

/// Solids about the four of a slot: sums over the other solid of the unit.
template <class Real>
struct AroundSlot {
    std::array<Four<Real>, 4> sums{};  ///< G_others in x, y and z; what water between faces adds when it fills the gap,
                                       ///< along the normal of the sample [1/m]
    Four<Real> gap{};                  ///< to the nearest face that looks at it, or `far` [m]
};
/// Says what a slot holds of the sums of a step. Most hold nothing: solids are listed that are near each other, but
/// whose faces are apart.
struct SlotMark {
    static constexpr std::uint8_t meets = 15;  ///< a bit for each sample that shares a joint with the other solid
    static constexpr std::uint8_t around = 16, felt = 32, force = 64;  ///< an AroundSlot, FeltSlot, ForceSlot
};
/// Holds what four samples feel of the water.
template <class Real>
struct FeltFour {
    Four<Real> weight{}, felt{};  ///< see JointWater
    bool is_felt{false};          ///< some weight is not zero
    bool is_asked{false};         ///< some want to know what is felt about them
};
template <class Real>
using FeltSlot = std::array<Four<Real>, 2>;  ///< sums of weights, and of weights times felt pressures
/// Four samples as parts of a joint.
template <class Real>
struct SideFour {
    Four<Real> pressure{}, left_to_do{};  ///< p and u, see JointPressure [Pa], [-]
};
template <class Real>
using ForceSlot = std::array<Four<Real>, 4>;  ///< force over -V in x, y and z; nothing [N/m^3]
/// Four pieces of the rim of a joint.
template <class Real>
struct RimFour {
    std::array<Four<std::int32_t>, 3> place{};
    Four<Real> all{}, wet{}, pushed{};  ///< s V (c + e (1 - c)), s V c and that times the pressure there
};

template <class Real>
class JointSums {
 public:
    JointSums(const JointPairs& pairs, std::span<const PlacedFour<Real>> placed,
              const fluid::ParticleSettings& settings, const Vec3& gravity);

    /// Gap without a face [m].
    Real far() const { return static_cast<Real>(4 * limits_.reach); }
    /// Each of these writes what is found at the slots of a unit, and marks those slots.
    /// @param marks  of its slots, none at first
    void look_around(std::size_t unit, std::span<AroundSlot<Real>> slots, std::span<std::uint8_t> marks) const;
    void feel(std::size_t unit, std::span<const FeltFour<Real>> felt, std::span<FeltSlot<Real>> slots,
              std::span<std::uint8_t> marks) const;
    /// @param marks  those of look_around
    void push(std::size_t unit, std::span<const SideFour<Real>> sides, std::span<ForceSlot<Real>> slots,
              std::span<std::uint8_t> marks) const;
    /// A bit for each sample within JointKernel's reach of the other solid.
    void reach(std::size_t unit, std::span<std::uint32_t> slots) const;
    /// Returns the pressure that a rim gives four samples.
    Four<Real> pressure(std::size_t four, std::span<const RimFour<Real>> rim) const;

 private:
    using Lanes = Sixteen<Real>;
    struct Own;

    /// Calls begin(slot), meet(slot, four) and end(slot) for entries of one own slot after the other; those of a slot
    /// are left out where begin returns false.
    template <class Begin, class Meet, class End>
    void for_each_entry(const JointUnit& unit, std::span<const JointEntry> entries, const Begin& begin,
                        const Meet& meet, const End& end) const;
    Own own_of(const JointSlot& slot) const;
    std::array<Lanes, 3> apart(const Own& own, const PlacedFour<Real>& other) const;
    JointLanes<Real> lanes_of(const Own& own, const JointSlot& other) const;

    const JointPairs& pairs_;
    std::span<const PlacedFour<Real>> placed_;
    JointKernelLimits limits_;
    JointKernel<Real> kernel_;
    std::array<Lanes, 3> quantum_, pull_;
    std::array<Four<Real>, 16> far_;  ///< by the bits of those samples that count: 0 for them [m^2]
    Real blur_{0};                    ///< [m^2]
    bool is_planar_;
};

}  // namespace riprap::coupling
