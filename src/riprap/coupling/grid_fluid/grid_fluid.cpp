// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/grid_fluid/grid_fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/bytes.hpp"
#include "riprap/coupling/added_mass.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/coupling/grid_fluid/carried_water.hpp"
#include "riprap/coupling/grid_fluid/grid_bodies.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/coupling/grid_fluid/pocket_pressure.hpp"
#include "riprap/coupling/grid_fluid/sliding_sides.hpp"
#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/pressure.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::GridScratch;
using fluid::grid::GridSettings;
using fluid::grid::GridState;

void note_cut(const body::Motion& motion, GridFluidFields& fields) {
    fields.cut_position.resize(motion.pose.size());
    fields.cut_orientation.resize(motion.pose.size());
    for (std::size_t b = 0; b < motion.pose.size(); ++b) {
        fields.cut_position[b] = motion.pose[b].position;
        fields.cut_orientation[b] = motion.pose[b].orientation;
    }
    fields.cut_stretch = motion.stretch;
}

/// Steps grow from this share of what gravity allows in water at rest by this share of the time since the start [-].
/// Water goes through a step with the velocity of its start, so it gains speed in the first step without falling; the
/// next steps take that energy back only where they are as long, and a column let go speeds up at its foot by more than
/// g. Free bodies take up their weight and buoyancy first, for which no force of a contact is known yet.
constexpr double first_share = 0.02, share_of_time = 0.05;

/// Of every body that moves, so that its loads are always those of its own acceleration [-]. A body in air feels water
/// too, through air that cannot get away: a unit that falls on others, say, or a piston over a cushion of air. By its
/// wet surface alone it would feel nothing, and a load that lags by a step swings from step to step.
const double least_feedback = 1.5 * AddedMassIteration::iterates_above;

/// Added mass over mass of every body that forces may move: that of the water it displaces, as far as it is wet, and
/// least_feedback at least.
std::vector<double> added_mass_shares(const FluidScene& scene, const GridFluidSettings& settings,
                                      const GridState& water, const CutBodies& cut) {
    const auto count = at(scene.bodies.size());
    std::vector<double> wet(count), whole(count), share(count);
    for (const CutFacet& facet : cut.facets) {
        const double area = norm(facet.area);
        whole[at(facet.body)] += area;
        wet[at(facet.body)] += area * (facet.joint < 0 && moves_fluid(facet) ? water.fraction[at(facet.cell)] : 0);
    }
    for (std::size_t b = 0; b < count; ++b) {
        double volume = 0;
        for (std::int32_t p = scene.bodies.part_begin[b]; p < scene.bodies.part_begin[b + 1]; ++p) {
            volume += scene.shapes.volume(scene.bodies.parts[at(p)].shape);
        }
        const double mass = scene.bodies.mass[b];
        const double by_wet_surface = wet[b] / whole[b] * settings.rest_density * volume / mass;
        share[b] = whole[b] > 0 && mass > 0 ? std::max(by_wet_surface, least_feedback) : 0;
    }
    return share;
}

Vec3 momentum_of(const GridSettings& settings, const GridState& state, const GridScratch& s) {
    const auto& box = settings.mesh.box;
    return fluid::grid::sum_cells(box, [&](std::int64_t c, int, int, int) {
        const double mass = s.room.capacity[at(c)] * fluid::grid::density_of(settings, state.fraction[at(c)]);
        Vec3 p{};
        for (int a = 0; a < box.axes; ++a) {
            const auto& u = state.velocity[at(a)];
            p[a] = 0.5 * mass * (u[at(c)] + u[at(c + box.stride[at(a)])]);
        }
        return p;
    });
}

double fastest_water(const GridSettings& settings, const GridState& state, const GridScratch& s) {
    const auto& box = settings.mesh.box;
    return std::sqrt(fluid::grid::reduce_cells(
        box, 0.0,
        [&](std::int64_t c, int, int, int) {
            if (state.fraction[at(c)] < 0.5 || s.room.capacity[at(c)] == 0) {
                return 0.0;
            }
            double square = 0;
            for (int a = 0; a < box.axes; ++a) {
                const auto& u = state.velocity[at(a)];
                const double mean = 0.5 * (u[at(c)] + u[at(c + box.stride[at(a)])]);
                square += mean * mean;
            }
            return square;
        },
        fluid::grid::max_of));
}

/// First moment of mass that cells cut by bodies have beyond that of their water at their centres [kg m]: that of what
/// is open in a cell, by the divergence theorem over its open faces and facets, exact for polyhedra.
Vec3 moment_of_cut_cells(const GridSettings& settings, const GridState& water, const GridScratch& s,
                         const CutBodies& cut) {
    const fluid::grid::Mesh& mesh = settings.mesh;
    std::vector<std::int64_t> cells;
    for (const CutFacet& facet : cut.facets) {
        if (s.open.volume[at(facet.cell)] > 0 && bounds_cell(facet)) {
            cells.push_back(facet.cell);
        }
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::vector<Vec3> moment(cells.size()), centre(cells.size());
    const auto number = [&](std::int64_t cell) {
        return at(std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin());
    };
    for (std::size_t k = 0; k < cells.size(); ++k) {
        std::int64_t rest = cells[k];
        std::array<int, 3> place{};
        for (int a = 2; a >= 0; --a) {
            place[at(a)] = static_cast<int>(rest / mesh.box.stride[at(a)]) - mesh.box.pad[at(a)];
            rest %= mesh.box.stride[at(a)];
        }
        centre[k] = mesh.centre(place[0], place[1], place[2]);
        for (int a = 0; a < mesh.box.axes; ++a) {
            const double half = 0.5 * mesh.h(a, place[at(a)]);
            moment[k][a] =
                0.5 * half * half *
                (s.room.area[at(a)][at(cells[k] + mesh.box.stride[at(a)])] - s.room.area[at(a)][at(cells[k])]);
        }
    }
    for (const CutFacet& facet : cut.facets) {
        if (s.open.volume[at(facet.cell)] > 0 && bounds_cell(facet)) {
            const std::size_t k = number(facet.cell);
            for (int a = 0; a < mesh.box.axes; ++a) {
                for (const Vec3& x : facet.middle) {
                    moment[k][a] -= facet.area[a] * std::pow(x[a] - centre[k][a], 2) / 6;
                }
            }
        }
    }
    Vec3 sum{};
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const double porosity = s.medium.has_stones ? s.medium.porosity[at(cells[k])] : 1;
        sum += porosity * fluid::grid::density_of(settings, water.fraction[at(cells[k])]) * moment[k];
    }
    return sum;
}

/// Work of the pressure on bodies in half of a step: bodies are cut out where they are at its middle, and the energy of
/// the water at its end is less by what they take until then [J]. Made of the State alone, shear left out.
double work_of_half(const GridSettings& settings, const GridState& water, const GridScratch& s,
                    const std::vector<GridBody>& bodies, const CutBodies& cut, double dt, double time) {
    CutBodies surfaces;
    surfaces.facets = cut.facets;
    surfaces.joints = cut.joints;
    double power = 0;
    const std::vector<GridLoad> loads = cut_loads(settings, water, s, bodies, surfaces, time);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        power += dot(loads[b].pressure, bodies[b].velocity) + dot(loads[b].torque, bodies[b].angular_velocity);
    }
    return 0.5 * dt * power;
}

/// Returns what the first moment of mass lacks to that of the time of the velocities: in one pass the water goes
/// through a step with the velocity of its start, so it is behind by half of what the speed grew, and all of it since
/// the start adds up to dt/2 rho u [kg m].
Vec3 lag_of(const GridSettings& settings, const Vec3& momentum, double dt) {
    return settings.outer_corrections > 1 ? Vec3{} : 0.5 * dt * momentum;
}

/// Energy that comes in through the sides in a step: (P + rho u^2/2) u A dt with P = p - rho g.(x - datum) of the cell
/// inside [J].
double energy_through_sides(const GridSettings& settings, const GridState& state, const GridScratch& s, double dt) {
    const auto& box = settings.mesh.box;
    double sum = 0;
    for (int side = 0; side < 2 * box.axes; ++side) {
        if (fluid::grid::is_wall(settings.side[at(side)].kind)) {
            continue;
        }
        const int a = side / 2;
        const bool is_high = side % 2 == 1;
        std::array<int, 3> first{}, last = box.cells;
        first[at(a)] = is_high ? box.cells[at(a)] - 1 : 0;
        last[at(a)] = first[at(a)] + 1;
        for (int k = first[2]; k < last[2]; ++k) {
            for (int j = first[1]; j < last[1]; ++j) {
                for (int i = first[0]; i < last[0]; ++i) {
                    const std::int64_t c = box.index(i, j, k), f = is_high ? c + box.stride[at(a)] : c;
                    const double u = state.velocity[at(a)][at(f)];
                    const double inward = (is_high ? -u : u) * s.room.area[at(a)][at(f)] * dt;
                    const double density = fluid::grid::density_of(settings, state.fraction[at(c)]);
                    sum += inward * (state.pressure[at(c)] + 0.5 * density * u * u);
                }
            }
        }
    }
    return sum;
}

}  // namespace

std::size_t GridFluid::Scratch::bytes() const {
    return grid.bytes() + bytes_of(at_start) +
           bytes_of(cut.facets, cut.near_faces, cut.nearest[0], cut.nearest[1], cut.nearest[2]);
}

GridFluid::GridFluid(const FluidScene& scene, const Settings& settings, const FluidState& state, Fields& fields,
                     Scratch& scratch)
    : scene_(&scene), settings_(&settings), coupling_(&state.coupling), fields_(&fields), scratch_(&scratch) {
    if (scratch.cutter) {
        return;
    }
    const bool is_new = fields.water.fraction.empty();
    if (is_new) {
        fields.cut_position = state.bodies.position;
        fields.cut_orientation = state.bodies.orientation;
        fields.cut_stretch = state.bodies.stretch;
    }
    scratch.shapes = body_shapes(scene, settings);
    const body::Motion motion = cut_motion(fields);
    place_bodies(scene, settings, scratch.shapes, motion, 0, true, scratch.bodies);
    scratch.cutter.emplace(settings.grid.mesh, scratch.bodies, still_bodies(scene, settings));
    scratch.cut = scratch.cutter->cut(scratch.bodies);
    if (is_new) {
        fields.water = fill_grid(settings, scratch.bodies, scratch.cut.open);
    }
    if (settings.is_carried) {
        scratch.at_start = is_new ? fields.water.fraction : water_at_start(settings);
    }
    if (scene.bodies.size() > 0) {
        set_open_shares(settings.grid, fields.water, scratch.grid, std::move(scratch.cut.open));
    } else {
        prepare(settings.grid, fields.water, scratch.grid);
    }
}

std::span<const Account> GridFluid::accounts() {
    static constexpr std::array list{Account{
        "dissipated", Balance::lost, Booking::across_kick,
        "by viscosity, stones, sponges and the schemes together: what the balance lacks, so that the residual of "
        "the water itself is zero by construction"}};
    return list;
}

StepLimit GridFluid::limit() const {
    StepLimit limit{stable_step(settings_->grid, fields_->water, scratch_->grid), false, "Courant number of the water"};
    const bool has_free = std::any_of(scene_->bodies.drive.begin(), scene_->bodies.drive.end(),
                                      [](body::Drive drive) { return drive == body::Drive::free; });
    // Take whole steps where driven bodies alone close a pocket: what they press out leaves it through all of its
    // cells, with the pressure there, and the pressure that starts a motion at once is the larger the shorter the step.
    if (has_free || scratch_->grid.pockets.empty()) {
        const GridSettings& grid = settings_->grid;
        const double at_rest =
            std::sqrt(grid.courant * grid.mesh.smallest_width() / std::max(norm(grid.gravity), grid.full_gravity));
        limit.at_start = first_share * at_rest + share_of_time * fields_->water.time;
    }
    return limit;
}

Outcome GridFluid::begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                         FluidStep& /*report*/) {
    const GridSettings& settings = settings_->grid;
    GridState& water = fields_->water;
    GridScratch& s = scratch_->grid;
    scratch_->iterations = 0;
    scratch_->before = read_energy(settings, water, s);
    scratch_->momentum_before = momentum_of(settings, water, s);
    if (settings_->is_carried) {
        carry_with_flow(*settings_, water, s, span.dt);
        return {};
    }
    scratch_->before.mass_moment += lag_of(settings, scratch_->momentum_before, water.last_step);
    scratch_->due_before = 0;
    if (scratch_->cutter->moves()) {
        set_velocities(now, 0, scratch_->bodies);
        scratch_->before.mass_moment += moment_of_cut_cells(settings, water, s, scratch_->cut);
        scratch_->due_before =
            work_of_half(settings, water, s, scratch_->bodies, scratch_->cut, water.last_step, water.time);
        place_bodies(*scene_, *settings_, scratch_->shapes, middle, 0.5 * span.dt, false, scratch_->bodies);
        scratch_->cut = scratch_->cutter->cut(scratch_->bodies);
        if (Outcome outcome = leaving_outcome(*scene_, *settings_, *scratch_, *fields_, middle, span.end());
            !outcome.ok()) {
            return outcome;
        }
        set_open_shares(settings, water, s, std::move(scratch_->cut.open));
        note_cut(middle, *fields_);
    }
    scratch_->iterations += begin_step(settings, water, s, span.dt);
    if (settings_->coupling == GridCoupling::two_way) {
        scratch_->feedback = added_mass_shares(*scene_, *settings_, water, scratch_->cut);
        scratch_->pressed = s.pockets.empty() ? std::vector<PressedPocket>{}
                                              : pressed_pockets(*scene_, *settings_, *scratch_, water, span.end());
    }
    return {};
}

void GridFluid::load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) {
    const auto count = at(scene_->bodies.size());
    loads.pressure.clear(count, middle.deforms());
    loads.viscous.clear(count, middle.deforms());
    scratch_->power = 0;
    if (settings_->is_carried) {
        scratch_->loads.assign(count, {});
        return;
    }
    const GridSettings& settings = settings_->grid;
    GridScratch& s = scratch_->grid;
    const bool is_felt = settings_->coupling == GridCoupling::two_way;
    if (is_felt) {
        set_velocities(middle, 0.5 * span.dt, scratch_->bodies);
    }
    if (s.open.has_bodies && is_felt) {
        find_displacement(scratch_->cut.facets, scratch_->bodies, s.open);
    }
    scratch_->solve = project_velocity(settings, fields_->water, s, span.dt);
    scratch_->iterations += scratch_->solve.iterations;
    const auto find_loads = [&] {
        return cut_loads(settings, fields_->water, s, scratch_->bodies, scratch_->cut, fields_->water.time + span.dt);
    };
    scratch_->loads = find_loads();
    if (!scratch_->pressed.empty()) {
        press_pockets(*scene_, *settings_, *coupling_, *scratch_, middle, span, scratch_->loads, fields_->water);
        scratch_->loads = find_loads();
    }
    for (std::size_t b = 0; b < count; ++b) {
        const GridLoad& load = scratch_->loads[b];
        loads.pressure.force[b] = load.pressure;
        loads.pressure.torque[b] = load.torque - load.shear_torque;
        loads.viscous.force[b] = load.shear;
        loads.viscous.torque[b] = load.shear_torque;
        scratch_->power += dot(load.force(), middle.velocity[b]) + dot(load.torque, middle.angular_velocity[b]);
        if (middle.deforms()) {
            loads.viscous.pull[b] = load.shear_pull;
            loads.pressure.pull[b] = load.pull;
            loads.pressure.pull[b] += -1.0 * load.shear_pull;
            scratch_->power += contract(load.pull, scratch_->bodies[b].stretch_rate);
        }
    }
}

Outcome GridFluid::kick(const TimeSpan& span, FluidStep& report) {
    const GridSettings& settings = settings_->grid;
    GridState& water = fields_->water;
    GridScratch& s = scratch_->grid;
    const double sliding = settings_->is_carried ? 0 : power_of_sliding_sides(settings, s) * span.dt;
    const double through = energy_through_sides(settings, water, s, span.dt) + sliding;
    end_step(settings, water, s, span.dt);
    const fluid::grid::Energy& before = scratch_->before;
    fluid::grid::Energy after = read_energy(settings, water, s);
    double due = 0;
    if (scratch_->cutter->moves()) {
        after.mass_moment += moment_of_cut_cells(settings, water, s, scratch_->cut);
        due = work_of_half(settings, water, s, scratch_->bodies, scratch_->cut, span.dt, water.time);
    }
    const Vec3 momentum = momentum_of(settings, water, s);
    after.mass_moment += settings_->is_carried ? Vec3{} : lag_of(settings, momentum, span.dt);
    fluid::FluidBalance& balance = report.balance;
    balance.gravity = fluid::grid::body_force(settings, span.end());
    balance.mass_moment = 0.5 * (before.mass_moment + after.mass_moment);
    balance.kinetic = 0.5 * (before.kinetic + after.kinetic);
    balance.potential = -dot(balance.gravity, balance.mass_moment) - 0.5 * (scratch_->due_before + due);
    const double gained = after.kinetic - before.kinetic - (due - scratch_->due_before) -
                          dot(balance.gravity, after.mass_moment - before.mass_moment);
    balance.work_on_solids = span.dt * scratch_->power;
    // what bodies get of water that does not feel them comes from outside
    balance.work_external = through + (settings_->coupling == GridCoupling::one_way ? balance.work_on_solids : 0);
    if (settings_->is_carried) {  // by what the case does not say
        balance.work_external = gained;
    }
    report.own = {balance.work_external - gained - balance.work_on_solids};
    balance.momentum = momentum;
    balance.impulse = momentum - scratch_->momentum_before;
    balance.mass = settings.water.density * water_volume(settings, water, s);
    balance.max_speed = fastest_water(settings, water, s);
    balance.solver_iterations = scratch_->iterations;
    balance.solver_residual = scratch_->solve.residual;
    if (!std::isfinite(after.kinetic + balance.max_speed)) {
        return {fmt::format("the water has no finite speed any more at t = {:.6g} s", span.end()), 0.5};
    }
    return {};
}

}  // namespace riprap::coupling
