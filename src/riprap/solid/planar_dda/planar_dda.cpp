// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/planar_dda.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/body/drives.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid {

using namespace key;
using geometry::Vec2;
using planar_dda::Unknowns;

MethodKeys<PlanarDdaSettings> PlanarDdaSettings::keys() {
    using S = PlanarDdaSettings;
    using Engine = planar_dda::Settings;
    using affine::Elasticity;
    using planar_dda::PlaneState;
    const KeyList<Elasticity> elastic_keys{
        number(&Elasticity::youngs_modulus, "youngs_modulus", dimension::pressure, positive(),
               "Young's modulus of all blocks."),
        number(&Elasticity::poisson_ratio, "poisson_ratio", dimension::plain, between(0, 0.49),
               "Poisson's ratio of all blocks."),
        number(&Elasticity::contact_stiffness, "contact_stiffness", dimension::stiffness, positive(),
               "Normal stiffness of a contact point; the shear ratio of the materials gives the tangential one.")};
    const KeyList<Engine> engine_keys{
        choice(&Engine::has_multipliers, "normal_contact", {{"penalty", false}, {"augmented_lagrange", true}},
               "Contact forces by springs alone, or with multipliers that leave no overlap."),
        integer(&Engine::max_iterations, "open_close", 1, 100,
                "Rounds of the open-close iteration in which a contact may go back to what it was before the step is "
                "cut."),
        number(&Engine::dynamic_factor, "dynamic_factor", dimension::plain, between(0, 1),
               "Share of the velocity that the next step begins with: 1 = dynamic, 0 = static.")};
    return {
        .help = "implicit discontinuous deformation analysis in the plane, deformable polygons",
        .keys = within(&S::elasticity, elastic_keys) +
                KeyList<S>{choice(&S::plane, "plane", {{"stress", PlaneState::stress}, {"strain", PlaneState::strain}},
                                  "Plane stress or plane strain."),
                           number(&S::step, "step", dimension::time, positive(),
                                  "Time step; shorter where contacts do not settle."),
                           number(&S::max_displacement, "displacement_limit", dimension::plain, above(0, 1),
                                  "Displacement of a corner in a step, over the side of the smallest block, for which "
                                  "contacts are sought; three times as much cuts the step.")} +
                within(&S::engine, engine_keys)};
}

std::size_t PlanarDda::Scratch::bytes() const {
    const planar_dda::Model& model = scene.model;
    return loads.bytes() + bytes_of(driven, given, model.corner, model.corner_block, engine.corners, engine.contacts,
                                    engine.trials, engine.stiffness, engine.force, engine.right, engine.solution);
}

namespace {

/// Lengths of the engine for a scene.
planar_dda::Settings settings_of(const PlanarDdaSettings& given, double smallest) {
    planar_dda::Settings settings = given.engine;
    settings.displacement_limit = given.max_displacement * smallest;
    settings.close_tolerance = settings.open_tolerance = 1e-11 * smallest;
    settings.multiplier_tolerance = 1e-10 * smallest;
    return settings;
}

/// Bonds faces that touch at the start, to a ten-thousandth of the smallest block, where their joint has cohesion or
/// tensile strength.
void bond_faces(const planar_dda::SceneBlocks& scene, const planar_dda::Settings& settings, planar_dda::State& state) {
    const auto has_bond = [](const planar_dda::Joint& joint) { return joint.cohesion > 0 || joint.tension > 0; };
    if (std::any_of(scene.model.joints.begin(), scene.model.joints.end(), has_bond)) {
        bond_contacts(scene.model, settings, 1e-4 * scene.smallest, state);
        planar_dda::drop_contacts(state, [&](std::size_t k) {
            return !has_bond(scene.model.joint(scene.model.corner_block[at(state.contact_corner[k])],
                                               scene.model.corner_block[at(state.contact_edge[k])]));
        });
    }
}

}  // namespace

PlanarDda::PlanarDda(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                     Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    affine::start_stretching(state_.bodies);
    if (fields.around.empty()) {
        const planar_dda::Disc disc = planar_dda::disc_around(scene, state.bodies);
        fields.around = {disc.center.x, disc.center.y, disc.radius};
    }
    if (!scratch.is_made) {
        const planar_dda::Disc around{{fields.around[0], fields.around[1]}, fields.around[2]};
        make_blocks(scene, state.bodies, around, settings.elasticity, settings.plane, scratch.scene);
        scratch.settings = settings_of(settings, scratch.scene.smallest);
        scratch.is_made = true;
    }
    if (fields.was_held.size() != at(scene.bodies.size()) && scratch.scene.problems.empty()) {
        fields.blocks = scratch.scene.state;
        for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
            fields.was_held.push_back(is_free(scene.bodies, BodyId{b}, 0) ? 0 : 1);
        }
        std::copy(fields.was_held.begin(), fields.was_held.end(), scratch.scene.model.is_fixed.begin());
        bond_faces(scratch.scene, scratch.settings, fields.blocks);
    }
}

std::vector<material::PropertyUse> PlanarDda::reads(const Settings& /*settings*/) {
    using material::Property;
    return {{Property::shear_stiffness},
            {Property::friction},
            {Property::cohesion},
            {Property::tensile_strength},
            {Property::damping_ratio}};
}

std::vector<SceneProblem> PlanarDda::problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& bodies) {
    planar_dda::SceneBlocks blocks;
    make_blocks(scene, bodies, planar_dda::disc_around(scene, bodies), settings.elasticity, settings.plane, blocks);
    return blocks.problems;
}

namespace {

using planar_dda::Mode;

void add_load(std::int32_t block, double size, const Unknowns& direction, body::Loads& loads) {
    loads.force[at(block)] += size * Vec3{direction[0], direction[1], 0};
    loads.torque[at(block)] += size * Vec3{0, 0, direction[2]};
}

/// Tangential force of a closed contact along its slip [N].
double shear_of(const planar_dda::Contact& contact, const planar_dda::Trial& trial) {
    return trial.mode == Mode::locked ? -contact.joint.shear_stiffness * trial.slip : -trial.friction;
}

/// Force and torque of every contact on both of its blocks.
void sum_contacts(const planar_dda::Scratch& engine, body::Loads& loads) {
    const auto add = [&loads](std::int32_t block, double size, const Unknowns& direction) {
        add_load(block, size, direction, loads);
    };
    for (std::size_t k = 0; k < engine.contacts.size(); ++k) {
        const planar_dda::Contact& contact = engine.contacts[k];
        const planar_dda::Trial& trial = engine.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        const double shear = shear_of(contact, trial);
        add(contact.a, trial.normal, contact.gap.a);
        add(contact.b, trial.normal, contact.gap.b);
        add(contact.a, shear, contact.slip.a);
        add(contact.b, shear, contact.slip.b);
    }
}

/// The same of fixed points and bolts, at the end of the step. `start` is the state before it; what fixed points give
/// comes from outside and goes into `impulses` besides.
void sum_supports(const planar_dda::Model& model, const planar_dda::State& start, const planar_dda::Scratch& engine,
                  double dt, body::Loads& loads, KickReport& impulses) {
    for (const planar_dda::FixedPoint& p : model.fixed_points) {
        if (model.is_fixed[at(p.block)] != 0) {
            continue;
        }
        const Vec2 r = offset_of(start, p.block, p.local), center{start.x[at(p.block)], start.y[at(p.block)]};
        const Vec2 off = p.anchor - (center + r) - planar_dda::displacement_at(r, engine.motion[at(p.block)]);
        const Unknowns force = planar_dda::force_at(r, off);
        add_load(p.block, p.stiffness, force, loads);
        impulses.impulse += dt * p.stiffness * Vec3{force[0], force[1], 0};
        impulses.angular_impulse += dt * p.stiffness * Vec3{0, 0, force[2] + cross(center, off)};
    }
    for (const planar_dda::Bolt& bolt : model.bolts) {
        const planar_dda::Linear length = bolt_length(start, bolt);
        const double stretched =
            length.after(engine.motion[at(bolt.first)], engine.motion[at(bolt.second)]) - bolt.rest_length;
        add_load(bolt.first, -bolt.stiffness * stretched, length.a, loads);
        add_load(bolt.second, -bolt.stiffness * stretched, length.b, loads);
    }
}

/// One block as the sums of a kick see it.
struct BlockMotion {
    Vec3 place, velocity;
    double mass, kinetic, spin;  ///< spin: angular momentum about the centroid
};
BlockMotion motion_of(const planar_dda::Model& model, const planar_dda::State& state, std::int32_t b) {
    const Unknowns rates = rates_of(state, b);
    const Unknowns momentum =
        planar_dda::multiply(planar_dda::mass_block(model.mass[at(b)], spread_of(model, state, b)), rates);
    return {{state.x[at(b)], state.y[at(b)], 0},
            {rates[0], rates[1], 0},
            model.mass[at(b)],
            0.5 * planar_dda::dot(rates, momentum),
            momentum[2]};
}

/// Energy and momentum of blocks that are newly released.
void book_released(const planar_dda::Model& model, const PlanarDda::Fields& fields, const Vec3& gravity,
                   KickReport& kick) {
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        if (fields.was_held[at(b)] == 0 || model.is_fixed[at(b)] != 0) {
            continue;
        }
        const BlockMotion m = motion_of(model, fields.blocks, b);
        kick.released_energy += m.kinetic - m.mass * dot(gravity, m.place);
        kick.released_momentum += m.mass * m.velocity;
        kick.released_angular_momentum += m.mass * cross(m.place, m.velocity) + Vec3{0, 0, m.spin};
        kick.released_mass_moment += m.mass * m.place;
    }
}

/// Energies, momenta and impulses at the end of a piece.
void book_blocks(const planar_dda::Model& model, const planar_dda::State& state, const Vec3& gravity,
                 const std::vector<Unknowns>& given, const body::Loads& contacts, double dt, KickReport& kick) {
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const BlockMotion m = motion_of(model, state, b);
        if (model.is_fixed[at(b)] != 0) {
            kick.impulse -= dt * contacts.force[at(b)];
            kick.angular_impulse -= dt * (cross(m.place, contacts.force[at(b)]) + contacts.torque[at(b)]);
            continue;
        }
        const Unknowns load = given.empty() ? Unknowns{} : given[at(b)];
        const Vec3 outside = m.mass * gravity + Vec3{load[0], load[1], 0};
        kick.mass += m.mass;
        kick.kinetic += m.kinetic;
        kick.potential -= m.mass * dot(gravity, m.place);
        kick.momentum += m.mass * m.velocity;
        kick.angular_momentum += m.mass * cross(m.place, m.velocity) + Vec3{0, 0, m.spin};
        kick.impulse += dt * outside;
        kick.angular_impulse += dt * (cross(m.place, outside) + Vec3{0, 0, load[2]});
        kick.mass_moment += m.mass * m.place;
        kick.max_speed = std::max(kick.max_speed, m.mass > 0 ? std::sqrt(2 * m.kinetic / m.mass) : 0);
    }
}

/// Works and losses of a piece: what the accounts have gained.
void book_accounts(const planar_dda::Accounts& before, const planar_dda::Accounts& after,
                   const planar_dda::Energies& energies, SolidReport& report) {
    report.elastic = energies.contact + energies.fixed_points + energies.bolts;
    report.kick.external_work = after.work_loads - before.work_loads;
    report.kick.work_driven = after.work_driven - before.work_driven;
    report.friction_loss = after.friction_loss - before.friction_loss;
    report.damping_loss = after.dashpot_loss - before.dashpot_loss;
    report.own = {energies.strain,
                  after.bond_loss - before.bond_loss,
                  after.newmark_loss - before.newmark_loss,
                  after.static_loss - before.static_loss,
                  before.linearization - after.linearization,
                  before.constraint_work - after.constraint_work};
}

/// Writes the mean rates of stretching over the step, world axes. Those of the method at the end of a step change their
/// sign from step to step where a block is stiff.
void write_mean_rates(const std::vector<Unknowns>& motion, double dt, body::BodyState& bodies) {
    for (std::size_t b = 0; b < motion.size(); ++b) {
        bodies.stretch_rate[b] = {motion[b][3] / dt, motion[b][4] / dt, 0, 0.5 * motion[b][5] / dt, 0, 0};
    }
}

}  // namespace

std::span<const Account> PlanarDda::accounts() {
    static constexpr std::array table{
        Account{"strain", Balance::stored, Booking::at_kick, "stored in strained blocks"},
        Account{"bonds", Balance::lost, Booking::since_kick, "lost by bonds that broke, since time 0"},
        Account{"numerical_damping", Balance::lost, Booking::since_kick,
                "lost by the integration of motion and strain since time 0", true},
        Account{"static_damping", Balance::lost, Booking::since_kick, "lost to dynamic_factor since time 0"},
        Account{"linearization", Balance::lost, Booking::since_kick,
                "lost where exact turns replace the linear displacements of steps, since time 0", true},
        Account{"multipliers", Balance::lost, Booking::since_kick, "lost to the multipliers of contacts since time 0",
                true}};
    return table;
}

std::span<const ShownField> PlanarDda::shown() {
    static constexpr std::array table{
        ShownField{"stress_xx", "Pa", "of the Cauchy stress of the block, tension positive, world axes"},
        ShownField{"stress_yy", "Pa", "likewise"},
        ShownField{"stress_xy", "Pa", "likewise"},
        ShownField{"von_mises", "Pa", "von Mises' stress of the stresses in the plane"},
        ShownField{"strain_xx", "-", "of the strain (F F^T - I)/2 of the block, world axes"},
        ShownField{"strain_yy", "-", "likewise"},
        ShownField{"strain_xy", "-", "likewise"},
    };
    return table;
}

double PlanarDda::show(const body::BodyState& /*bodies*/, const Fields& fields, std::size_t body, std::size_t field) {
    const planar_dda::State& s = fields.blocks;
    const double x = s.stress_x[body], y = s.stress_y[body], xy = s.stress_xy[body];
    const auto block = static_cast<std::int32_t>(body);
    const Vec2 a = offset_of(s, block, {1, 0}), b = offset_of(s, block, {0, 1});  // columns of F
    switch (field) {
        case 0:
            return x;
        case 1:
            return y;
        case 2:
            return xy;
        case 3:
            return std::sqrt(x * x - x * y + y * y + 3 * xy * xy);
        case 4:
            return 0.5 * (a.x * a.x + b.x * b.x - 1);
        case 5:
            return 0.5 * (a.y * a.y + b.y * b.y - 1);
        default:
            return 0.5 * (a.x * a.y + b.x * b.y);
    }
}

std::string PlanarDda::misfit(const SolidScene& scene, const Settings& settings, const body::BodyState& bodies,
                              const Fields& fields) {
    const planar_dda::State& s = fields.blocks;
    const std::size_t count = at(scene.bodies.size()), contacts = s.contact_corner.size();
    for (const auto* of_blocks :
         {&s.x, &s.y, &s.angle, &s.stretch_xx, &s.stretch_yy, &s.stretch_xy, &s.stress_x, &s.stress_y, &s.stress_xy}) {
        if (of_blocks->size() != count || s.rates.size() != 6 * count || fields.was_held.size() != count) {
            return fmt::format("there are {} blocks of {} bodies", of_blocks->size(), count);
        }
    }
    for (const auto* of_contacts : {&s.contact_lock, &s.contact_share, &s.contact_multiplier, &s.contact_force}) {
        if (of_contacts->size() != contacts || s.contact_edge.size() != contacts || s.contact_mode.size() != contacts ||
            s.contact_is_bonded.size() != contacts) {
            return "the arrays of the contacts differ in length";
        }
    }
    if (fields.around.size() != 3) {
        return "the disc about the bodies at the start is missing";
    }
    planar_dda::SceneBlocks blocks;
    make_blocks(scene, bodies, {{fields.around[0], fields.around[1]}, fields.around[2]}, settings.elasticity,
                settings.plane, blocks);
    const auto is_corner = [corners = blocks.model.corner.size()](std::int32_t c) { return c >= 0 && at(c) < corners; };
    return std::ranges::all_of(s.contact_corner, is_corner) && std::ranges::all_of(s.contact_edge, is_corner)
               ? ""
               : "a contact is of a corner that is not there";
}

std::vector<contact::ShownContact> PlanarDda::contacts(const SolidScene& /*scene*/, const Settings& /*settings*/,
                                                       const Fields& /*fields*/, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    const planar_dda::Scratch& engine = scratch.engine;
    for (std::size_t k = 0; k < engine.contacts.size(); ++k) {
        const planar_dda::Contact& c = engine.contacts[k];
        const planar_dda::Trial& trial = engine.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        const Vec2& corner = engine.corners[at(c.corner)];
        const Vec3 away{c.gap.a[0], c.gap.a[1], 0}, along{c.slip.a[0], c.slip.a[1], 0};
        shown.push_back(contact::shown_contact(BodyId{c.a}, BodyId{c.b}, {corner.x, corner.y, 0},
                                               trial.normal * away + shear_of(c, trial) * along, -1.0 * away));
        shown.back().overlap = std::max(0.0, -trial.gap);
        shown.back().is_sliding = trial.mode == Mode::sliding;
    }
    return shown;
}

Outcome PlanarDda::advance(const TimeSpan& span, const body::LoadView& given, Measure, SolidReport& report) {
    planar_dda::SceneBlocks& scene = scratch_->scene;
    if (!scene.problems.empty()) {
        return {scene.problems.front().message, 0};
    }
    const body::LoadView loads = scratch_->point_loads.add(scene_->point_loads, state_.bodies, span.middle(), given);
    planar_dda::read_loads(loads, scratch_->given);
    body::advance_corrections(state_.bodies, span.dt);
    planar_dda::drive_blocks(*scene_, span, state_.bodies, fields_->blocks, scene, scratch_->driven);
    const Vec3 gravity = scene_->gravity.at(span.middle());
    book_released(scene.model, *fields_, gravity, report.kick);
    const planar_dda::Accounts before = fields_->blocks.accounts;
    const planar_dda::Step step{span.dt, {gravity.x, gravity.y}, scratch_->given, scratch_->driven};
    const bool has_supports = !scene.model.fixed_points.empty() || !scene.model.bolts.empty();
    const planar_dda::State start = has_supports ? fields_->blocks : planar_dda::State{};
    planar_dda::StepReport taken;
    const planar_dda::Outcome outcome =
        planar_dda::advance(scene.model, scratch_->settings, step, fields_->blocks, scratch_->engine, taken);
    if (!outcome.ok()) {
        return {outcome.problem, outcome.shorten};
    }
    std::copy(scene.model.is_fixed.begin(), scene.model.is_fixed.end(), fields_->was_held.begin());
    scratch_->loads.clear(at(scene.model.block_count()));
    sum_contacts(scratch_->engine, scratch_->loads);
    sum_supports(scene.model, start, scratch_->engine, span.dt, scratch_->loads, report.kick);
    report.gravity = gravity;
    report.kick_time = span.end();
    report.kick_share = 1;
    book_blocks(scene.model, fields_->blocks, gravity, scratch_->given, scratch_->loads, span.dt, report.kick);
    book_accounts(before, fields_->blocks.accounts, energies_of(scene.model, fields_->blocks), report);
    report.max_depth = taken.largest_overlap;
    report.contact_count = taken.touching_pairs;
    report.pair_count = static_cast<std::int64_t>(scratch_->engine.search.pairs.size());
    write_bodies(scene, fields_->blocks, state_.bodies);
    write_mean_rates(scratch_->engine.motion, span.dt, state_.bodies);
    state_.previous_dt = span.dt;
    return {};
}

}  // namespace riprap::solid
