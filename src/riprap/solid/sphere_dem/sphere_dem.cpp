// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/sphere_dem.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include <limits>

#include "riprap/body/ground.hpp"
#include "riprap/body/may_move.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/sphere_dem/advance.hpp"
#include "riprap/solid/sphere_dem/dashpot_loss.hpp"
#include "riprap/solid/sphere_dem/deepest_contact.hpp"
#include "riprap/solid/sphere_dem/default_stiffness.hpp"
#include "riprap/solid/sphere_dem/move_spheres.hpp"
#include "riprap/solid/sphere_dem/sample_bodies.hpp"
#include "riprap/solid/sphere_dem/show_contacts.hpp"
#include "riprap/solid/sphere_dem/time_step.hpp"

namespace riprap::solid {

namespace {

/// Steps of a run, at least, with the default share of 0.15 [-].
constexpr double least_steps = 1000;

/// Names the key that makes contacts stiff enough, with its value now.
std::string stiffer(const SphereDemSettings& settings) {
    return settings.laws.normal == contact::NormalLaw::hertz
               ? fmt::format("a solid.youngs_modulus above {:.4g} Pa", sphere_dem::modulus_of(settings))
               : fmt::format("a solid.spring_stiffness above {:.4g} N/m", sphere_dem::spring_of(settings));
}

}  // namespace

std::size_t SphereDem::Scratch::bytes() const {
    return bytes_of(spheres.body, spheres.radius, spheres.local, buffers.placed.records, buffers.slots.a,
                    buffers.slots.b, buffers.slots.ends, buffers.load_rows.rows) +
           buffers.pairs.bytes() + buffers.loads.bytes() + faces.bytes();
}

double SphereDem::smallest_stand_in(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                                    const Settings& settings) {
    return settings.sampling == SphereSampling::surface ? sphere_dem::radius_of_samples(bodies, shapes, settings)
                                                        : std::numeric_limits<double>::infinity();
}

SphereDemSettings SphereDem::completed(const SolidScene& scene, const Settings& settings, const body::BodyState& state,
                                       double speed) {
    return sphere_dem::completed(scene, settings, state, speed);
}

std::vector<SceneProblem> SphereDem::problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& state) {
    constexpr double most = 1e9;  // steps: days of one sphere
    std::vector<SceneProblem> problems;
    const sphere_dem::SphereSet spheres = sphere_dem::sample_bodies(scene, settings, &problems);
    if (!problems.empty()) {
        return problems;
    }
    const sphere_dem::TriangleSet none;
    const contact::ContactTable table = sphere_dem::pair_table(scene.materials, settings);
    const sphere_dem::SphereStep step = sphere_dem::step_limit(
        {scene.bodies, scene.shapes, spheres, none, table, settings.laws}, state, norm(scene.gravity.value));
    if (!(scene.end > most * step.limit)) {
        return {};
    }
    const bool is_hertz = settings.laws.normal == contact::NormalLaw::hertz;
    return {{step.body,
             fmt::format("steps of {:.3g} s, for the {}: {:.2g} of them to the end", step.limit, step.reason,
                         scene.end / step.limit),
             fmt::format("at most {:.2g}: a lower {}, larger spheres or an earlier end", most,
                         is_hertz ? "youngs_modulus" : "spring_stiffness")}};
}

std::vector<BodyKind> SphereDem::kinds_of(const SolidScene& scene, const Settings& settings) {
    const sphere_dem::SphereSet spheres = sphere_dem::sample_bodies(scene, settings);
    std::vector<BodyKind> kinds;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        const bool keeps_faces =
            spheres.count_of(b) == 0 || (spheres.is_sampled[at(b)] != 0 && !may_move(scene.bodies, at(b)));
        kinds.push_back(keeps_faces ? BodyKind::faces : BodyKind::spheres);
    }
    return kinds;
}

SphereDem::SphereDem(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                     Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    faces_settings_.grid_factor = settings.laws.grid_factor;
    faces_settings_.skin = settings.laws.skin;
    faces_settings_.local_damping = settings.laws.local_damping;
    faces_settings_.mass_damping = settings.laws.mass_damping;
    faces_settings_.max_speed = settings.laws.max_speed;
    if (!scratch.is_built || scratch.strength_divisor != scene.strength_divisor) {
        scratch.table = sphere_dem::pair_table(scene.materials, settings);
        scratch.cohesion = sphere_dem::cohesion_table(scene.materials);
        scratch.strength_divisor = scene.strength_divisor;
    }
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
        for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
            const bool has_spheres = scratch.spheres.count_of(b) > 0;
            scratch.faces.left_out.push_back(has_spheres ? 1 : 0);
            scratch.do_faces_meet = scratch.do_faces_meet || (may_move(scene.bodies, at(b)) && !has_spheres);
        }
        scratch.is_built = true;
    }
}

sphere_dem::SphereModel SphereDem::model() const {
    return {scene_->bodies,  scene_->shapes,  scratch_->spheres, scratch_->triangles,
            scratch_->table, settings_->laws, scratch_->cohesion};
}

StepLimit SphereDem::lasting_limit() const {
    const sphere_dem::SphereStep step = step_limit(model(), state_.bodies, norm(scene_->gravity.value));
    const StepLimit of_spheres{step.limit * settings_->laws.steps_per_contact / 7.5, false, step.reason};
    return shorter_of(of_spheres);
}

StepLimit SphereDem::limit() const {
    const double gravity = norm(scene_->gravity.value);
    const sphere_dem::SphereStep step = step_limit(model(), state_.bodies, gravity);
    StepLimit of_spheres{step.limit * settings_->laws.steps_per_contact / 7.5, false, step.reason};
    if (std::isfinite(of_spheres.longest) && follows_contacts(model())) {
        of_spheres.longest = longest_ahead(model(), state_.bodies, {of_spheres.longest, gravity}, scratch_->ahead);
    }
    if (scene_->end > 0) {  // bodies at rest that a load is about to move have no impact to resolve yet
        of_spheres.longest = std::min(of_spheres.longest, scene_->end / (0.15 * least_steps));
    }
    return shorter_of(of_spheres);
}

StepLimit SphereDem::shorter_of(const StepLimit& of_spheres) const {
    if (!scratch_->do_faces_meet) {
        return of_spheres;
    }
    const StepLimit of_faces = faces().limit();
    return of_spheres.longest < of_faces.longest ? of_spheres : of_faces;
}

std::span<const Account> SphereDem::accounts() {
    static constexpr std::array table{
        Account{"rolling", Balance::lost, Booking::since_kick, "lost by rolling resistance since time 0"},
    };
    return table;
}

std::string SphereDem::misfit(const SolidScene& scene, const Settings& settings, const body::BodyState& /*bodies*/,
                              const Fields& fields) {
    const auto spheres = static_cast<std::uint64_t>(sphere_dem::sample_bodies(scene, settings).size());
    for (const sphere_dem::Springs* springs : {&fields.contacts, &fields.walls}) {
        const std::size_t count = springs->size();
        if (springs->force.size() != count || springs->stiffness.size() != count ||
            (!springs->rolling.empty() && springs->rolling.size() != count) ||
            springs->normal.size() != (springs == &fields.walls ? count : 0)) {
            return "the arrays of the contacts differ in length";
        }
        if (std::ranges::any_of(springs->pair, [spheres](std::uint64_t pair) { return pair >> 32U >= spheres; })) {
            return fmt::format("a contact is of a sphere beyond the {} that there are", spheres);
        }
    }
    if (std::ranges::any_of(fields.contacts.pair, [spheres](auto pair) { return (pair & 0xFFFFFFFFU) >= spheres; })) {
        return fmt::format("a contact is of a sphere beyond the {} that there are", spheres);
    }
    return "";
}

std::vector<contact::ShownContact> SphereDem::contacts(const SolidScene& scene, const Settings& settings,
                                                       const Fields& fields, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    show_rows(scratch.faces.pipeline.rows(), scene.bodies, shown);
    show_contacts({scene.bodies, scene.shapes, scratch.spheres, scratch.triangles, scratch.table, settings.laws},
                  fields, scratch.buffers, shown);
    return shown;
}

Outcome SphereDem::advance(const TimeSpan& span, const body::LoadView& loads, Measure measure, SolidReport& report) {
    const body::BodySet& bodies = scene_->bodies;
    body::BodyState& state = state_.bodies;
    sphere_dem::SphereScratch& buffers = scratch_->buffers;
    const double kick_time = span.middle(), sliding_time = 0.5 * (state_.previous_dt + span.dt);
    const double previous_kick =
        state_.previous_dt > 0 ? kick_time - sliding_time : -std::numeric_limits<double>::infinity();
    const bool do_faces_meet = scratch_->do_faces_meet;
    report.has_stored = !do_faces_meet || measure == Measure::energy || state_.previous_dt == 0;
    Laps laps;
    sphere_dem::drift_spheres(bodies, state, kick_time, 0.5 * span.dt);
    laps.end(buffers.times.move_bodies);
    buffers.keeps_forces = measure == Measure::energy;
    const std::int64_t searches = buffers.pairs.rebuild_count();
    FacesOnFaces faces_meet = faces();
    const sphere_dem::ContactSums sums = evaluate_contacts(model(), kick_time, sliding_time, state, *fields_, buffers,
                                                           do_faces_meet ? &faces_meet : nullptr, report.has_stored);
    Laps after;
    report.pairs_rebuilt = buffers.pairs.rebuild_count() != searches;
    report.gravity = scene_->gravity.at(kick_time);
    report.kick_time = kick_time;
    report.kick = kick(bodies, faces_settings_, buffers.kinematics, buffers.loads,
                       scratch_->point_loads.add(scene_->point_loads, state, kick_time, loads), report.gravity,
                       {kick_time, previous_kick, span.dt}, state);
    const sphere_dem::DashpotLoss dashpots =
        sphere_dem::dashpot_loss(model(), state, *fields_, sums.dashpot_power, span.dt, buffers);
    report.damping_loss = dashpots.all;
    fields_->damping_loss += dashpots.all;
    // The ledger books half of it before the kick, where dashpots have taken `before`.
    report.kick.kinetic += dashpots.before - 0.5 * dashpots.all;
    after.end(buffers.times.move_bodies);
    report.elastic = report.has_stored ? sums.elastic : 0;
    report.friction_loss = sums.friction_loss;
    report.own = {sums.rolling_loss};
    report.max_potential = sums.deepest;
    if (measure == Measure::energy) {
        report.max_depth = largest_overlap(model(), *fields_, buffers);
    }
    report.contact_count = count_touching(model(), *fields_);
    report.pair_count = buffers.slots.count + static_cast<std::int64_t>(buffers.wall_pairs.size());
    const Outcome overlap_of_faces = do_faces_meet ? faces_meet.book(buffers.kinematics, span.dt, report) : Outcome{};
    after.end(buffers.times.measure);
    sphere_dem::drift_spheres(bodies, state, span.end(), 0.5 * span.dt);
    after.end(buffers.times.move_bodies);
    state_.previous_dt = span.dt;
    if (report.kick.worst_body >= 0) {
        const BodyId body{static_cast<std::int32_t>(report.kick.worst_body)};
        return {fmt::format("velocity of {} is {:.6g} m/s at t = {:.9g} s; allowed: finite, at most {:.6g} m/s",
                            bodies.name(body), norm(state.velocity[at(body.value)]), kick_time,
                            faces_settings_.max_speed)};
    }
    if (!(sums.deepest <= settings_->laws.max_overlap)) {
        const sphere_dem::DeepestContact deepest = deepest_contact(model(), *fields_, buffers);
        return {
            fmt::format("{} and {} overlap by {:.4g} of the smaller sphere's radius at t = {:.9g} s; allowed: {:.4g}",
                        bodies.name(deepest.a), bodies.name(deepest.b), sums.deepest, kick_time,
                        settings_->laws.max_overlap),
            0, stiffer(*settings_)};
    }
    return overlap_of_faces;
}

}  // namespace riprap::solid
