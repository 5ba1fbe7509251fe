// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/contact/law/hertz.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/find.hpp"
#include "riprap/solid/sphere_dem/place.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"
#include "riprap/solid/sphere_dem/walls.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double taken_share = 0.15;     ///< of the longest step that is taken [-]
constexpr double most_longer = 16;       ///< than the step that is safe for whatever comes [-]
constexpr double way_share = 0.01;       ///< of R, that a point moves by in a step at most [-]
constexpr double parts_of_impact = 7.5;  ///< longest steps in an impact [-]

/// Moves bodies over a time with the velocities that they have.
void move(const SphereModel& model, const body::BodyState& state, double time, LookAhead& ahead) {
    const body::BodySet& bodies = model.bodies;
    body::BodyKinematics& kinematics = ahead.buffers.kinematics;
    ahead.bodies = state;
    kinematics.angular_velocity.assign(at(bodies.size()), {});
    kinematics.inverse_mass.assign(at(bodies.size()), 0);
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        ahead.bodies.position[at(b)] += time * state.velocity[at(b)];
        if (state.angular_momentum[at(b)] != Vec3{}) {
            const Vec3 spin = angular_velocity(bodies, state, BodyId{b});
            kinematics.angular_velocity[at(b)] = spin;
            ahead.bodies.orientation[at(b)] = from_rotation_vector(time * spin) * state.orientation[at(b)];
        }
        kinematics.inverse_mass[at(b)] = may_move(bodies, at(b)) ? 1 / bodies.mass[at(b)] : 0;
    }
}

/// Returns the compliance of a body against a push with this arm, 1/m + r^2/I; 0 where forces do not move it [1/kg].
double compliance_of(const SphereModel& model, const LookAhead& ahead, std::int32_t body, const Vec3& point) {
    const double inverse_mass = ahead.buffers.kinematics.inverse_mass[at(body)];
    if (inverse_mass == 0) {
        return 0;
    }
    const Vec3& moments = model.bodies.principal_moments[at(body)];
    const double moment = model.bodies.is_planar ? moments.z : std::min({moments.x, moments.y, moments.z});
    return inverse_mass + norm_squared(point - ahead.bodies.position[at(body)]) / moment;
}

/// Sums over the contacts of a body.
struct Demand {
    double spring{0};  ///< of k (1/m + r^2/I) [1/s^2]
    double impact{0};  ///< of E* sqrt(R) (1/m + r^2/I) [m^(-1/2)/s^2]
};

Vec3 velocity_at(const LookAhead& ahead, std::int32_t body, const Vec3& point) {
    return ahead.bodies.velocity[at(body)] +
           cross(ahead.buffers.kinematics.angular_velocity[at(body)], point - ahead.bodies.position[at(body)]);
}

/// Longest step of the contacts found where bodies will be; 0 where there are none, so that bodies that only forces or
/// their flight move keep their known step [s].
double allowed_there(const SphereModel& model, const LookAhead& ahead) {
    std::vector<Demand> demand(at(model.bodies.size()));
    for (const WallContact& contact : ahead.buffers.walls) {
        const std::int32_t a = model.spheres.body[at(contact.sphere)], b = wall_body(model, contact.wall);
        const double modulus = model.table.pair(model.bodies.material[at(a)], model.bodies.material[at(b)]).modulus;
        const double impact = contact.portion * modulus * std::sqrt(model.spheres.curvature[at(contact.sphere)]);
        for (const std::int32_t body : {a, b}) {
            const double compliance = compliance_of(model, ahead, body, contact.point);
            demand[at(body)].spring += 2 * impact * std::sqrt(contact.overlap) * compliance;
            demand[at(body)].impact += impact * compliance;
        }
    }
    double longest = never;
    for (const WallContact& contact : ahead.buffers.walls) {
        const std::int32_t a = model.spheres.body[at(contact.sphere)], b = wall_body(model, contact.wall);
        const double spring = demand[at(a)].spring + demand[at(b)].spring;
        const double impact = demand[at(a)].impact + demand[at(b)].impact;
        const Vec3 velocity = velocity_at(ahead, a, contact.point) - velocity_at(ahead, b, contact.point);
        longest = spring > 0 ? std::min(longest, 2 / std::sqrt(spring)) : longest;
        if (const double speed = std::abs(dot(velocity, contact.normal)); speed > 0 && impact > 0) {
            longest = std::min(longest, contact::hertz_contact_time(1, 1, 1 / impact, speed) / parts_of_impact);
        }
    }
    return ahead.buffers.walls.empty() ? 0 : longest;
}

double allowed_after(const SphereModel& model, const body::BodyState& state, double time, LookAhead& ahead) {
    move(model, state, time, ahead);
    place(model, ahead.bodies, ahead.buffers);
    find_candidates(model, ahead.buffers);
    find_walls(model, ahead.buffers);
    return allowed_there(model, ahead);
}

/// Longest step over which no point moves by more than its share of R [s].
double longest_way(const SphereModel& model, const body::BodyState& state, double gravity) {
    double least = never;
    for (const double radius : model.spheres.curvature) {
        least = std::min(least, radius);
    }
    const double way = way_share * least;
    return way / (taken_share * std::max(fastest_point(model, state), std::sqrt(2 * gravity * way)));
}

}  // namespace

bool follows_contacts(const SphereModel& model) {
    if (model.settings.normal != contact::NormalLaw::hertz) {
        return false;
    }
    bool is_any = false;
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        if (may_move(model.bodies, at(b))) {
            is_any = true;
            if (model.spheres.is_sampled[at(b)] == 0) {
                return false;
            }
        } else if (model.spheres.count_of(b) > 0 && model.spheres.is_sampled[at(b)] == 0) {
            return false;
        }
    }
    return is_any;
}

double longest_ahead(const SphereModel& model, const body::BodyState& state, const KnownStep& known, LookAhead& ahead) {
    double longest = std::min(most_longer * known.longest, longest_way(model, state, known.gravity));
    while (longest > known.longest) {
        const double allowed = allowed_after(model, state, taken_share * longest, ahead);
        if (allowed >= longest) {
            return longest;
        }
        if (allowed == 0) {
            break;
        }
        longest = std::max(allowed, 0.5 * longest);
    }
    return known.longest;
}

}  // namespace riprap::solid::sphere_dem
