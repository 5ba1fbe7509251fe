// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/water_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/near_samples.hpp"

namespace riprap::sim {

namespace {

/// How a driven body speeds up over the step: where its velocity jumps, the jump is spread over the step and no more.
body::Acceleration driven_acceleration(const body::BodySet& bodies, std::size_t b, double time, double dt) {
    const BodyId body{static_cast<std::int32_t>(b)};
    const double moment = 0.5 * dt;
    const body::DrivenState before = driven_state(bodies, body, time - moment);
    const body::DrivenState after = driven_state(bodies, body, time + moment);
    return {(after.velocity - before.velocity) / (2 * moment),
            (after.angular_velocity - before.angular_velocity) / (2 * moment)};
}

/// The motion of all bodies with poses and velocities of `bodies`, `ahead` seconds of acceleration later. Driven bodies
/// speed up as their motion says and by their `correction`, where there are any [m/s^2].
void fill_motion(const Model& model, const body::BodyState& bodies, const body::BodyKinematics& kinematics,
                 const std::vector<body::Acceleration>& acceleration, std::span<const Vec3> correction, double time,
                 double ahead, double dt, body::Motion& motion) {
    const auto count = at(model.bodies.size());
    motion.pose.resize(count);
    motion.velocity.resize(count);
    motion.angular_velocity.resize(count);
    motion.acceleration.resize(count);
    motion.angular_acceleration.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        body::Acceleration a;
        const bool is_free = kinematics.inverse_mass[b] > 0;
        if (is_free) {
            a = acceleration[b];
        } else if (model.bodies.drive[b] == body::Drive::driven) {
            a = driven_acceleration(model.bodies, b, time, dt);
            a.linear += correction.empty() ? Vec3{} : correction[b];
        }
        const double later = is_free ? ahead : 0;
        motion.pose[b] = {bodies.position[b], bodies.orientation[b]};
        motion.velocity[b] = bodies.velocity[b] + later * a.linear;
        motion.angular_velocity[b] = kinematics.angular_velocity[b] + later * a.angular;
        motion.acceleration[b] = a.linear;
        motion.angular_acceleration[b] = a.angular;
    }
}

/// Boundary particles of bodies that move as scratch.motion says, `ahead` seconds after the State, and behind openings.
void place_walls(const Model& model, const State& state, double ahead, WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    place_samples(samples_near_water(model, scratch), scratch.motion, scratch.walls, scratch.is_still);
    if (!water.open.empty()) {
        place_openings(water.open, state.open, water.sph, state.time + ahead, ahead, scratch.walls);
    }
}

/// Everywhere that water may enter less than a spacing past, and faces that may make joints.
std::vector<Vec3> places_of_openings_and_joints(const Model& model, const WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    std::vector<Vec3> places;
    for (const fluid::Inflow& inflow : water.open.inflows) {
        for (const Vec3& row : inflow.rows) {
            places.push_back(row);
            places.push_back(row + water.sph.spacing * inflow.opening.direction());
        }
    }
    add_places_of_joints(model, scratch.is_loose, scratch.motion, places);
    return places;
}

/// Keeps scratch.near_numbers those of the samples that the water may feel in this step. They are found anew when it
/// may have come farther than the margin that was left the last time, which follows from the State alone.
void find_near_samples(const Model& model, State& state, WaterScratch& scratch, double dt) {
    const FluidModel& water = *model.fluid;
    if (water.samples.size() == 0) {
        return;
    }
    CouplingState& coupling = state.coupling;
    const double margin = 2 * water.sph.spacing;
    const double fastest = parallel::reduce(
        state.fluid.size(), 0.0, [&](std::int64_t i) { return norm_squared(state.fluid.velocity[at(i)]); },
        [](double a, double b) { return std::max(a, b); });
    const double ahead =
        0.5 * dt * std::max(std::sqrt(fastest), speed_of_joints(model, scratch.is_loose, state.bodies, scratch.joints));
    if (coupling.near_travel < 0 || coupling.near_travel + ahead > margin) {
        const double reach = std::max(water.sph.support_radius(), reach_of_joints(model, scratch.is_loose));
        coupling.near_samples =
            near_samples(water.samples, scratch.motion, scratch.is_still, state.fluid.position,
                         places_of_openings_and_joints(model, scratch), water.sph.domain, reach + margin + ahead);
        coupling.near_travel = 0;
    }
    coupling.near_travel += ahead;
    if (scratch.near_numbers != coupling.near_samples) {
        scratch.near_numbers = coupling.near_samples;
        scratch.walls = {};
        scratch.joints.pressure.forget();
    }
}

}  // namespace

void describe_bodies(const Model& model, WaterScratch& scratch) {
    const body::BodySet& bodies = model.bodies;
    const fluid::SphSettings& sph = model.fluid->sph;
    scratch.kappa.assign(at(bodies.size()), 0);
    scratch.is_still.resize(at(bodies.size()));
    scratch.is_loose.resize(at(bodies.size()));
    for (std::size_t b = 0; b < scratch.is_still.size(); ++b) {
        const bool is_released = std::isfinite(bodies.release_time[b]);
        scratch.is_still[b] = bodies.drive[b] == body::Drive::fixed && !is_released ? 1 : 0;
        scratch.is_loose[b] = bodies.drive[b] == body::Drive::free || is_released ? 1 : 0;
    }
    scratch.inertia.resize(at(bodies.size()));
    const coupling::SampleSet& samples = model.fluid->samples;
    for (std::size_t i = 0; i < samples.body.size(); ++i) {
        const auto b = at(samples.body[i].value);
        if (samples.depth[i] < sph.spacing && bodies.mass[b] > 0) {
            scratch.kappa[b] += 2 * sph.rest_density * samples.volume[i] / bodies.mass[b];
        }
    }
    // The guard is not iterated: its springs on one body must not swing it faster than its particles.
    scratch.guard_share.resize(at(bodies.size()));
    for (std::size_t b = 0; b < scratch.guard_share.size(); ++b) {
        scratch.guard_share[b] = scratch.is_loose[b] != 0 ? 1 / std::max(1.0, scratch.kappa[b]) : 1.0;
    }
    for (std::size_t b = 0; b < scratch.inertia.size(); ++b) {
        const Vec3& moments = bodies.principal_moments[b];
        scratch.inertia[b] = bodies.is_planar ? moments.z : (moments.x + moments.y + moments.z) / 3;
    }
}

std::string find_intruder(const Model& model, const WaterScratch& scratch) {
    const FluidModel& water = *model.fluid;
    for (std::size_t i = 0; !water.open.empty() && i < scratch.near_numbers.size(); ++i) {
        const BodyId body = water.samples.body[at(scratch.near_numbers[i])];  // all those of bodies that move are near
        if (scratch.is_still[at(body.value)] != 0) {
            continue;
        }
        const fluid::Opening* const opening = opening_with_layers_at(water.open, water.sph, scratch.walls.position[i]);
        if (opening != nullptr) {
            return fmt::format("'{}' stands behind the opening '{}', among the layers of its water",
                               model.bodies.name(body), opening->name);
        }
    }
    return {};
}

void place_walls_at_start(const Model& model, State& state, const std::vector<body::Acceleration>& guess, double dt,
                          WaterScratch& scratch) {
    update_kinematics(model.bodies, state.bodies, state.time, scratch.kinematics);
    fill_motion(model, state.bodies, scratch.kinematics, guess, scratch.correction, state.time, 0, dt, scratch.motion);
    find_near_samples(model, state, scratch, dt);
    place_walls(model, state, 0, scratch);
}

void place_walls_at_middle(const Model& model, const State& state, const std::vector<body::Acceleration>& guess,
                           double dt, WaterScratch& scratch) {
    const double later = 0.5 * dt;
    fill_motion(model, scratch.middle, scratch.kinematics, guess, scratch.correction, state.time + later, later, dt,
                scratch.motion);
    place_walls(model, state, later, scratch);
}

}  // namespace riprap::sim
