// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/penalty.hpp"

#include <algorithm>

namespace riprap::contact {

PenaltyAnswer penalty(const JointLaws& law, const PenaltySprings& springs, const PenaltyMotion& motion) {
    PenaltyAnswer answer;
    const double strength = motion.is_intact ? springs.tension : 0;
    const double elastic = -springs.normal_stiffness * motion.gap;
    if (motion.gap > 0 && elastic < -strength) {
        answer.is_open = true;
        return answer;
    }
    const double closing = dot(motion.velocity, motion.normal);
    // A dashpot may take the push away but must not pull.
    const double total = elastic + springs.normal_damping * closing;
    answer.normal_force = motion.gap > 0 ? elastic : std::max(total, 0.0);
    answer.dashpot = motion.gap > 0 ? Vec3{} : (elastic - answer.normal_force) * motion.normal;
    answer.energy = 0.5 * springs.normal_stiffness * motion.gap * motion.gap;

    const Vec3 sliding = motion.velocity - closing * motion.normal;
    const Vec3 old_slip = motion.slip - dot(motion.slip, motion.normal) * motion.normal;
    const Vec3 trial = old_slip + motion.time * sliding;
    const double cohesion = motion.is_intact ? springs.cohesion : 0;
    const double limit = shear_strength(law, {answer.normal_force, springs.friction, cohesion});
    const double size = springs.shear_stiffness * norm(trial);
    answer.is_sliding = size > limit;
    answer.plastic_slip = motion.is_intact ? motion.plastic_slip : 0;
    if (answer.is_sliding && motion.is_intact) {
        answer.plastic_slip += norm(trial) - limit / springs.shear_stiffness;
    }
    answer.is_intact = motion.is_intact && answer.plastic_slip <= springs.bond_slip;
    Vec3 shear{};
    if (answer.is_sliding) {
        if (motion.is_intact && motion.gap > 0) {
            answer = {};
            answer.is_open = true;
            return answer;
        }
        const bool breaks = motion.is_intact && !answer.is_intact;
        const double friction = breaks ? shear_strength(law, {answer.normal_force, springs.friction, 0}) : limit;
        answer.slip = (friction / size) * trial;
        shear = -springs.shear_stiffness * answer.slip;
        const double half = 0.5 * springs.shear_stiffness;
        answer.friction_loss = breaks ? half * (norm_squared(trial) - norm_squared(answer.slip))
                                      : half * dot(old_slip + answer.slip, trial - answer.slip);
    } else {
        answer.slip = trial;
        const Vec3 elastic_shear = -springs.shear_stiffness * trial;
        shear = elastic_shear - springs.shear_damping * sliding;
        const double damped = norm(shear);
        shear = damped > limit && damped > 0 ? (limit / damped) * shear : shear;
        answer.dashpot += shear - elastic_shear;
    }
    answer.energy += 0.5 * springs.shear_stiffness * norm_squared(answer.slip);
    answer.force = shear - answer.normal_force * motion.normal;
    return answer;
}

}  // namespace riprap::contact
