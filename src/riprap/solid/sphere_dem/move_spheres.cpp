// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/move_spheres.hpp"

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/explicit_dem.hpp"
#include "riprap/solid/lanes.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// drift_one of eight free bodies with three equal moments that turn by less than a thousandth of a radian, where
/// rotate_free is a short series. @returns false where they are not such
bool drift_balls(const body::BodySet& bodies, body::BodyState& state, std::int64_t first, double dt) {
    const Vec3x8 moments = load_vectors<Eight>(&bodies.principal_moments[at(first)]);
    const Vec3x8 turn = (Eight(1.0) / moments.x * Eight(dt)) * load_vectors<Eight>(&state.angular_momentum[at(first)]);
    const Eight angle2 = norm_squared(turn);
    const auto is_short = sqrt(angle2) < Eight(1e-3);
    const auto is_ball = (moments.x == moments.y) & (moments.y == moments.z) & is_short;
    if (bits_below(select(is_ball, Eight(0.0), Eight(1.0)), Eight(0.5)) != 0xFF) {
        return false;
    }
    store_vectors(
        load_vectors<Eight>(&state.position[at(first)]) + Eight(dt) * load_vectors<Eight>(&state.velocity[at(first)]),
        &state.position[at(first)]);
    const Eight half_sinc = Eight(0.5) - angle2 / Eight(48.0) + angle2 * angle2 / Eight(3840.0);
    const Eight w = Eight(1.0) - angle2 / Eight(8.0) + angle2 * angle2 / Eight(384.0);
    const Vec3x8 u = half_sinc * turn;
    double* places[lanes];
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        places[lane] = &state.orientation[at(first + lane)].w;
    }
    const FourOf<Eight> q = load_four<Eight>(places);
    const FourOf<Eight> p{w * q.a - u.x * q.b - u.y * q.c - u.z * q.d, w * q.b + u.x * q.a + u.y * q.d - u.z * q.c,
                          w * q.c - u.x * q.d + u.y * q.a + u.z * q.b, w * q.d + u.x * q.c - u.y * q.b + u.z * q.a};
    const Eight s = Eight(1.0) / sqrt(p.a * p.a + p.b * p.b + p.c * p.c + p.d * p.d);
    store_four<Eight>({s * p.a, s * p.b, s * p.c, s * p.d}, places);
    return true;
}

/// update_kinematics_of eight free bodies with three equal moments: the same operations in the same order.
/// @returns false where they are not such
bool update_balls(const body::BodySet& bodies, const body::BodyState& state, std::int64_t first,
                  body::BodyKinematics& kinematics) {
    const Vec3x8 moments = load_vectors<Eight>(&bodies.principal_moments[at(first)]);
    const auto is_ball = (moments.x == moments.y) & (moments.y == moments.z) & (moments.x > Eight(0.0));
    if (bodies.is_planar || bits_below(select(is_ball, Eight(0.0), Eight(1.0)), Eight(0.5)) != 0xFF) {
        return false;
    }
    const Eight inverse = Eight(1.0) / moments.x;
    const Vec3x8 momentum = load_vectors<Eight>(&state.angular_momentum[at(first)]);
    store_vectors(momentum * inverse, &kinematics.angular_velocity[at(first)]);
    (Eight(1.0) / Eight::load(&bodies.mass[at(first)])).store(&kinematics.inverse_mass[at(first)]);
    alignas(64) double inverses[lanes];
    inverse.store(inverses);
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const double a = inverses[lane];
        kinematics.inverse_inertia[at(first + lane)] = {a, a, a, 0, 0, 0};
    }
    return true;
}

/// eight(i) where the eight bodies from i on are free and it takes them, else one(i), over all bodies.
template <class EightBodies, class OneBody>
void for_bodies(const body::BodySet& bodies, const EightBodies& eight, const OneBody& one) {
    constexpr std::int64_t range = 1024;  // up to so many bodies are not worth waking a thread for
    parallel::for_ranges(bodies.size(), range, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end;) {
            if (i + lanes <= end && are_free(bodies, i, lanes) && eight(i)) {
                i += lanes;
            } else {
                one(i++);
            }
        }
    });
}

}  // namespace

void drift_spheres(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt) {
    for_bodies(
        bodies, [&](std::int64_t first) { return drift_balls(bodies, state, first, dt); },
        [&](std::int64_t index) { drift_one(bodies, state, index, end_time, dt); });
}

void update_sphere_kinematics(const body::BodySet& bodies, const body::BodyState& state, double time,
                              body::BodyKinematics& kinematics) {
    kinematics.angular_velocity.resize(at(bodies.size()));
    kinematics.inverse_inertia.resize(at(bodies.size()));
    kinematics.inverse_mass.resize(at(bodies.size()));
    for_bodies(
        bodies, [&](std::int64_t first) { return update_balls(bodies, state, first, kinematics); },
        [&](std::int64_t index) { update_kinematics_of(bodies, state, index, time, kinematics); });
}

}  // namespace riprap::solid::sphere_dem
