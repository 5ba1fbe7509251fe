// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/implicit_dda.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
#include "riprap/solid/implicit_dda/bond_loss.hpp"

namespace riprap::solid {

using namespace key;

MethodKeys<ImplicitDdaSettings> ImplicitDdaSettings::keys() {
    using S = ImplicitDdaSettings;
    using Engine = implicit_dda::Settings;
    using implicit_dda::Solver;
    using implicit_dda::SolveSettings;
    const std::vector<Word<Solver>> solvers{
        {"pcg_jacobi", Solver::pcg_jacobi}, {"pcg_cholesky", Solver::pcg_cholesky}, {"sor", Solver::sor}};
    const KeyList<SolveSettings> solve_keys{
        choice(&SolveSettings::solver, "solver", solvers,
               "Solver of the equations: conjugate gradients by preconditioner, or over-relaxation."),
        number(&SolveSettings::tolerance, "solver_tolerance", dimension::plain, between(1e-14, 1e-2),
               "Residual of the equations over their right-hand side."),
        number(&SolveSettings::relaxation, "relaxation", dimension::plain,
               {.low = 0, .high = 2, .is_low_open = true, .is_high_open = true}, "Over-relaxation factor.")
            .read_with("solver", {"sor"})};
    const KeyList<Engine> engine_keys{
        number(&Engine::max_displacement, "max_displacement", dimension::plain, above(0, 1),
               "A step that moves a corner farther than this share of the smallest block is cut."),
        number_or(&Engine::slide_tolerance, "slide_tolerance", "reversal", dimension::length, non_negative(),
                  "A sliding contact locks where it slips by less than this in a step, as in the source, or by "
                  "\"reversal\": where its slip turns back or falls below the strength."),
        integer(&Engine::open_close, "open_close", 1, 100,
                "Rounds of the open-close iteration before the step is cut."),
        number(&Engine::dynamic, "dynamic_factor", dimension::plain, between(0, 1),
               "Share of the velocity that the next step begins with: 1 = dynamic, 0 = static.")};
    return {
        .help = "implicit discontinuous deformation analysis, deformable convex blocks",
        .keys = within(&S::engine, within(&Engine::solve, solve_keys) + engine_keys + affine::joint_keys<Engine>()) +
                within(&S::elasticity, affine::elastic_keys_in_space()) + KeyList<S>{affine::wanted_step<S>()},
        .check = [](const S& settings) { return affine::problems_of(settings.elasticity); }};
}

std::vector<material::PropertyUse> ImplicitDda::reads(const Settings& /*settings*/) {
    return affine::contact_uses(false);
}

std::vector<SceneProblem> ImplicitDda::problems_of(const SolidScene& scene, const Settings& settings,
                                                   const body::BodyState& /*bodies*/) {
    std::vector<SceneProblem> problems = affine::scene_problems(scene);
    return problems.empty() ? affine::stiffness_problems(scene, settings.elasticity) : problems;
}

std::size_t ImplicitDda::Scratch::bytes() const {
    const implicit_dda::Equations& equations = engine.equations;
    return loads.bytes() + equations.matrix.bytes() + equations.pcg.bytes() +
           equations.sides.capacity() * sizeof(implicit_dda::SideSum) +
           bytes_of(pull, engine.placed.vertices, engine.placed.normals, engine.found(), engine.contacts,
                    equations.pairs, equations.right, equations.solution, equations.diagonal);
}

ImplicitDda::ImplicitDda(const SolidScene& scene, const Settings& settings, const SolidState& state, Fields& fields,
                         Scratch& scratch)
    : scene_(&scene), settings_(&settings), state_(state), fields_(&fields), scratch_(&scratch) {
    affine::begin(scene, settings.elasticity, state_.bodies, fields.blocks, fields.contacts, scratch);
}

namespace {

/// Contact force on a at the end of a step [N].
Vec3 contact_force(const implicit_dda::ContactTerm& c) {
    const implicit_dda::ContactTrial& trial = c.trial;
    if (trial.mode == affine::ContactMode::open) {
        return {};
    }
    const Vec3 push = (c.springs.normal * trial.gap) * c.normal;
    return trial.mode == affine::ContactMode::lock ? push - c.springs.shear * trial.slip
                                                   : push - trial.friction * trial.direction;
}

void sum_contacts(const implicit_dda::Scratch& engine, body::Loads& loads) {
    for (std::size_t i = 0; i < engine.contacts.size(); ++i) {
        const implicit_dda::ContactTerm& c = engine.contacts[i];
        const Vec3 force = contact_force(c);
        const auto a = at(engine.found()[i].a), b = at(engine.found()[i].b);
        loads.force[a] += force;
        loads.force[b] -= force;
        loads.torque[a] += cross(c.arm_a, force);
        loads.torque[b] -= cross(c.arm_b, force);
    }
}

/// Force and torque of fixed points on their blocks; as they come from outside, their impulses besides.
void sum_fixed_points(const std::vector<body::FixedPoint>& points, const implicit_dda::Scratch& engine,
                      const affine::BlockState& blocks, double dt, body::Loads& loads, KickReport& kick) {
    for (std::size_t i = 0; i < points.size() && i < engine.point_forces.size(); ++i) {
        const auto b = at(points[i].body.value);
        const auto& [arm, force] = engine.point_forces[i];
        loads.force[b] += force;
        loads.torque[b] += cross(arm, force);
        kick.impulse += dt * force;
        kick.angular_impulse += dt * cross(blocks.position[b] + arm, force);
    }
}

/// Writes the mean rates of stretching over the step. Those of the method at the end of a step change their sign from
/// step to step where a block is stiff.
void write_mean_rates(const implicit_dda::Scratch& engine, double dt, body::BodyState& bodies) {
    for (std::size_t row = 0; row < engine.block.size(); ++row) {
        const Mat3 d =
            (1 / dt) * affine::symmetric_part(implicit_dda::gradient_of(&engine.equations.solution[12 * row]));
        bodies.stretch_rate[at(engine.block[row])] = {d(0, 0), d(1, 1), d(2, 2), d(0, 1), d(0, 2), d(1, 2)};
    }
}

}  // namespace

std::span<const Account> ImplicitDda::accounts() {
    static constexpr std::array table{
        Account{"strain", Balance::stored, Booking::at_kick, "stored in strained blocks"},
        Account{"ended_contacts", Balance::lost, Booking::since_kick,
                "stored in contacts that ended while pressed, less what new ones began with, since time 0", true},
        Account{"bonds", Balance::lost, Booking::since_kick, "lost by bonds that broke, since time 0"},
        Account{"numerical_damping", Balance::lost, Booking::across_kick,
                "lost by the integration of motion and strain since time 0", true},
        Account{"static_damping", Balance::lost, Booking::across_kick, "lost to dynamic_factor since time 0"},
    };
    return table;
}

std::string ImplicitDda::misfit(const SolidScene& scene, const Settings& /*settings*/,
                                const body::BodyState& /*bodies*/, const Fields& fields) {
    return affine::misfit(fields.blocks, fields.contacts, scene.bodies.size());
}

std::vector<contact::ShownContact> ImplicitDda::contacts(const SolidScene& /*scene*/, const Settings& /*settings*/,
                                                         const Fields& fields, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    const implicit_dda::Scratch& engine = scratch.engine;
    for (std::size_t i = 0; i < engine.contacts.size(); ++i) {
        const affine::BlockContact& point = engine.found()[i];
        const implicit_dda::ContactTerm& c = engine.contacts[i];
        if (c.trial.mode == affine::ContactMode::open) {
            continue;
        }
        shown.push_back(contact::shown_contact(BodyId{point.a}, BodyId{point.b},
                                               fields.blocks.position[at(point.a)] + c.arm_a, contact_force(c),
                                               c.normal));
        shown.back().overlap = std::max(0.0, -c.trial.gap);
        shown.back().area = point.area;
        shown.back().is_sliding = c.trial.mode == affine::ContactMode::slide;
    }
    return shown;
}

Outcome ImplicitDda::advance(const TimeSpan& span, const body::LoadView& given, Measure, SolidReport& report) {
    if (!scratch_->problem.empty()) {
        return {scratch_->problem, 0};
    }
    affine::BlockSystem& system = scratch_->system;
    const affine::Piece piece =
        begin_piece(*scene_, span, given, state_.previous_dt, state_.bodies, fields_->blocks, *scratch_);
    implicit_dda::StepReport step;
    const Outcome outcome =
        implicit_dda::advance(system, settings_->engine, span.dt, piece.loads, *fields_, scratch_->engine, step);
    if (const auto [a, b] = step.unsettled; a >= 0) {
        return {fmt::format("contacts of '{}' and '{}' open and close without end", scene_->bodies.name(BodyId{a}),
                            scene_->bodies.name(BodyId{b})),
                outcome.shorten};
    }
    if (step.singular >= 0) {
        return {fmt::format("the stiffness of '{}' is singular: nothing but springs of contacts holds it in a step "
                            "as long as this",
                            scene_->bodies.name(BodyId{step.singular})),
                outcome.shorten};
    }
    if (!outcome.ok()) {
        return outcome;
    }
    scratch_->loads.clear(at(system.size()));
    sum_contacts(scratch_->engine, scratch_->loads);
    sum_fixed_points(system.fixed_points, scratch_->engine, fields_->blocks, span.dt, scratch_->loads, report.kick);
    book_outside(system, fields_->blocks, piece.given, scratch_->loads, span.dt, 0, report.kick);
    for (const affine::ReleasedBlock& block : piece.released) {
        book_released(system, fields_->blocks, block, report.kick);
    }
    write_bodies(system, fields_->blocks, state_.bodies);
    write_mean_rates(scratch_->engine, span.dt, state_.bodies);
    report.gravity = system.gravity;
    report.kick_time = span.end();
    report.kick_share = 1;
    book_sums(step.sums, report.kick);
    report.kick.external_work = step.external_work;
    report.elastic = step.contact;
    report.friction_loss = step.friction_loss;
    report.own = {step.strain, step.lost_energy, bond_loss(scratch_->engine), step.numerical_loss, step.static_loss};
    report.max_depth = step.deepest;
    report.contact_count = affine::count_touching(fields_->contacts);
    report.pair_count = scratch_->engine.finder.pair_count();
    state_.previous_dt = span.dt;
    return {};
}

}  // namespace riprap::solid
