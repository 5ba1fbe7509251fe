// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

#include <fmt/format.h>
#include <array>

#include <limits>

#include "riprap/body/ground.hpp"
#include "riprap/contact/distance_potential_physics.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/polyhedral_dem/contact_sums.hpp"
#include "riprap/solid/sphere_dem/advance.hpp"
#include "riprap/solid/sphere_dem/deepest_contact.hpp"
#include "riprap/solid/sphere_dem/move_spheres.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"
#include "riprap/solid/time_step.hpp"

namespace riprap::solid {

std::size_t SphereDem::Scratch::bytes() const {
    return bytes_of(spheres.body, spheres.radius, spheres.local, buffers.placed.records, buffers.slots.a,
                    buffers.slots.b, buffers.slots.load, buffers.slots.incoming) +
           buffers.pairs.bytes() + buffers.loads.bytes() + polyhedra.pipeline.bytes() + polyhedra.loads.bytes();
}

double SphereDem::smallest_stand_in(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                                    const Settings& settings) {
    return settings.sampling == SphereSampling::surface ? sphere_dem::radius_of_samples(bodies, shapes, settings)
                                                        : std::numeric_limits<double>::infinity();
}

std::vector<SceneProblem> SphereDem::problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& state) {
    constexpr double most = 1e9;  // steps: days of one sphere
    const sphere_dem::SphereSet spheres = sphere_dem::sample_bodies(scene, settings);
    const sphere_dem::TriangleSet none;
    const contact::ContactTable table = sphere_dem::pair_table(scene.materials, settings);
    const sphere_dem::SphereStep step = sphere_dem::step_limit(
        {scene.bodies, scene.shapes, spheres, none, table, settings.laws}, state, norm(scene.gravity.value));
    if (!(scene.end > most * step.limit)) {
        return {};
    }
    return {{step.body,
             fmt::format("steps of {:.3g} s, for the {}: {:.2g} of them to the end", step.limit, step.reason,
                         scene.end / step.limit),
             fmt::format("at most {:.2g}: a lower youngs_modulus, larger spheres or an earlier end", most)}};
}

SphereDem::SphereDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                     Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    if (!scratch.is_built) {
        scratch.spheres = sphere_dem::sample_bodies(scene, settings);
        for (const body::Ground& ground : body::find_grounds(scene.bodies, scene.shapes)) {
            const geometry::TriangleMesh& mesh = ground.field.mesh();
            std::vector<std::int32_t> corners;
            for (const auto& triangle : mesh.corners) {
                corners.insert(corners.end(), triangle.begin(), triangle.end());
            }
            scratch.triangles.add(ground.body, mesh.points, corners);
        }
        scratch.table = sphere_dem::pair_table(scene.materials, settings);
        Polyhedra& others = scratch.polyhedra;
        for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
            const bool is_sphere = scratch.spheres.count_of(b) > 0;
            const bool may_move =
                scene.bodies.drive[at(b)] == body::Drive::free || std::isfinite(scene.bodies.release_time[at(b)]);
            others.left_out.push_back(is_sphere ? 1 : 0);
            others.are_there = others.are_there || (may_move && !is_sphere);
        }
        scratch.is_built = true;
    }
}

sphere_dem::SphereModel SphereDem::model() const {
    return {scene_->bodies, scene_->shapes, scratch_->spheres, scratch_->triangles, scratch_->table, settings_->laws};
}

StepLimit SphereDem::limit() const {
    const sphere_dem::SphereStep step = step_limit(model(), state_.bodies, norm(scene_->gravity.value));
    const StepLimit of_spheres{step.limit * settings_->laws.steps_per_contact / 7.5, false, step.reason};
    Polyhedra& others = scratch_->polyhedra;
    if (!others.are_there) {
        return of_spheres;
    }
    if (!others.limit) {
        const DemTimeStep bound = time_step_bound(scene_->bodies, scene_->shapes, scene_->materials, others.left_out);
        others.limit = StepLimit{bound.limit, false, bound.reason};
    }
    return of_spheres.longest < others.limit->longest ? of_spheres : *others.limit;
}

contact::ContactScene SphereDem::polyhedra_scene() const {
    return {scene_->shapes,       scene_->materials,           scene_->bodies, settings_->laws.grid_factor,
            settings_->laws.skin, scratch_->polyhedra.left_out};
}

double SphereDem::meet_polyhedra(double sliding_time, bool with_energy) {
    Polyhedra& others = scratch_->polyhedra;
    body::Loads& loads = scratch_->buffers.loads;
    const contact::ContactScene scene = polyhedra_scene();
    const contact::Frictions coulomb;
    contact::DistancePotentialPhysics physics{{}, coulomb};
    physics.options.with_energy = with_energy;
    others.pipeline.place_parts(scene, state_.bodies);
    others.pipeline.find_pairs();
    const double lost = others.pipeline.find_contacts(physics, scene, state_.bodies, scratch_->buffers.kinematics,
                                                      sliding_time, state_.contacts);
    others.pipeline.gather_loads(scene, state_.bodies, others.loads);
    for (std::size_t b = 0; b < loads.force.size(); ++b) {
        loads.force[b] += others.loads.force[b];
        loads.torque[b] += others.loads.torque[b];
    }
    return lost;
}

std::span<const Account> SphereDem::accounts() {
    static constexpr std::array table{
        Account{"rolling", Balance::lost, Booking::since_kick, "lost by rolling resistance since time 0"},
    };
    return table;
}

Outcome SphereDem::advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) {
    const body::BodySet& bodies = scene_->bodies;
    body::BodyState& state = state_.bodies;
    const double kick_time = span.middle(), sliding_time = 0.5 * (state_.previous_dt + span.dt);
    const double previous_kick =
        state_.previous_dt > 0 ? kick_time - sliding_time : -std::numeric_limits<double>::infinity();
    sphere_dem::drift_spheres(bodies, state, kick_time, 0.5 * span.dt);
    const std::int64_t searches = scratch_->buffers.pairs.rebuild_count();
    const sphere_dem::ContactSums sums =
        evaluate_contacts(model(), kick_time, sliding_time, state, *fields_, scratch_->buffers);
    Polyhedra& others = scratch_->polyhedra;
    report.has_stored = !others.are_there || measure == Measure::energy || state_.previous_dt == 0;
    const double lost = others.are_there ? meet_polyhedra(sliding_time, report.has_stored) : 0;
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
    PolyhedralSums faces;
    if (others.are_there) {
        faces = sum_contacts(others.pipeline.rows(), state_.contacts);
        report.damping_loss =
            others.pipeline.dashpot_loss(polyhedra_scene(), state, scratch_->buffers.kinematics, span.dt);
        report.dt_bound = others.pipeline.stable_step(polyhedra_scene());
    }
    sphere_dem::drift_spheres(bodies, state, span.end(), 0.5 * span.dt);
    report.elastic = report.has_stored ? sums.elastic + faces.elastic : 0;
    report.shear = faces.shear;
    report.friction_loss = sums.friction_loss + faces.friction_loss + lost;
    report.own = {sums.rolling_loss};
    report.damping_loss += sums.damping_loss;
    report.max_potential = sums.deepest;
    report.contact_count =
        static_cast<std::int64_t>(fields_->contacts.size() + fields_->walls.size() + others.pipeline.rows().size());
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
    return judge_overlap(bodies, 1, faces, others.pipeline.rows(), kick_time);
}

}  // namespace riprap::solid
