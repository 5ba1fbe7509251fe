// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/explicit_dda.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/contact/count_pairs.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/key.hpp"
#include "riprap/solid/affine/block_books.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/dda_keys.hpp"
#include "riprap/solid/affine/misfit.hpp"
#include "riprap/solid/affine/released.hpp"
#include "riprap/solid/affine/stiffness_range.hpp"
#include "riprap/solid/explicit_dda/bond_loss.hpp"
#include "riprap/solid/explicit_dda/failure.hpp"

namespace riprap::solid {

using namespace key;

MethodKeys<ExplicitDdaSettings> ExplicitDdaSettings::keys() {
    using Engine = explicit_dda::Settings;
    const KeyList<Engine> engine_keys{
        choice(&Engine::form, "form",
               {{"pseudo_rigid", explicit_dda::Form::pseudo_rigid},
                {"twelve_unknowns", explicit_dda::Form::twelve_unknowns}},
               "Equations of a block: finite strain, or the small strain per step of the papers."),
        number(&Engine::mass_damping, "mass_damping", dimension::frequency, non_negative(),
               "Damping force per mass and velocity.")};
    return {.help = "explicit discontinuous deformation analysis, deformable convex blocks",
            .keys = within(&ExplicitDdaSettings::engine, engine_keys + affine::joint_keys<Engine>()) +
                    within(&ExplicitDdaSettings::elasticity, affine::elastic_keys_of_waves()),
            .check = [](const ExplicitDdaSettings& settings) { return affine::problems_of(settings.elasticity); }};
}

std::vector<material::PropertyUse> ExplicitDda::reads(const Settings& /*settings*/) {
    return affine::contact_uses(true);
}

std::vector<SceneProblem> ExplicitDda::problems_of(const SolidScene& scene, const Settings& settings,
                                                   const body::BodyState& /*bodies*/) {
    std::vector<SceneProblem> problems = affine::scene_problems(scene);
    return problems.empty() ? affine::stiffness_problems(scene, settings.elasticity) : problems;
}

std::size_t ExplicitDda::Scratch::bytes() const {
    return loads.bytes() + bytes_of(pull, engine.placed.vertices, engine.placed.normals, engine.contacts(),
                                    engine.forces, engine.softness);
}

ExplicitDda::ExplicitDda(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                         Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    affine::begin(scene, settings.elasticity, state_.bodies, fields.blocks, fields.contacts, scratch);
}

StepLimit ExplicitDda::limit() const {
    if (!scratch_->problem.empty()) {
        return {};
    }
    for (std::int32_t b = 0; b < scratch_->system.size(); ++b) {
        scratch_->system.is_fixed[at(b)] = body::may_move(scene_->bodies, at(b)) ? 0 : 1;
    }
    return {explicit_dda::stable_step(scratch_->system, fields_->blocks), false,
            "strain modes and contact points of the blocks"};
}

std::span<const Account> ExplicitDda::accounts() {
    static constexpr std::array table{
        Account{"strain", Balance::stored, Booking::at_kick, "stored in strained blocks"},
        Account{"ended_contacts", Balance::lost, Booking::since_kick,
                "stored in contacts that ended while pressed, less what new ones began with, since time 0", true},
        Account{"bonds", Balance::lost, Booking::since_kick, "lost by bonds that broke, since time 0"},
    };
    return table;
}

std::string ExplicitDda::misfit(const SolidScene& scene, const Settings& /*settings*/,
                                const body::BodyState& /*bodies*/, const Fields& fields) {
    return affine::misfit(fields.blocks, fields.contacts, scene.bodies.size());
}

std::vector<contact::ShownContact> ExplicitDda::contacts(const SolidScene& /*scene*/, const Settings& /*settings*/,
                                                         const Fields& /*fields*/, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    const explicit_dda::Scratch& engine = scratch.engine;
    for (std::size_t i = 0; i < engine.forces.size(); ++i) {
        const affine::BlockContact& point = engine.contacts()[i];
        const explicit_dda::ContactForce& found = engine.forces[i];
        if (found.answer.is_open) {
            continue;
        }
        shown.push_back(contact::shown_contact(BodyId{point.a}, BodyId{point.b}, 0.5 * (point.on_a + point.on_b),
                                               found.force, point.normal));
        shown.back().overlap = std::max(0.0, -point.gap);
        shown.back().area = point.area;
        shown.back().is_sliding = found.answer.is_sliding;
    }
    return shown;
}

Outcome ExplicitDda::advance(const TimeSpan& span, const body::LoadView& given, Measure, SolidReport& report) {
    if (!scratch_->problem.empty()) {
        return {scratch_->problem, 0};
    }
    affine::BlockSystem& system = scratch_->system;
    const affine::Piece piece =
        begin_piece(*scene_, span, given, state_.previous_dt, state_.bodies, fields_->blocks, *scratch_);
    explicit_dda::StepReport step;
    const Outcome outcome =
        explicit_dda::advance(system, settings_->engine, span.dt, piece.loads, *fields_, scratch_->engine, step);
    if (!outcome.ok()) {
        const auto [block, what] = find_failure(system, settings_->engine, fields_->blocks);
        return {block < 0 ? outcome.problem : fmt::format("'{}' {}", scene_->bodies.name(BodyId{block}), what),
                outcome.shorten};
    }
    scratch_->loads.clear(at(system.size()));
    for (std::int32_t b = 0; b < system.size(); ++b) {
        scratch_->loads.force[at(b)] = scratch_->engine.loads[at(b)].force;
        scratch_->loads.torque[at(b)] = 2.0 * affine::spin_of(scratch_->engine.loads[at(b)].dipole);
    }
    book_outside(system, fields_->blocks, piece.given, scratch_->loads, span.dt, 0.5 * span.dt, report.kick);
    for (const affine::ReleasedBlock& block : piece.released) {
        book_released_at_middle(system, fields_->blocks, span.dt, block, report.kick);
    }
    write_bodies(system, fields_->blocks, state_.bodies);
    report.gravity = system.gravity;
    report.kick_time = span.middle();
    book_sums(step.sums, report.kick);
    report.kick.damping_loss = step.damping_loss;
    report.kick.external_work = step.external_work;
    report.elastic = step.contact;
    report.friction_loss = step.friction_loss;
    report.own = {step.strain, step.lost_energy, bond_loss(scratch_->engine, *fields_)};
    report.damping_loss = step.dashpot_loss;
    report.dt_bound = step.stable_step;
    report.max_depth = step.deepest;
    report.contact_count = affine::count_touching(fields_->contacts);
    report.pair_count = scratch_->engine.finder.pair_count();
    state_.previous_dt = span.dt;
    return {};
}

}  // namespace riprap::solid
