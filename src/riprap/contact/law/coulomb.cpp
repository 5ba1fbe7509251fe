// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/coulomb.hpp"

#include <algorithm>
#include <numbers>

#include "riprap/contact/law/normal_push.hpp"

namespace riprap::contact {

namespace {

/// Turns the spring force with the contact: first by the rotation that takes the old normal into the new one,
/// R = I + [w]x + [w]x^2/(1 + n_old.n), w = n_old x n; then about n by `spin` [rad]; the result lies in the new
/// tangent plane and has its old length.
Vec3 turn_with_contact(const Vec3& force, const Vec3& old_normal, const Vec3& normal, double spin) {
    const double length = norm(force);
    const double cosine = dot(old_normal, normal);
    if (length == 0 || cosine < -0.99) {
        return {};  // the normal has flipped: the old direction means nothing
    }
    const Vec3 w = cross(old_normal, normal);
    const Vec3 wf = cross(w, force);
    Vec3 turned = force + wf + cross(w, wf) / (1 + cosine);
    turned += spin * cross(normal, turned);
    turned -= dot(turned, normal) * normal;
    const double turned_length = norm(turned);
    return turned_length > 0 ? (length / turned_length) * turned : Vec3{};
}

/// Factor that brings a trial force to its limit [-].
double cut_off(double trial, double limit) { return trial <= limit ? 1 : limit / trial; }

/// Springs after a step. friction_loss [J] leaves through friction: what the springs held, plus the work done on
/// them, minus what they hold afterwards. The ledger sees a force before and after the motion x and books their mean:
/// W = -(f_old + f_new).x / 2 with x = (f_old - f_trial)/k. So sliding, a strength that falls under a loaded spring,
/// and a stiffness that changes with the patch are all accounted for, to round-off. The shift of the anchor by
/// sliding while the pair spins is not: half of f times that shift times the turn of the step.
struct SpringResult {
    double friction_loss;
    bool is_sliding;
    double anchor_couple;  ///< of the tangential spring about the point of action, along n [N m]
};

/// Place of the tangential spring against the point of action [m], in the tangent plane: it goes with the mean motion
/// of both bodies.
Vec3 carry_anchor(const ShearState& before, const Vec3& point, const Vec3& n, const ContactKinematics& kinematics) {
    const Vec3 arm = before.anchor - point;
    const Vec3 moved = arm + kinematics.sliding_time * (kinematics.mean_velocity + cross(kinematics.mean_spin, arm));
    return moved - dot(moved, n) * n;
}

/// Stiffness and strength of a contact across its normal in this step.
struct Tangential {
    double stiffness;  ///< K_s [N/m]
    double strength;   ///< largest force [N]
    double torsion_stiffness;
};

Tangential tangential(const NormalContact& normal, const material::PairProperties& pair, double normal_force) {
    const double stiffness = pair.shear_stiffness > 0 ? pair.shear_stiffness : pair.shear_ratio * normal.stiffness;
    const double strength = normal_force * pair.friction + pair.cohesion * normal.area;
    if (strength <= 0 || stiffness <= 0) {
        return {};
    }
    return {stiffness, strength, pair.has_torsion ? stiffness * normal.area / (2 * std::numbers::pi) : 0};
}

SpringResult advance_springs(const NormalContact& normal, const Tangential& shear, double friction,
                             const ContactKinematics& kinematics, const Vec3& sliding_at_point,
                             const ShearState* before, ShearState& after) {
    double friction_loss = before != nullptr ? before->shear_energy : 0;
    if (shear.strength <= 0) {
        return {friction_loss, false, 0};
    }
    const Vec3& n = after.normal;
    const double dt = kinematics.sliding_time, stiffness = shear.stiffness;
    const double mean_turn = dot(kinematics.mean_spin, n) * dt;
    const bool is_anchored = before != nullptr && shear.torsion_stiffness > 0;
    Vec3 arm = is_anchored ? carry_anchor(*before, normal.point, n, kinematics) : Vec3{};
    const Vec3 sliding = sliding_at_point + dot(kinematics.relative_spin, n) * cross(n, arm);
    const Vec3 old_force =
        before != nullptr ? turn_with_contact(before->shear_force, before->normal, n, mean_turn) : Vec3{};
    const Vec3 trial = old_force - (stiffness * dt) * sliding;
    const double share = cut_off(norm(trial), shear.strength);
    after.shear_force = share * trial;
    after.shear_energy = norm_squared(after.shear_force) / (2 * stiffness);
    friction_loss += dot(old_force + after.shear_force, trial - old_force) / (2 * stiffness) - after.shear_energy;

    double couple = 0;
    if (shear.torsion_stiffness > 0) {
        const double limit = friction * normal.spin_moment;
        couple = share * dot(n, cross(arm, after.shear_force));
        const double kept = share * cut_off(std::abs(couple), limit);
        couple *= cut_off(std::abs(couple), limit);
        after.anchor = normal.point + kept * arm;
        const double old_torsion = before != nullptr ? before->torsion : 0;
        const double trial_torsion = old_torsion - shear.torsion_stiffness * dot(kinematics.relative_spin, n) * dt;
        after.torsion = std::clamp(trial_torsion, -limit - couple, limit - couple);
        const double energy = after.torsion * after.torsion / (2 * shear.torsion_stiffness);
        after.shear_energy += energy;
        friction_loss +=
            (old_torsion + after.torsion) * (trial_torsion - old_torsion) / (2 * shear.torsion_stiffness) - energy;
    }
    return {friction_loss, share < 1, couple};
}

/// The share of `damping_force` that a spring force within its limit can bear: the largest s <= 1 with |spring + s
/// damping_force| <= strength.
double share_within(const Vec3& spring, const Vec3& damping_force, double strength) {
    const double a = norm_squared(damping_force), b = dot(spring, damping_force);
    const double room = std::max(0.0, strength * strength - norm_squared(spring));
    if (a + 2 * b <= room) {
        return 1;
    }
    // The root of a s^2 + 2 b s = room in the form that loses no digits for either sign of b.
    const double root = std::sqrt(b * b + a * room);
    return std::min(1.0, b > 0 ? room / (b + root) : (root - b) / a);
}

}  // namespace

LinearContact coulomb(const NormalContact& normal, const material::PairProperties& pair,
                      const ContactKinematics& kinematics, const ShearState* before, ShearState& after,
                      ContactRow& row) {
    const NormalPush push = push_along_normal(normal, pair, kinematics);
    const Vec3 &n = push.n, &sliding = push.sliding;
    LinearContact linear{.normal_stiffness = normal.stiffness, .normal_damping = push.damping};
    const Tangential shear = tangential(normal, pair, push.force);
    linear.shear_stiffness = shear.stiffness;
    linear.torsion_stiffness = shear.torsion_stiffness;
    after = {n, {}, 0, 0, normal.point};
    const SpringResult springs = advance_springs(normal, shear, pair.friction, kinematics, sliding, before, after);
    if (shear.torsion_stiffness > 0) {  // a spring that acts beside the point resists spin about it
        linear.torsion_stiffness += shear.stiffness * norm_squared(after.anchor - normal.point);
    }

    Vec3 damping_force{};
    if (pair.damping_ratio > 0 && shear.stiffness > 0) {
        linear.shear_damping = 2 * pair.damping_ratio * std::sqrt(kinematics.tangential_mass * shear.stiffness);
        if (!springs.is_sliding) {
            damping_force = -linear.shear_damping * sliding;
            damping_force = share_within(after.shear_force, damping_force, shear.strength) * damping_force;
        }
    }
    const Vec3 tangential_force = after.shear_force + damping_force;

    double damping_couple = 0;
    if (pair.damping_ratio > 0 && shear.torsion_stiffness > 0) {
        linear.torsion_damping = 2 * pair.damping_ratio * std::sqrt(kinematics.twist_inertia * shear.torsion_stiffness);
        const double limit = pair.friction * normal.spin_moment;
        const double held = after.torsion + springs.anchor_couple;
        const double wanted = held - linear.torsion_damping * dot(kinematics.relative_spin, n);
        damping_couple = std::clamp(wanted, -limit, limit) - held;
    }

    fill_row(normal, push, tangential_force, damping_force, kinematics, row);
    row.moment = normal.moment + (after.torsion + springs.anchor_couple + damping_couple) * n;
    row.friction_loss = springs.friction_loss;
    const Vec3 dashpot = damping_force - (push.force - push.elastic) * n, dashpot_couple = damping_couple * n;
    row.dashpot_couple = narrow(dashpot_couple);
    row.dashpot_power =
        static_cast<float>(dot(dashpot, kinematics.relative_velocity) + dot(dashpot_couple, kinematics.relative_spin));
    row.is_sliding = springs.is_sliding ? 1 : 0;
    return linear;
}

}  // namespace riprap::contact
