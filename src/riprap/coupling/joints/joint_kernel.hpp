// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/joints/joint_fours.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::coupling {

/// A sample that looks at others.
struct JointSelf {
    Vec3 place, normal;  ///< world
    double depth;        ///< [m]
};

/// Samples j of other solids within reach of a sample i, four at a time.
struct JointFour {
    Four3 apart;          ///< x_i - x_j [m]
    Four square;          ///< its square [m^2]
    FourMask is_there;    ///< which of them the rest is true of
    FourMask are_facing;  ///< whose faces look at that of i: n_i . n_j < -1/2
};

/// Links between i and j with faces as they are or brought together.
struct JointLinks {
    Four3 apart;  ///< x_i - x_j, or the same + s n_ij, see JointPressure [m]
    Four slope;   ///< (dW/dr)/r there; 0 = not in reach
};

/// Gaps between faces that look at each other.
struct JointGaps {
    bool is_any;         ///< some are; else there is nothing below
    FourMask are_there;  ///< narrow enough to share a joint
    Four3 across;        ///< n_ij, unit
    Four width;          ///< negative where they overlap [m]
};

/// Kernel and limits of joints, made once for many.
class JointKernel {
 public:
    explicit JointKernel(const fluid::ParticleSettings& settings)
        : kernel_(settings.smoothing_length(), settings.domain.dimension),
          spacing_(settings.spacing),
          square_of_support_(settings.support_radius() * settings.support_radius()) {}
    /// Distance from which on two samples do nothing to each other, brought together or not [m]. Deeper layers of faces
    /// 1.5 to 2 spacings apart would be within the support from a little farther, by less than 1e-4 of the kernel's
    /// slope.
    static double reach(const fluid::ParticleSettings& settings) {
        constexpr double farther = 1.5;  // spacings beyond the support from which faces brought together still meet
        return settings.support_radius() + farther * settings.spacing;
    }

    JointLinks link(const JointFour& near) const { return {near.apart, kernel_.slope_over_r(sqrt(near.square))}; }
    /// Most fours look elsewhere, so that most of the time goes to the others.
    JointGaps gaps(const JointSelf& self, const SampleFour& others, const JointFour& near) const {
        const FourMask may_be = near.is_there & near.are_facing;
        if (bits_of(may_be) == 0) {
            return {};
        }
        const Four3 both = Four3(self.normal) - others.normal;
        const Four3 n = (Four(1) / sqrt(dot(both, both))) * both;
        const Four width = -dot(near.apart, n) - (Four(self.depth) + others.depth);
        const FourMask are_there = may_be & (width < Four(most_gap * spacing_));
        return {bits_of(are_there) != 0, are_there, n, width};
    }
    /// Links with such faces brought together as far as they are to feel the joint, by s: see JointPressure.
    JointLinks closed(const JointFour& near, const JointGaps& gaps) const { return nearer(near, shift_of(gaps), gaps); }
    /// Which of them these links reach: their slope is not zero.
    FourMask do_closed_meet(const JointFour& near, const JointGaps& gaps) const {
        const Four3 apart = near.apart + shift_of(gaps) * gaps.across;
        return gaps.are_there & (dot(apart, apart) < Four(square_of_support_));
    }
    /// The same with faces brought together whole.
    JointLinks touching(const JointFour& near, const JointGaps& gaps) const {
        return nearer(near, max(gaps.width, Four(0)), gaps);
    }

 private:
    /// Spacings between faces that share a joint, at most: in wider gaps there is room for water.
    static constexpr double most_gap = 2;

    /// s
    Four shift_of(const JointGaps& gaps) const {
        const Four room = min(gaps.width, Four(most_gap * spacing_) - gaps.width);
        return min(max(room, Four(0)), Four(spacing_));
    }
    JointLinks nearer(const JointFour& near, Four shift, const JointGaps& gaps) const {
        const Four3 apart = near.apart + shift * gaps.across;
        return {apart, kernel_.slope_over_r(sqrt(dot(apart, apart)))};
    }

    fluid::WendlandC2 kernel_;
    double spacing_, square_of_support_;  ///< [m], [m^2]
};

}  // namespace riprap::coupling
