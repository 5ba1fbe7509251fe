// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

#include <fmt/format.h>
#include <array>

#include <limits>

#include "riprap/body/ground.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/advance.hpp"
#include "riprap/solid/sphere_dem/deepest_contact.hpp"
#include "riprap/solid/sphere_dem/move_spheres.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"

namespace riprap::solid {

std::size_t SphereDem::Scratch::bytes() const {
    return bytes_of(spheres.body, spheres.radius, spheres.local, buffers.placed.records, buffers.slots.a,
                    buffers.slots.b, buffers.slots.load, buffers.slots.incoming) +
           buffers.pairs.bytes() + buffers.loads.bytes();
}

double SphereDem::smallest_stand_in(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                                    const Settings& settings) {
    return settings.sampling == SphereSampling::surface ? sphere_dem::radius_of_samples(bodies, shapes, settings)
                                                        : std::numeric_limits<double>::infinity();
}

SphereDem::SphereDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                     Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    if (!scratch.is_built) {
        scratch.spheres = sphere_dem::sample_bodies(scene.bodies, scene.shapes, scene.materials, settings);
        for (const body::Ground& ground : body::find_grounds(scene.bodies, scene.shapes)) {
            const geometry::TriangleMesh& mesh = ground.field.mesh();
            std::vector<std::int32_t> corners;
            for (const auto& triangle : mesh.corners) {
                corners.insert(corners.end(), triangle.begin(), triangle.end());
            }
            scratch.triangles.add(ground.body, mesh.points, corners);
        }
        scratch.table = sphere_dem::pair_table(scene.materials, settings);
        scratch.is_built = true;
    }
}

sphere_dem::SphereModel SphereDem::model() const {
    return {scene_->bodies, scene_->shapes, scratch_->spheres, scratch_->triangles, scratch_->table, settings_->laws};
}

StepLimit SphereDem::limit() const {
    const sphere_dem::SphereStep step = step_limit(model(), state_.bodies, norm(scene_->gravity.value));
    return {step.limit * settings_->laws.steps_per_contact / 7.5, false, step.reason};
}

std::span<const Account> SphereDem::accounts() {
    static constexpr std::array table{
        Account{"rolling", Balance::lost, Booking::since_kick, "lost by rolling resistance since time 0"},
    };
    return table;
}

Outcome SphereDem::advance(const TimeSpan& span, const body::LoadView& loads, Measure /*measure*/,
                           SolidReport& report) {
    const body::BodySet& bodies = scene_->bodies;
    body::BodyState& state = state_.bodies;
    const double kick_time = span.middle(), sliding_time = 0.5 * (state_.previous_dt + span.dt);
    const double previous_kick =
        state_.previous_dt > 0 ? kick_time - sliding_time : -std::numeric_limits<double>::infinity();
    sphere_dem::drift_spheres(bodies, state, kick_time, 0.5 * span.dt);
    const std::int64_t searches = scratch_->buffers.pairs.rebuild_count();
    const sphere_dem::ContactSums sums =
        evaluate_contacts(model(), kick_time, sliding_time, state, *fields_, scratch_->buffers);
    report.pairs_rebuilt = scratch_->buffers.pairs.rebuild_count() != searches;
    report.gravity = scene_->gravity.at(kick_time);
    report.kick_time = kick_time;
    DemSettings motion;
    motion.local_damping = settings_->laws.local_damping;
    motion.mass_damping = settings_->laws.mass_damping;
    motion.max_speed = settings_->laws.max_speed;
    report.kick = kick(bodies, motion, scratch_->buffers.kinematics, scratch_->buffers.loads,
                       scratch_->point_loads.add(scene_->point_loads, state, kick_time, loads), report.gravity,
                       {kick_time, previous_kick, span.dt}, state);
    sphere_dem::drift_spheres(bodies, state, span.end(), 0.5 * span.dt);
    report.has_stored = true;
    report.elastic = sums.elastic;
    report.friction_loss = sums.friction_loss;
    report.own = {sums.rolling_loss};
    report.damping_loss = sums.damping_loss;
    report.max_potential = sums.deepest;
    report.contact_count = static_cast<std::int64_t>(fields_->contacts.size() + fields_->walls.size());
    report.pair_count = scratch_->buffers.slots.count + static_cast<std::int64_t>(scratch_->buffers.wall_pairs.size());
    state_.previous_dt = span.dt;
    if (report.kick.worst_body >= 0) {
        const BodyId body{static_cast<std::int32_t>(report.kick.worst_body)};
        return {fmt::format("velocity of {} is {:.6g} m/s at t = {:.9g} s; allowed: finite, at most {:.6g} m/s",
                            bodies.name(body), norm(state.velocity[at(body.value)]), kick_time, motion.max_speed)};
    }
    if (!(sums.deepest <= settings_->laws.max_overlap)) {
        const sphere_dem::DeepestContact deepest = deepest_contact(model(), *fields_, scratch_->buffers);
        return {fmt::format(
            "{} and {} overlap by {:.4g} of the smaller sphere's radius at t = {:.9g} s; allowed: {:.4g}",
            bodies.name(deepest.a), bodies.name(deepest.b), sums.deepest, kick_time, settings_->laws.max_overlap)};
    }
    return {};
}

}  // namespace riprap::solid
