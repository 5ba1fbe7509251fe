// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/law/coulomb.hpp"

#include <algorithm>
#include <numbers>

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

/// A spring loaded to `trial` and cut off at `limit`.
struct Slip {
    double scale;     ///< factor that brings the trial force to the limit [-]
    double distance;  ///< plastic part of the displacement [m] (or [rad])
};

Slip cut_off(double trial, double limit, double stiffness) {
    return trial <= limit ? Slip{1, 0} : Slip{limit / trial, (trial - limit) / stiffness};
}

/// Spring energy that leaves through friction in one step: sliding work, and what the old spring held beyond
/// its energy at today's stiffness (the patch it was stretched over has changed).
struct SpringResult {
    double friction_loss;
    bool is_sliding;
};

SpringResult advance_springs(const NormalContact& normal, const material::PairProperties& pair,
                             const ContactKinematics& kinematics, double closing, double normal_force,
                             const ShearState* before, ShearState& after) {
    const double stiffness = pair.shear_stiffness > 0 ? pair.shear_stiffness : pair.shear_ratio * normal.stiffness;
    const double strength = normal_force * pair.friction + pair.cohesion * normal.area;
    double friction_loss = before != nullptr ? before->shear_energy : 0;
    if (strength <= 0 || stiffness <= 0) {
        return {friction_loss, false};
    }
    const Vec3& n = after.normal;
    const double dt = kinematics.sliding_time;
    const double mean_turn = dot(kinematics.mean_spin, n) * dt;
    const Vec3 old_force =
        before != nullptr ? turn_with_contact(before->shear_force, before->normal, n, mean_turn) : Vec3{};
    const Vec3 trial = old_force - (stiffness * dt) * (kinematics.relative_velocity - closing * n);
    const Slip slip = cut_off(norm(trial), strength, stiffness);
    after.shear_force = slip.scale * trial;
    after.shear_energy = norm_squared(after.shear_force) / (2 * stiffness);
    friction_loss += strength * slip.distance - norm_squared(old_force) / (2 * stiffness);

    const double torsion_stiffness = stiffness * normal.area / (2 * std::numbers::pi);
    if (pair.has_torsion && torsion_stiffness > 0) {
        const double old_torsion = before != nullptr ? before->torsion : 0;
        const double trial_torsion = old_torsion - torsion_stiffness * dot(kinematics.relative_spin, n) * dt;
        const double limit = pair.friction * normal.spin_moment;
        const Slip spin = cut_off(std::abs(trial_torsion), limit, torsion_stiffness);
        after.torsion = spin.scale * trial_torsion;
        after.shear_energy += after.torsion * after.torsion / (2 * torsion_stiffness);
        friction_loss += limit * spin.distance - old_torsion * old_torsion / (2 * torsion_stiffness);
    }
    return {friction_loss, slip.scale < 1};
}

}  // namespace

void coulomb(const NormalContact& normal, const material::PairProperties& pair, const ContactKinematics& kinematics,
             const ShearState* before, ShearState& after, ContactRow& row) {
    const double elastic = norm(normal.force);
    const Vec3 n = elastic > 0 ? -normal.force / elastic : Vec3{0, 0, 1};
    const double closing = dot(kinematics.relative_velocity, n);

    double normal_force = elastic;
    if (pair.damping_ratio > 0) {
        const double dashpot = 2 * pair.damping_ratio * std::sqrt(kinematics.effective_mass * normal.stiffness);
        normal_force = std::max(0.0, elastic + dashpot * closing);
    }
    after = {n, {}, 0, 0};
    const SpringResult springs = advance_springs(normal, pair, kinematics, closing, normal_force, before, after);

    row.point = normal.point;
    row.force = after.shear_force - normal_force * n;
    row.moment = normal.moment + after.torsion * n;
    row.elastic_energy = normal.energy;
    row.friction_loss = springs.friction_loss;
    row.damping_loss = (normal_force - elastic) * closing * kinematics.sliding_time;
    row.normal_force = static_cast<float>(normal_force);
    row.shear_force = static_cast<float>(norm(after.shear_force));
    row.overlap = static_cast<float>(normal.depth);
    row.potential = static_cast<float>(normal.potential);
    row.area = static_cast<float>(normal.area);
    row.is_sliding = springs.is_sliding ? 1 : 0;
}

}  // namespace riprap::contact
