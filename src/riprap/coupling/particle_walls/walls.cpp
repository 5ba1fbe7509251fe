// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/samples/moving_seams.hpp"
#include "riprap/coupling/samples/near_samples.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::coupling {

namespace {

/// Everywhere that water may enter less than a spacing past.
std::vector<Vec3> places_of_openings(const ParticleFluid& water) {
    std::vector<Vec3> places;
    for (const fluid::Inflow& inflow : water.open.inflows) {
        for (const Vec3& row : inflow.rows) {
            places.push_back(row);
            places.push_back(row + water.settings().spacing * inflow.opening.direction());
        }
    }
    return places;
}

/// Finds the samples that water may feel before it and loose bodies have come `margin` each. Loose bodies count while
/// water may come to them, or to a joint that they shut off: to one of a body that water comes to, or of a neighbour of
/// that one.
std::vector<std::int32_t> find_samples(const ParticleFluid& water, const body::BodySet& bodies,
                                       std::span<const Vec3> particles, double margin, const ParticleScratch& scratch) {
    const fluid::ParticleSettings& settings = water.settings();
    const std::vector<std::uint8_t>& is_loose = scratch.bodies.is_loose;
    std::vector<Vec3> places = places_of_openings(water);
    const double of_joints = reach_of_joints(water, bodies, is_loose);
    const double reach = std::max(settings.support_radius(), of_joints) + margin;
    if (of_joints == 0) {
        return near_samples(water.samples, scratch.motion, scratch.bodies.is_still, particles, places, settings.domain,
                            reach);
    }
    std::vector<std::uint8_t> is_near = near_bodies(water.samples, scratch.motion, is_loose, particles, places,
                                                    settings.domain, settings.support_radius() + 2 * margin);
    std::vector<Vec3> faces;
    add_places_of_joints(water, is_near, scratch.motion, faces);
    const std::vector<std::uint8_t> is_beside =
        near_bodies(water.samples, scratch.motion, is_loose, faces, {}, settings.domain, 2 * (of_joints + margin));
    std::vector<std::uint8_t> is_far = is_loose;
    for (std::size_t b = 0; b < is_near.size(); ++b) {
        is_near[b] |= is_beside[b];
        is_far[b] = is_loose[b] != 0 && is_near[b] == 0 ? 1 : 0;
    }
    add_places_of_joints(water, is_near, scratch.motion, places);
    return near_samples(water.samples, scratch.motion, scratch.bodies.is_still, particles, places, settings.domain,
                        reach, is_far);
}

/// Fills the area that each sample of the outermost layer stands for, along its outward normal; zero below it.
void place_areas(const SampleView& samples, const body::Motion& motion, double spacing,
                 fluid::BoundaryParticles& walls) {
    walls.outward_area.resize(at(samples.size()));
    parallel::for_each(samples.size(), [&](std::int64_t index) {
        const auto i = at(index);
        const bool is_outermost = samples.depth(i) < 0.75 * spacing;
        const double area = is_outermost ? samples.volume(i) / spacing : 0;
        walls.outward_area[i] = area * rotate(motion.pose[at(samples.body(i).value)].orientation, samples.normal(i));
    });
}

/// Fills the normals of the faces that samples lie under, as BoundaryParticles say.
void place_normals(const SampleView& samples, const body::Motion& motion, fluid::BoundaryParticles& walls) {
    walls.normal.resize(at(samples.size()));
    parallel::for_each(samples.size(), [&](std::int64_t index) {
        const auto i = at(index);
        walls.normal[i] = rotate(motion.pose[at(samples.body(i).value)].orientation, samples.normal(i));
        if (samples.is_in_vertex(i) != 0) {
            walls.normal[i] *= fluid::length_in_vertex;
        }
    });
}

/// Tells whether numbers of samples are whole fours, as near_samples gives them. Those of a State from before it did so
/// are not, nor are they of samples in the order that they have now.
bool are_whole_fours(std::span<const std::int32_t> numbers, std::int64_t samples) {
    constexpr std::int32_t four = fluid::cluster_size;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::int32_t next = numbers[k] + 1;
        const bool has_next = k + 1 < numbers.size() && numbers[k + 1] == next;
        const bool begins = numbers[k] % four == 0 || (k > 0 && numbers[k - 1] == numbers[k] - 1);
        if (!begins || (next % four != 0 && next < samples && !has_next)) {
            return false;
        }
    }
    return true;
}

MovingSeams seams_of(const FluidScene& scene, const ParticleFluid& water, const ParticleScratch& scratch) {
    return {scene.shapes,
            scene.bodies,
            water.is_dry,
            scratch.motion,
            water.settings().spacing,
            water.settings().support_radius()};
}

double fastest_of(const fluid::ParticleState& particles) {
    return std::sqrt(parallel::reduce(
        particles.size(), 0.0, [&](std::int64_t i) { return norm_squared(particles.velocity[at(i)]); },
        [](double a, double b) { return std::max(a, b); }));
}

}  // namespace

CornerLoads find_corners(const FluidScene& scene, const ParticleFluid& water, const body::BodyState& bodies) {
    SampleSettings settings;
    settings.spacing = water.settings().spacing;
    settings.reach = water.settings().support_radius();
    settings.is_dry = water.is_dry;
    return {scene.shapes, scene.bodies, bodies, settings, water.samples};
}

void place_walls(const FluidScene& scene, const ParticleFluid& water, const fluid::OpenState& open, double time,
                 double ahead, ParticleScratch& scratch) {
    const SampleView samples(water.samples, scratch.near_numbers);
    place_samples(samples, scratch.motion, scratch.walls, scratch.bodies.is_still);
    const bool takes_normals = fluid::takes_normals(water.scheme);
    if (takes_normals) {
        place_normals(samples, scratch.motion, scratch.walls);
    }
    if (const MovingSeams seams = seams_of(scene, water, scratch); !seams.empty()) {
        seams.share(samples, scratch.walls);
    }
    if (fluid::takes_outward_area(water.scheme)) {
        place_areas(SampleView(water.samples, scratch.near_numbers), scratch.motion, water.settings().spacing,
                    scratch.walls);
    }
    if (!water.open.empty()) {
        place_openings(water.open, open, water.settings(), time, ahead, scratch.walls);
        scratch.walls.normal.resize(takes_normals ? scratch.walls.position.size() : 0);  // they have none
    }
}

void gather_wall_loads(const FluidScene& scene, const ParticleFluid& water, const ParticleScratch& scratch,
                       FluidLoads& loads) {
    const SampleView samples(water.samples, scratch.near_numbers);
    gather_loads(samples, scratch.motion, scratch.walls, loads);
    scratch.corners.hand_over(samples, scratch.motion, scratch.walls, loads.pressure);
    if (const MovingSeams seams = seams_of(scene, water, scratch); !seams.empty()) {
        seams.hand_over(samples, scratch.walls, loads.pressure);
    }
}

double power_at_seams(const FluidScene& scene, const ParticleFluid& water, const ParticleScratch& scratch) {
    const MovingSeams seams = seams_of(scene, water, scratch);
    return seams.empty() ? 0 : seams.handed_power(SampleView(water.samples, scratch.near_numbers), scratch.walls);
}

void find_near_samples(const FluidScene& scene, const ParticleFluid& water, const FluidState& state, double dt,
                       double lasts, ParticleScratch& scratch) {
    if (water.samples.size() == 0) {
        return;
    }
    CouplingState& coupling = state.coupling;
    const fluid::ParticleSettings& settings = water.settings();
    const std::vector<std::uint8_t>& is_loose = scratch.bodies.is_loose;
    const double margin = 2 * settings.spacing;
    const double fastest = std::max(fastest_of(state.particles),
                                    speed_of_joints(water, is_loose, scene.bodies, state.bodies, scratch.joints));
    const double ahead = 0.5 * dt * fastest;
    const double most = lasts > dt ? 1.5 * lasts * fastest : ahead;  // as fast as that water is before it is looked at
    const bool is_other_order =
        scratch.near_numbers != coupling.near_samples && !are_whole_fours(coupling.near_samples, water.samples.size());
    if (lasts > 0 && (coupling.near_travel < 0 || coupling.near_travel + most > margin || is_other_order)) {
        coupling.near_samples = find_samples(water, scene.bodies, state.particles.position, margin + most, scratch);
        coupling.near_travel = 0;
    }
    coupling.near_travel += ahead;
    take_near_samples(coupling, scratch);
}

void take_near_samples(const CouplingState& coupling, ParticleScratch& scratch) {
    if (scratch.near_numbers != coupling.near_samples) {
        scratch.near_numbers = coupling.near_samples;
        scratch.walls = {};
        scratch.joints.pressure.forget();
    }
}

WallBodies describe_bodies(const body::BodySet& bodies, const ParticleFluid& water) {
    const auto count = at(bodies.size());
    WallBodies found;
    found.kappa.assign(count, 0);
    found.is_still.resize(count);
    found.is_loose.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        found.is_loose[b] = may_move(bodies, b) ? 1 : 0;
        found.is_still[b] = bodies.drive[b] == body::Drive::fixed && found.is_loose[b] == 0 ? 1 : 0;
    }
    const SampleSet& samples = water.samples;
    for (std::size_t i = 0; i < samples.body.size(); ++i) {
        const auto b = at(samples.body[i].value);
        if (samples.depth[i] < water.settings().spacing && bodies.mass[b] > 0) {
            found.kappa[b] += 2 * water.settings().rest_density * samples.volume[i] / bodies.mass[b];
        }
    }
    // The guard is not iterated: its springs on one body must not swing it faster than its particles.
    found.guard_share.resize(count);
    for (std::size_t b = 0; b < count; ++b) {
        found.guard_share[b] = found.is_loose[b] != 0 ? 1 / std::max(1.0, found.kappa[b]) : 1.0;
    }
    return found;
}

std::string find_intruder(const body::BodySet& bodies, const ParticleFluid& water, const ParticleScratch& scratch) {
    for (std::size_t i = 0; !water.open.empty() && i < scratch.near_numbers.size(); ++i) {
        const BodyId body =
            water.samples.body[at(scratch.near_numbers[i])];  // openings count as water: who moves there is near
        if (scratch.bodies.is_still[at(body.value)] != 0) {
            continue;
        }
        const fluid::Opening* const opening =
            opening_with_layers_at(water.open, water.settings(), scratch.walls.position[i]);
        if (opening != nullptr) {
            return fmt::format("'{}' stands behind the opening '{}', among the layers of its water", bodies.name(body),
                               opening->name);
        }
    }
    return {};
}

}  // namespace riprap::coupling
