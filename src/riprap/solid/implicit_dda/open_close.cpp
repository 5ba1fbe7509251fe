// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/open_close.hpp"

#include <algorithm>

namespace riprap::solid::implicit_dda {

double strength(const contact::JointLaws& law, const ContactSprings& springs, const ContactTrial& trial) {
    return shear_strength(law, {-springs.normal * trial.gap, springs.friction, trial.is_intact ? springs.cohesion : 0});
}

bool update_mode(const ContactSprings& springs, const OpenCloseRule& rule, ContactTrial& trial) {
    const ContactMode before = trial.mode;
    const double limit = strength(rule.law, springs, trial);
    const double tension = trial.is_intact && springs.normal > 0 ? springs.tension / springs.normal : 0;
    const auto lock_or_slide = [&] {
        return springs.shear * norm(trial.slip) > limit ? ContactMode::slide : ContactMode::lock;
    };
    switch (before) {
        case ContactMode::open:
            trial.mode = trial.gap < -rule.close_tolerance ? lock_or_slide() : ContactMode::open;
            break;
        case ContactMode::slide: {
            const bool is_slow = rule.slide_tolerance >= 0 && norm(trial.step_slip) <= rule.slide_tolerance;
            const bool is_held = springs.shear * norm(trial.slip) < limit || dot(trial.slip, trial.direction) < 0;
            trial.mode = trial.gap > rule.open_tolerance                          ? ContactMode::open
                         : (is_slow || is_held) && limit > 0 && !trial.has_locked ? ContactMode::lock
                                                                                  : ContactMode::slide;
            trial.has_locked = trial.has_locked || trial.mode == ContactMode::lock;
            break;
        }
        case ContactMode::lock:
            trial.mode = trial.gap > rule.open_tolerance + tension ? ContactMode::open : lock_or_slide();
            break;
    }
    if (trial.mode == ContactMode::slide) {
        const double size = norm(trial.slip);
        if (size > 1e-14 && !(before == ContactMode::slide && dot(trial.slip, trial.direction) < 0)) {
            trial.direction = trial.slip / size;
        }
        trial.friction = limit;
        trial.residual = shear_strength(rule.law, {-springs.normal * trial.gap, springs.friction, 0});
        trial.across = size > 1e-14 ? std::min(limit / size, springs.shear) : springs.shear;
    }
    return trial.mode != before;
}

}  // namespace riprap::solid::implicit_dda
