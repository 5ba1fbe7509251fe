// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/joints/joint_lanes.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::coupling {

/// Distances of pairs of samples in joints [m].
struct JointKernelLimits {
    double support, spacing;
    static constexpr double most_gap = 2;  ///< spacings
    double gap;    ///< of faces that share a joint, at most: in wider gaps there is room for water
    double reach;  ///< from which on two samples do nothing to each other, brought together or not. Deeper layers of
                   ///< faces 1.5 to 2 spacings apart would be within the support from a little farther, by less than
                   ///< 1e-4 of the kernel's slope

    explicit JointKernelLimits(const fluid::ParticleSettings& settings)
        : support(settings.support_radius()),
          spacing(settings.spacing),
          gap(most_gap * settings.spacing),
          reach(settings.support_radius() + 1.5 * settings.spacing) {}
};

/// Sixteen pairs of samples i and j of two solids.
template <class Real>
struct JointLanes {
    std::array<Sixteen<Real>, 3> apart;  ///< d = x_i - x_j [m]
    Sixteen<Real> square;                ///< its square [m^2]; far away for no pair
};
/// Gaps between those faces that look at each other: n_i . n_j < -1/2.
template <class Real>
struct JointGaps {
    std::uint32_t bits;                           ///< those narrow enough to share a joint; 0: nothing else is there
    std::uint32_t open;                           ///< those of them with room between, which brings them together
    WideMask<Real, fluid::lane_count> are_there;  ///< `bits` as a mask
    std::array<Sixteen<Real>, 3> across;          ///< n_ij, unit
    Sixteen<Real> width;                          ///< negative where they overlap [m]
};
/// Links with such faces brought together.
template <class Real>
struct JointLinks {
    std::array<Sixteen<Real>, 3> apart;
    Sixteen<Real> slope;
};

template <class Real>
inline Sixteen<Real> dot(const std::array<Sixteen<Real>, 3>& a, const std::array<Sixteen<Real>, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Kernel and limits of joints, made once for many.
template <class Real>
class JointKernel {
 public:
    using Lanes = Sixteen<Real>;
    explicit JointKernel(const fluid::ParticleSettings& settings)
        : kernel_(settings.smoothing_length(), settings.domain.dimension), limits_(settings) {}

    /// Tells whether some pair is within the support.
    bool do_meet(const JointLanes<Real>& pairs) const {
        return bits_below(pairs.square, Lanes(limits_.support * limits_.support)) != 0;
    }
    /// (dW/dr)/r of all pairs; 0 beyond the support.
    Lanes slope(const JointLanes<Real>& pairs) const { return kernel_.slope_over_r(root(pairs.square)); }
    /// Most fours look elsewhere, so that most of the time goes to the others.
    /// @param depth  of i and j together
    JointGaps<Real> gaps(const JointLanes<Real>& pairs, const std::array<Lanes, 3>& own_normal,
                         const std::array<Lanes, 3>& other_normal, Lanes depth) const {
        JointGaps<Real> gaps;
        auto may_be = dot(own_normal, other_normal) < Lanes(-0.5);
        may_be = may_be & (pairs.square < Lanes(limits_.reach * limits_.reach));
        gaps.bits = bits_of<Real>(may_be);
        gaps.open = 0;
        if (gaps.bits == 0) {
            return gaps;
        }
        std::array<Lanes, 3> both;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            both[axis] = own_normal[axis] - other_normal[axis];
        }
        const Lanes per_length = inverse_root(max(dot(both, both), Lanes(1)));  // 3 where they look at each other
        for (std::size_t axis = 0; axis < 3; ++axis) {
            gaps.across[axis] = per_length * both[axis];
        }
        gaps.width = -dot(pairs.apart, gaps.across) - depth;
        gaps.are_there = may_be & (gaps.width < Lanes(limits_.gap));
        gaps.bits = bits_of<Real>(gaps.are_there);
        gaps.open = gaps.bits & bits_below(Lanes(0), gaps.width);
        return gaps;
    }
    /// Links with such faces brought together as far as they are to feel the joint, by s: see JointPressure.
    JointLinks<Real> closed(const JointLanes<Real>& pairs, const JointGaps<Real>& gaps) const {
        return nearer(pairs, shift_of(gaps), gaps);
    }
    /// The same with faces brought together whole, by `shift`.
    JointLinks<Real> nearer(const JointLanes<Real>& pairs, Lanes shift, const JointGaps<Real>& gaps) const {
        std::array<Lanes, 3> apart;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            apart[axis] = pairs.apart[axis] + shift * gaps.across[axis];
        }
        return {apart, kernel_.slope_over_r(root(dot(apart, apart)))};
    }
    /// Bits of those that closed() brings within the support.
    std::uint32_t do_closed_meet(const JointLanes<Real>& pairs, const JointGaps<Real>& gaps) const {
        const Lanes shift = shift_of(gaps);
        Lanes square(0);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Lanes apart = pairs.apart[axis] + shift * gaps.across[axis];
            square += apart * apart;
        }
        return gaps.bits & bits_below(square, Lanes(limits_.support * limits_.support));
    }

 private:
    /// s
    Lanes shift_of(const JointGaps<Real>& gaps) const {
        const Lanes room = min(gaps.width, Lanes(limits_.gap) - gaps.width);
        return min(max(room, Lanes(0)), Lanes(limits_.spacing));
    }

    fluid::WendlandC2 kernel_;
    JointKernelLimits limits_;
};

}  // namespace riprap::coupling
