// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/planar_dda.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/drives.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/stiffness_range.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/dashpots.hpp"
#include "riprap/solid/planar_dda/piece_books.hpp"

namespace riprap::solid {

using planar_dda::Unknowns;

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
    settings.bond_share = affine::bond_tolerance;
    return settings;
}

/// An impact is resolved by steps down to this share of the step of the method.
constexpr double finest_pieces = 64;

bool is_damped(const planar_dda::Model& model) {
    return std::ranges::any_of(model.joints, [](const planar_dda::Joint& joint) { return joint.damping_ratio > 0; });
}

/// Bonds faces that touch at the start, to a ten-thousandth of the smaller block of the pair, where their joint has
/// cohesion or tensile strength.
void bond_faces(const planar_dda::SceneBlocks& scene, const planar_dda::Settings& settings, planar_dda::State& state) {
    const auto has_bond = [](const planar_dda::Joint& joint) { return joint.cohesion > 0 || joint.tension > 0; };
    if (std::any_of(scene.model.joints.begin(), scene.model.joints.end(), has_bond)) {
        bond_contacts(scene.model, settings, std::numeric_limits<double>::infinity(), state);
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

std::vector<SceneProblem> PlanarDda::problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& bodies) {
    planar_dda::SceneBlocks blocks;
    make_blocks(scene, bodies, planar_dda::disc_around(scene, bodies), settings.elasticity, settings.plane, blocks);
    return blocks.problems.empty() ? affine::softness_problems(scene, settings.elasticity) : blocks.problems;
}

namespace {

/// Writes the mean rates of stretching over the step, world axes. Those of the method at the end of a step change their
/// sign from step to step where a block is stiff.
void write_mean_rates(const std::vector<Unknowns>& motion, double dt, body::BodyState& bodies) {
    for (std::size_t b = 0; b < motion.size(); ++b) {
        bodies.stretch_rate[b] = {motion[b][3] / dt, motion[b][4] / dt, 0, 0.5 * motion[b][5] / dt, 0, 0};
    }
}

}  // namespace

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
    for (const auto* of_contacts :
         {&s.contact_lock, &s.contact_share, &s.contact_multiplier, &s.contact_plastic_slip, &s.contact_force}) {
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
    const bool may_refuse = is_damped(scene.model) && span.dt > settings_->step / finest_pieces;
    const planar_dda::State start = has_supports || may_refuse ? fields_->blocks : planar_dda::State{};
    planar_dda::StepReport taken;
    const planar_dda::Outcome outcome =
        planar_dda::advance(scene.model, scratch_->settings, step, fields_->blocks, scratch_->engine, taken);
    if (!outcome.ok()) {
        return {outcome.problem, outcome.shorten};
    }
    const std::int64_t impact =
        may_refuse ? find_unresolved_impact(scene.model, fields_->blocks, step.gravity, span.dt, scratch_->engine) : -1;
    if (impact >= 0) {
        fields_->blocks = start;
        const planar_dda::Contact& contact = scratch_->engine.contacts[at(impact)];
        return {fmt::format("{} and {} meet too fast for a step of {:.3g} s", scene.model.name_of(contact.a),
                            scene.model.name_of(contact.b), span.dt),
                0.5};
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
    report.open_frictions = taken.open_frictions;
    report.pair_count = static_cast<std::int64_t>(scratch_->engine.search.pairs.size());
    write_bodies(scene, fields_->blocks, state_.bodies);
    write_mean_rates(scratch_->engine.motion, span.dt, state_.bodies);
    state_.previous_dt = span.dt;
    return {};
}

}  // namespace riprap::solid
