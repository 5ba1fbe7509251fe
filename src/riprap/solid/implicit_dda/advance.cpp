// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/implicit_dda/bond_loss.hpp"

namespace riprap::solid::implicit_dda {

using affine::BlockSystem, affine::rows_at;

namespace {

double smallest_block(const BlockSystem& system) {
    double size = std::numeric_limits<double>::infinity();
    for (std::int32_t b = 0; b < system.size(); ++b) {
        size = system.is_fixed[at(b)] == 0 ? std::min(size, system.shape_of(b).size) : size;
    }
    return std::isfinite(size) ? size : 1;
}

/// Largest approach of two corners in a step [m].
double way_of_step(const BlockSystem& system, const affine::BlockState& state, double dt) {
    const double speed = parallel::reduce(
        system.size(), 0.0,
        [&](std::int64_t i) {
            const Mat3 l = rows_at(state.velocity_gradient, at(i));
            const double turn = std::sqrt(norm_squared(l.row[0]) + norm_squared(l.row[1]) + norm_squared(l.row[2]));
            return norm(state.velocity[at(i)]) + turn * system.shapes[at(system.shape[at(i)])].circumradius;
        },
        [](double x, double y) { return std::max(x, y); });
    return 2 * (speed * dt + 0.5 * norm(system.gravity) * dt * dt);
}

void number_rows(const BlockSystem& system, Scratch& scratch) {
    scratch.row.assign(at(system.size()), -1);
    scratch.block.clear();
    for (std::int32_t b = 0; b < system.size(); ++b) {
        if (system.is_fixed[at(b)] == 0) {
            scratch.row[at(b)] = static_cast<std::int32_t>(scratch.block.size());
            scratch.block.push_back(b);
        }
    }
}

ContactSprings springs_of(const affine::Surface& surface, double area) {
    const double factor = surface.is_per_area ? area : 1;
    return {factor * surface.normal_stiffness, factor * surface.shear_stiffness, surface.friction,
            surface.cohesion * area, surface.tension * area};
}

/// Motion in the step of a point of a block that loads do not move.
Vec3 prescribed_motion(const BlockSystem& system, const affine::BlockState& state, std::int32_t block,
                       const Vec3& point, double dt) {
    const auto b = at(block);
    if (system.is_fixed[b] == 0) {
        return {};
    }
    return dt * (state.velocity[b] + rows_at(state.velocity_gradient, b) * (point - state.position[b]));
}

ContactTerm make_term(const BlockSystem& system, const State& state, const Scratch& scratch,
                      const affine::BlockContact& found, double dt) {
    ContactTerm c{};
    c.row_a = scratch.row[at(found.a)];
    c.row_b = scratch.row[at(found.b)];
    c.arm_a = found.on_a - state.blocks.position[at(found.a)];
    c.arm_b = found.on_b - state.blocks.position[at(found.b)];
    c.normal = found.normal;
    c.springs = springs_of(system.surface_of(found.a, found.b), found.area);
    c.prescribed = prescribed_motion(system, state.blocks, found.a, found.on_a, dt) -
                   prescribed_motion(system, state.blocks, found.b, found.on_b, dt);
    c.gap = found.gap - dot(found.normal, c.prescribed);
    ContactTrial& trial = c.trial;
    trial.gap = found.gap;
    trial.is_intact = found.old < 0 && begins_bonded(state.contacts, found.a, found.b);
    const bool is_tied = trial.is_intact && c.springs.normal * found.gap <= c.springs.tension;
    trial.mode = found.gap < 0 || is_tied ? ContactMode::lock : ContactMode::open;
    if (found.old >= 0) {
        const affine::BlockContactHistory& history = state.contacts;
        const auto row = at(found.old);
        trial.mode = static_cast<ContactMode>(history.mode[row]);
        trial.is_intact = history.is_intact[row] != 0;
        trial.slip_before = affine::turn_with_plane(history.slip[row], history.normal[row], found.normal);
        trial.slip_before -= dot(trial.slip_before, found.normal) * found.normal;
        const double size = norm(trial.slip_before);
        trial.direction = size > 0 ? trial.slip_before / size : Vec3{};
        trial.friction = strength(c.springs, trial);
        trial.across = c.springs.shear;
    }
    return c;
}

/// Inertia, elasticity, loads, stress and fixed points of every row.
void fill_blocks(const BlockSystem& system, const std::vector<FixedPoint>& fixed_points, const Settings& settings,
                 double dt, const affine::BlockLoads& external, const affine::BlockState& state, Scratch& scratch) {
    Equations& equations = scratch.equations;
    equations.diagonal.resize(scratch.block.size());
    equations.given.resize(scratch.block.size());
    equations.solution.resize(scratch.block.size() * 12);
    parallel::for_each_uneven(static_cast<std::int64_t>(scratch.block.size()), 64, [&](std::int64_t row) {
        const std::int32_t block = scratch.block[at(row)];
        const auto b = at(block);
        const Mat3 f = rows_at(state.deformation, b);
        const double volume = system.shape_of(block).volume * determinant(f);
        const Matrix12 inertia = inertia_matrix(system.mass[b], f * system.inertia[b] * transpose(f));
        const Vector12 velocity = unknowns_of(state.velocity[b], rows_at(state.velocity_gradient, b));
        const Vector12 momentum = times(inertia, velocity);
        const Vec3 force = external.force.empty() ? Vec3{} : external.force[b];
        Vector12 given = load_vector(force + system.mass[b] * system.gravity, dipole(external, b));
        add_initial_stress(rows_at(state.stress, b), volume, given);
        Matrix12& k = equations.diagonal[at(row)];
        for (std::size_t i = 0; i < 144; ++i) {
            k[i] = 2 / (dt * dt) * inertia[i];
        }
        add_elastic(system.material_of(block), volume, k);
        for (std::size_t i = 0; i < 12; ++i) {
            given[i] += settings.dynamic * 2 / dt * momentum[i];
            equations.solution[at(row) * 12 + i] = settings.dynamic * dt * velocity[i];
        }
        equations.given[at(row)] = given;
    });
    for (const FixedPoint& point : fixed_points) {
        const std::int32_t row = scratch.row[at(point.block)];
        if (row >= 0) {
            const Vec3 arm = rows_at(state.deformation, at(point.block)) * point.place;
            const DisplacementMatrix t = displacement_matrix(arm);
            add_springs(t, t, point.stiffness * Mat3::identity(), 1, equations.diagonal[at(row)].data());
            add_force(t, point.stiffness * (point.anchor - state.position[at(point.block)] - arm),
                      equations.given[at(row)].data());
        }
    }
}

/// Friction of what slides has settled to this share of the largest push.
constexpr double friction_tolerance = 1e-6;

/// Changes of all contacts in one round of the iteration.
struct Round {
    std::int64_t changed{-1};  ///< a contact whose springs came or went; -1 = none
    double push{0};            ///< largest push [N]
    double unsettled{0};       ///< largest change of a friction [N]
};

/// Takes gap and slip of a contact from the solution and its mode from them.
Round update_contact(const OpenCloseRule& rule, std::int64_t number, Scratch& scratch) {
    ContactTerm& c = scratch.contacts[at(number)];
    evaluate(scratch.equations, c);
    const double friction = c.trial.friction;
    const Vec3 direction = c.trial.direction;
    const ContactMode mode = c.trial.mode;
    Round round;
    if (update_mode(c.springs, rule, c.trial)) {
        round.changed = number;
    } else if (c.trial.mode == ContactMode::slide) {
        round.unsettled = norm(c.trial.friction * c.trial.direction - friction * direction);
    }
    scratch.is_moved[at(number)] = c.trial.mode != mode || c.trial.mode == ContactMode::slide ? 1 : 0;
    round.push = std::max(0.0, -c.springs.normal * c.trial.gap);
    return round;
}

/// Updates all contacts by the solution; rows of those that have changed are stale then.
Round update_contacts(const OpenCloseRule& rule, Scratch& scratch) {
    scratch.is_moved.resize(scratch.contacts.size());
    const Round all = parallel::reduce(
        static_cast<std::int64_t>(scratch.contacts.size()), Round{},
        [&](std::int64_t i) { return update_contact(rule, i, scratch); },
        [](const Round& x, const Round& y) {
            return Round{std::max(x.changed, y.changed), std::max(x.push, y.push), std::max(x.unsettled, y.unsettled)};
        });
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        if (scratch.is_moved[i] != 0) {
            mark_stale(scratch.contacts[i], scratch.equations);
        }
    }
    return all;
}

/// Assembles and solves until no spring comes or goes and friction has settled.
affine::Outcome iterate(const Settings& settings, Scratch& scratch, StepReport& report) {
    Equations& equations = scratch.equations;
    const OpenCloseRule rule{0, 0, settings.slide_tolerance};
    for (report.open_close = 1; report.open_close <= 2 * settings.open_close; ++report.open_close) {
        assemble(scratch.contacts, equations);
        const linear::SolveReport solved = solve(settings.solve, equations);
        report.solver_iterations += solved.iterations;
        if (equations.singular_row >= 0) {
            report.singular = scratch.block[at(equations.singular_row)];
            return {fmt::format("the stiffness of block {} is singular", report.singular), settings.cut};
        }
        if (!solved.is_converged() && solved.residual > 1e3 * settings.solve.tolerance) {
            return {fmt::format("the equations of the step were not solved: {}", describe(solved.status)),
                    settings.cut};
        }
        const auto [changed, push, unsettled] = update_contacts(rule, scratch);
        if (changed < 0 && (unsettled <= friction_tolerance * push || report.open_close > settings.open_close)) {
            return {};
        }
        if (changed >= 0 && report.open_close >= settings.open_close) {
            const affine::BlockContact& c = scratch.found()[at(changed)];
            report.unsettled = {c.a, c.b};
            return {fmt::format("contacts of blocks {} and {} open and close without end", c.a, c.b), settings.cut};
        }
    }
    return {};
}

void reserve(affine::BlockContactHistory& history, std::size_t count) {
    const auto grow = [count](auto&... arrays) { (arrays.reserve(count), ...); };
    grow(history.pair, history.feature, history.plane, history.normal, history.slip, history.mode, history.is_intact,
         history.energy);
}

/// Remembers what is closed, with the slip that its shear spring holds, and which bonds are left; books energies.
void remember(Scratch& scratch, double bond_tolerance, affine::BlockContactHistory& history, StepReport& report) {
    std::swap(scratch.old, history);
    history.clear();
    reserve(history, scratch.contacts.size());
    affine::BondChanges bonds;
    const bool has_bonds = !scratch.old.bonded.empty();
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        const ContactTerm& c = scratch.contacts[i];
        const affine::BlockContact& found = scratch.found()[i];
        const ContactTrial& trial = c.trial;
        const bool was_closed = found.old >= 0 || found.gap < 0;
        const Vec3 slip = slip_kept(c);
        if (trial.mode == ContactMode::slide) {
            report.friction_loss += trial.friction * dot(trial.step_slip, trial.direction);
        }
        const double stored = trial.mode == ContactMode::open ? 0 : spring_energy(c.springs, trial.gap, slip);
        const double held = was_closed ? spring_energy(c.springs, found.gap, trial.slip_before) : 0;
        // Work done by the blocks against the springs, as the equations count it, less the energy stored.
        double work = trial.mode == ContactMode::open ? 0 : c.springs.normal * trial.gap * (trial.gap - found.gap);
        work += trial.mode == ContactMode::lock ? c.springs.shear * dot(trial.slip, trial.step_slip) : 0;
        report.numerical_loss += work - (stored - held) - bond_loss(found, c);
        report.lost_energy -= held;
        report.contact += stored;
        const bool is_closed = trial.mode != ContactMode::open;
        const bool is_intact = trial.is_intact && trial.mode == ContactMode::lock;
        if (has_bonds) {
            bonds.look_at(found, trial.is_intact, is_closed, is_intact, bond_tolerance);
        }
        if (!is_closed) {
            continue;
        }
        report.deepest = std::max(report.deepest, -trial.gap);
        report.sliding_count += trial.mode == ContactMode::slide ? 1 : 0;
        ++report.contact_count;
        history.pair.push_back(contact::pair_key({found.a, found.b}));
        history.feature.push_back(found.feature);
        history.plane.push_back(found.plane);
        history.normal.push_back(found.normal);
        history.slip.push_back(slip);
        history.mode.push_back(static_cast<std::uint8_t>(trial.mode));
        history.is_intact.push_back(is_intact ? 1 : 0);
        history.energy.push_back(stored);
    }
    for (const double energy : scratch.old.energy) {
        report.lost_energy += energy;
    }
    history.bonded = bonds_left(scratch.old.bonded, bonds);
}

/// Largest motion of a corner, for the limit of a step.
double largest_displacement(const BlockSystem& system, const affine::BlockState& state, const Scratch& scratch) {
    return parallel::reduce(
        static_cast<std::int64_t>(scratch.block.size()), 0.0,
        [&](std::int64_t row) {
            const std::int32_t block = scratch.block[at(row)];
            const double* d = &scratch.equations.solution[at(row) * 12];
            const Mat3 g = gradient_of(d) * rows_at(state.deformation, at(block));
            double most = 0;
            for (const Vec3& x : system.shape_of(block).vertices) {
                most = std::max(most, norm_squared(Vec3{d[0], d[1], d[2]} + g * x));
            }
            return std::sqrt(most);
        },
        [](double x, double y) { return std::max(x, y); });
}

/// Moves the blocks by the solution: exact rotation, stress, velocities V = 2 D/dt - V(0).
void move_blocks(const BlockSystem& system, const Settings& settings, double dt, const Scratch& scratch,
                 affine::BlockState& state) {
    parallel::for_each_uneven(system.size(), 64, [&](std::int64_t i) {
        const auto b = at(i);
        const auto block = static_cast<std::int32_t>(i);
        if (scratch.row[b] < 0) {
            state.position[b] += dt * state.velocity[b];
            affine::update_block(system, block, dt * rows_at(state.velocity_gradient, b), state);
            return;
        }
        const double* d = &scratch.equations.solution[at(scratch.row[b]) * 12];
        const Vec3 moved{d[0], d[1], d[2]};
        const Mat3 gradient = gradient_of(d);
        state.position[b] += moved;
        state.velocity[b] = (2 / dt) * moved - settings.dynamic * state.velocity[b];
        affine::set_rows(state.velocity_gradient, b,
                         (2 / dt) * gradient - settings.dynamic * rows_at(state.velocity_gradient, b));
        update_block(system, block, gradient, state);
    });
}

/// Books strain energy, its numerical loss and the work of given loads; before the blocks move.
void book_blocks(const BlockSystem& system, const affine::BlockLoads& external, const affine::BlockState& state,
                 const std::vector<FixedPoint>& fixed_points, Scratch& scratch, StepReport& report) {
    for (std::size_t row = 0; row < scratch.block.size(); ++row) {
        const std::int32_t block = scratch.block[row];
        const auto b = at(block);
        const double* d = &scratch.equations.solution[row * 12];
        const Mat3 strain = affine::symmetric_part(gradient_of(d));
        const affine::Material& material = system.material_of(block);
        const double volume = system.shape_of(block).volume * determinant(rows_at(state.deformation, b));
        const Mat3 before = affine::elastic_strain(material, rows_at(state.stress, b));
        report.strain += volume * elastic_energy(material, before + strain);
        report.numerical_loss += volume * elastic_energy(material, strain);
        const Vec3 force = external.force.empty() ? Vec3{} : external.force[b];
        const Vector12 load = load_vector(force, dipole(external, b));
        for (std::size_t i = 0; i < 12; ++i) {
            report.external_work += load[i] * d[i];
        }
    }
    scratch.point_forces.assign(fixed_points.size(), std::pair<Vec3, Vec3>{});
    for (std::size_t i = 0; i < fixed_points.size(); ++i) {
        const FixedPoint& point = fixed_points[i];
        const std::int32_t row = scratch.row[at(point.block)];
        if (row >= 0) {
            const Vec3 arm = rows_at(state.deformation, at(point.block)) * point.place;
            const Vec3 moved = displacement(displacement_matrix(arm), &scratch.equations.solution[at(row) * 12]);
            const Vec3 off = state.position[at(point.block)] + arm - point.anchor;
            scratch.point_forces[i] = {arm, -point.stiffness * (off + moved)};
            report.contact += 0.5 * point.stiffness * norm_squared(off + moved);
            report.numerical_loss += 0.5 * point.stiffness * norm_squared(moved);
        }
    }
}

}  // namespace

affine::Outcome advance(const BlockSystem& system, const std::vector<FixedPoint>& fixed_points,
                        const Settings& settings, double dt, const affine::BlockLoads& external, State& state,
                        Scratch& scratch, StepReport& report) {
    report = {};
    Laps laps;
    const double size = smallest_block(system);
    const double tearing = state.contacts.bonded.empty() ? 0 : affine::tearing_gap(system);
    const double reach =
        std::max(settings.reach * size, tearing) + std::min(way_of_step(system, state.blocks, dt), size);
    number_rows(system, scratch);
    place_blocks(system, state.blocks, scratch.placed);
    const auto& found = scratch.finder.find(system, state.blocks, scratch.placed, state.contacts, reach);
    scratch.contacts.resize(found.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(found.size()), 64, [&](std::int64_t i) {
        scratch.contacts[at(i)] = make_term(system, state, scratch, found[at(i)], dt);
    });
    laps.end(scratch.times.find_contacts);
    fill_blocks(system, fixed_points, settings, dt, external, state.blocks, scratch);
    link_rows(static_cast<std::int64_t>(scratch.block.size()), scratch.contacts, scratch.equations);
    affine::Outcome outcome = iterate(settings, scratch, report);
    laps.end(scratch.times.contact_loads);
    if (!outcome.ok()) {
        return outcome;
    }
    report.largest_displacement = largest_displacement(system, state.blocks, scratch);
    const double ratio = report.largest_displacement / (settings.max_displacement * size);
    if (!(ratio <= 1)) {
        return {fmt::format("a corner moves {:.3g} m in one step", report.largest_displacement),
                std::isfinite(ratio) ? std::min(0.9, 1 / ratio) : settings.cut};
    }
    book_blocks(system, external, state.blocks, fixed_points, scratch, report);
    if (settings.dynamic != 1) {
        report.static_loss = (1 - settings.dynamic * settings.dynamic) * measure(system, state.blocks).kinetic;
    }
    remember(scratch, affine::bond_tolerance * size, state.contacts, report);
    laps.end(scratch.times.measure);
    move_blocks(system, settings, dt, scratch, state.blocks);
    laps.end(scratch.times.move_bodies);
    report.sums = measure(system, state.blocks);
    laps.end(scratch.times.measure);
    return {};
}

affine::Outcome advance_in_pieces(const BlockSystem& system, const std::vector<FixedPoint>& fixed_points,
                                  const Settings& settings, double dt, const affine::BlockLoads& external, State& state,
                                  Scratch& scratch, StepReport& report) {
    double left = dt, piece = dt;
    StepReport total;
    while (left > 0) {
        piece = std::min(piece, left);
        const affine::Outcome outcome =
            advance(system, fixed_points, settings, piece, external, state, scratch, report);
        if (outcome.ok()) {
            left = left - piece < 1e-9 * dt ? 0 : left - piece;
            total.friction_loss += report.friction_loss;
            total.numerical_loss += report.numerical_loss;
            total.lost_energy += report.lost_energy;
            total.static_loss += report.static_loss;
            total.external_work += report.external_work;
            total.open_close += report.open_close;
            total.solver_iterations += report.solver_iterations;
            piece *= 1.5;
        } else if (outcome.shorten > 0 && piece * outcome.shorten > dt / 1024) {
            piece *= outcome.shorten;
        } else {
            return {outcome.problem + fmt::format("; the step of {:.3g} s was cut to {:.3g} s", dt, piece), 0};
        }
    }
    report.friction_loss = total.friction_loss;
    report.numerical_loss = total.numerical_loss;
    report.lost_energy = total.lost_energy;
    report.static_loss = total.static_loss;
    report.external_work = total.external_work;
    report.open_close = total.open_close;
    report.solver_iterations = total.solver_iterations;
    return {};
}

}  // namespace riprap::solid::implicit_dda
