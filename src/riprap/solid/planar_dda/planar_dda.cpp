// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/planar_dda.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/body/drives.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/affine/body_bridge.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/stiffness_range.hpp"
#include "riprap/solid/planar_dda/bond_faces.hpp"
#include "riprap/solid/planar_dda/dashpots.hpp"
#include "riprap/solid/planar_dda/piece_books.hpp"
#include "riprap/solid/planar_dda/scene_bridge.hpp"

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
        scratch.scene = make_blocks(scene, state.bodies, around, settings.elasticity, settings.plane);
        scratch.settings = settings_of(settings, scratch.scene.smallest);
        scratch.is_made = true;
    }
    affine::renew_strengths(scene.materials, scene.strength_divisor, scratch.scene.model.surfaces);
    if (fields.was_held.size() != at(scene.bodies.size()) && scratch.scene.problems.empty()) {
        fields.blocks = scratch.scene.state;
        for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
            fields.was_held.push_back(is_free(scene.bodies, BodyId{b}, 0) ? 0 : 1);
        }
        bond_faces(scratch.scene.model, scratch.settings, fields.blocks);
    }
}

std::vector<SceneProblem> PlanarDda::problems_of(const SolidScene& scene, const Settings& settings,
                                                 const body::BodyState& bodies) {
    const planar_dda::SceneBlocks blocks = planar_dda::make_blocks(
        scene, bodies, planar_dda::disc_around(scene, bodies), settings.elasticity, settings.plane);
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
    const planar_dda::Disc around{{fields.around[0], fields.around[1]}, fields.around[2]};
    const planar_dda::SceneBlocks blocks =
        planar_dda::make_blocks(scene, bodies, around, settings.elasticity, settings.plane);
    const auto is_corner = [corners = blocks.model.corner.size()](std::int32_t c) { return c >= 0 && at(c) < corners; };
    return std::ranges::all_of(s.contact_corner, is_corner) && std::ranges::all_of(s.contact_edge, is_corner)
               ? ""
               : "a contact is of a corner that is not there";
}

Outcome PlanarDda::advance(const TimeSpan& span, const body::LoadView& given, Measure, SolidReport& report) {
    if (const std::vector<SceneProblem>& problems = scratch_->scene.problems; !problems.empty()) {
        return {problems.front().message, 0};
    }
    planar_dda::Model& model = scratch_->scene.model;
    const body::LoadView loads = scratch_->point_loads.add(scene_->point_loads, state_.bodies, span.middle(), given);
    planar_dda::read_loads(loads, scratch_->given);
    body::advance_corrections(state_.bodies, span.dt);
    planar_dda::drive_blocks(*scene_, span, state_.bodies, fields_->blocks, model, scratch_->driven);
    const Vec3 gravity = scene_->gravity.at(span.middle());
    book_released(model, *fields_, gravity, report.kick);
    const planar_dda::Accounts before = fields_->blocks.accounts;
    const planar_dda::Step step{span.dt, {gravity.x, gravity.y}, scratch_->given, scratch_->driven};
    const bool has_supports = !model.fixed_points.empty() || !model.bolts.empty();
    const bool may_refuse = model.surfaces.are_damped() && span.dt > settings_->step / finest_pieces;
    const planar_dda::State start = has_supports || may_refuse ? fields_->blocks : planar_dda::State{};
    planar_dda::StepReport taken;
    const Outcome outcome =
        planar_dda::advance(model, scratch_->settings, step, fields_->blocks, scratch_->engine, taken);
    if (!outcome.ok()) {
        return outcome;
    }
    const std::int64_t impact =
        may_refuse ? find_unresolved_impact(model, fields_->blocks, step.gravity, span.dt, scratch_->engine) : -1;
    if (impact >= 0) {
        fields_->blocks = start;
        const planar_dda::Contact& contact = scratch_->engine.contacts[at(impact)];
        return {fmt::format("{} and {} meet too fast for a step of {:.3g} s", model.name_of(contact.a),
                            model.name_of(contact.b), span.dt),
                0.5};
    }
    std::copy(model.is_fixed.begin(), model.is_fixed.end(), fields_->was_held.begin());
    scratch_->loads.clear(at(model.block_count()));
    sum_contacts(scratch_->engine, scratch_->loads);
    sum_supports(model, start, scratch_->engine, span.dt, scratch_->loads, report.kick);
    report.gravity = gravity;
    report.kick_time = span.end();
    report.kick_share = 1;
    book_blocks(model, fields_->blocks, gravity, scratch_->given, scratch_->loads, span.dt, report.kick);
    book_accounts(before, fields_->blocks.accounts, energies_of(model, fields_->blocks), report);
    report.max_depth = taken.largest_overlap;
    report.contact_count = taken.touching_pairs;
    report.open_frictions = taken.open_frictions;
    report.pair_count = static_cast<std::int64_t>(scratch_->engine.search.pairs.size());
    write_bodies(model, fields_->blocks, state_.bodies);
    write_mean_rates(scratch_->engine.motion, span.dt, state_.bodies);
    state_.previous_dt = span.dt;
    return {};
}

}  // namespace riprap::solid
