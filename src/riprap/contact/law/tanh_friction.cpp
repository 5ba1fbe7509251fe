// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/tanh_friction.hpp"

#include "riprap/contact/law/normal_push.hpp"
#include "riprap/core/key.hpp"

namespace riprap::contact {

KeyList<TanhFriction> TanhFriction::keys() {
    return {key::number(&TanhFriction::speed, "friction_speed", dimension::velocity, key::positive(),
                        "Speed scale of the tanh friction.")};
}

LinearContact TanhFriction::respond(const NormalContact& normal, const material::PairProperties& pair,
                                    const ContactKinematics& kinematics, const ShearState* before, ShearState& after,
                                    ContactRow& row) const {
    const NormalPush push = push_along_normal(normal, pair, kinematics);
    // Never more than what takes half of the sliding speed in a step.
    const double dt = kinematics.sliding_time, most = dt > 0 ? 0.5 * kinematics.tangential_mass / dt : 0;
    const Vec3 force = tanh_friction(push.sliding, 0.0, most, push.force, pair.friction, speed, dt).force;
    after = {push.n, {}, 0, 0, normal.point};
    fill_row(normal, push, force, force, kinematics, row);
    row.friction_loss = before != nullptr ? before->shear_energy : 0;  // of a spring that another law left
    return {.normal_stiffness = normal.stiffness,
            .normal_damping = push.damping,
            .shear_damping = std::min(most, pair.friction * push.force / speed)};
}

}  // namespace riprap::contact
