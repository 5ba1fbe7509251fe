// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riprap::contact {

namespace {

/// W c for one direction c.
Vec3 respond(const PairSide& side, const Vec3& arm, const Vec3& c) {
    return side.inverse_mass * c + cross(side.inverse_inertia * cross(arm, c), arm);
}

/// Upper bound of the largest eigenvalue of W [along n n^T + across (I - n n^T)].
double largest_rate(const Mobility& w, double along, double across) {
    const double difference = along - across;
    const double mean = (across * w.trace + difference * w.along) / 3;
    const double mean_square = (across * across * w.square + 2 * across * difference * w.along_square +
                                difference * difference * w.along * w.along) /
                               3;
    return mean + std::sqrt(2 * std::max(0.0, mean_square - mean * mean));
}

}  // namespace

Mobility mobility_at(const PairSide& side, const Vec3& point, const Vec3& n) {
    if (side.inverse_mass == 0) {
        return {};
    }
    const Vec3 arm = point - side.center;
    const Vec3 turn = cross(arm, n);
    const Vec3 x = respond(side, arm, {1, 0, 0}), y = respond(side, arm, {0, 1, 0}), z = respond(side, arm, {0, 0, 1});
    return {.along = side.inverse_mass + dot(turn, side.inverse_inertia * turn),
            .trace = x.x + y.y + z.z,
            .along_square = norm_squared(n.x * x + n.y * y + n.z * z),
            .square = norm_squared(x) + norm_squared(y) + norm_squared(z),
            .twist = dot(n, side.inverse_inertia * n)};
}

ContactKinematics kinematics_at(const Candidate& pair, const Vec3& point, const Mobility& a, const Mobility& b) {
    const PairSide &on_a = pair.a, &on_b = pair.b;
    const double along = a.along + b.along, across = 0.5 * (a.trace - a.along + (b.trace - b.along));
    const double twist = a.twist + b.twist;
    const Vec3 velocity_a = on_a.velocity + cross(on_a.spin, point - on_a.center);
    const Vec3 velocity_b = on_b.velocity + cross(on_b.spin, point - on_b.center);
    return {.relative_velocity = velocity_a - velocity_b,
            .mean_spin = 0.5 * (on_a.spin + on_b.spin),
            .relative_spin = on_a.spin - on_b.spin,
            .sliding_time = pair.sliding_time,
            .effective_mass = along > 0 ? 1 / along : 0,
            .tangential_mass = across > 0 ? 1 / across : 0,
            .mean_velocity = 0.5 * (velocity_a + velocity_b),
            .twist_inertia = twist > 0 ? 1 / twist : 0};
}

void set_stability(const LinearContact& contact, const Mobility& a, const Mobility& b, ContactRow& row) {
    const auto stiff = [&](const Mobility& w) {
        return largest_rate(w, contact.normal_stiffness, contact.shear_stiffness) + contact.torsion_stiffness * w.twist;
    };
    const double stiff_a = stiff(a), stiff_b = stiff(b), coupling = std::sqrt(stiff_a * stiff_b);
    row.omega_squared_a = static_cast<float>(stiff_a + coupling);
    row.omega_squared_b = static_cast<float>(stiff_b + coupling);
    row.damping_a = row.damping_b = 0;
    if (contact.normal_damping > 0 || contact.shear_damping > 0) {
        const auto damp = [&](const Mobility& w) {
            return largest_rate(w, contact.normal_damping, contact.shear_damping) + contact.torsion_damping * w.twist;
        };
        const double damped_a = damp(a), damped_b = damp(b), damped = std::sqrt(damped_a * damped_b);
        row.damping_a = static_cast<float>(damped_a + damped);
        row.damping_b = static_cast<float>(damped_b + damped);
    }
}

double stable_step(double omega_squared, double damping) {
    const double rate = damping + std::sqrt(damping * damping + 4 * omega_squared);
    return rate > 0 ? 4 / rate : std::numeric_limits<double>::infinity();
}

}  // namespace riprap::contact
