// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/mps/mps_scratch.hpp"
#include "riprap/fluid/mps/prediction.hpp"
#include "riprap/fluid/mps/pressure.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid {
namespace {

/// Tells what to change where the pressure equation is not solved.
const char* remedy_of(linear::SolveStatus status) {
    switch (status) {
        case linear::SolveStatus::too_many_iterations:
            return "more fluid.max_iterations or a larger fluid.tolerance; a smaller fluid.courant and a larger "
                   "fluid.spacing need fewer iterations";
        case linear::SolveStatus::stagnated:
            return "a larger fluid.tolerance";
        default:
            return "a smaller fluid.courant";
    }
}

Vec3 times(const std::array<double, symmetric_numbers>& t, const Vec3& a) {
    return {t[0] * a.x + t[2] * a.y + t[4] * a.z, t[2] * a.x + t[1] * a.y + t[5] * a.z,
            t[4] * a.x + t[5] * a.y + t[3] * a.z};
}

std::array<FieldSink, 3> sinks_of(std::vector<Vec3>& v) {
    return {sink_component(v, 0), sink_component(v, 1), sink_component(v, 2)};
}

/// Sums over the water for the loads of walls that have its mean pressure, and that pressure.
void average_at_walls(const MpsSettings& settings, const BoundaryParticles& walls, const Vec3& gravity,
                      MpsScratchData& s) {
    const auto count = walls.position.size();
    mps::clear(s.at_walls.load_weight, count);
    mps::clear(s.at_walls.load_pressure, count);
    mps::clear(s.at_walls.load_moment, count);
    const auto m = sinks_of(s.at_walls.load_moment), t = sinks_of(s.at_walls.slope), p = sinks_of(s.at_walls.push);
    mps::add_pair_sums(settings, mps::PressureAtWalls{settings.weight()}, {s.around.predicted_walls, {}},
                       {s.around.predicted, {field(s.water.pressure)}},
                       {sink(s.at_walls.load_weight), sink(s.at_walls.load_pressure), m[0], m[1], m[2], t[0], t[1],
                        t[2], p[0], p[1], p[2]},
                       s.lists.walls_fluid);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = s.at_walls.load_weight[w];
        const double head = settings.rest_density * dot(gravity - walls.acceleration[w], s.at_walls.load_moment[w]);
        const double mean = weight > 0 ? (s.at_walls.load_pressure[w] + head) / weight : 0;
        s.walls.pressure[w] = s.walls.follows[w] != 0 ? mean : s.walls.given[w];
    });
}

/// The same for walls that mirror each particle.
void mirror_at_walls(const MpsSettings& settings, std::size_t count, MpsScratchData& s) {
    const auto spread = [&](std::size_t k) {
        return FieldSink{count == 0 ? nullptr : s.at_walls.spread[0].data() + k, symmetric_numbers};
    };
    s.around.ones.assign(s.around.predicted.size(), 1.0);
    const auto t = sinks_of(s.at_walls.slope), p = sinks_of(s.at_walls.push);
    mps::add_pair_sums(
        settings, wcmps::MpsPressureOnWalls{settings.weight()}, {s.around.predicted_walls, {}},
        {s.around.predicted, {field(s.around.ones), field(s.water.pressure)}},
        {t[0], t[1], t[2], p[0], p[1], p[2], spread(0), spread(1), spread(2), spread(3), spread(4), spread(5)},
        s.lists.walls_fluid);
    s.walls.pressure = s.walls.given;
}

/// Reactions of the conservative pressure forces, of viscosity and of collisions on walls, and the pressure there.
void load(const MpsSettings& settings, BoundaryParticles& walls, const Vec3& gravity, MpsScratchData& s) {
    const auto count = walls.position.size();
    mps::clear(s.at_walls.slope, count);
    mps::clear(s.at_walls.push, count);
    mps::clear(s.at_walls.spread, count);
    s.walls.pressure.resize(count);
    if (settings.wall_pressure == MpsWallPressure::averaged) {
        average_at_walls(settings, walls, gravity, s);
    } else {
        mirror_at_walls(settings, count, s);
    }
    const MpsLattice lattice = settings.lattice();
    const double factor = lattice.first_order() * settings.particle_mass / settings.rest_density;
    walls.pressure.resize(count);
    walls.pressure_force.resize(count);
    walls.viscous_force = s.walls.viscous_force;
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double head = dot(gravity - walls.acceleration[w], s.at_walls.moment[w]);
        const double seen = s.at_walls.weight[w] > 0 ? (s.at_walls.pressure[w] + head) / s.at_walls.weight[w] : 0;
        walls.pressure[w] = s.walls.follows[w] == 0 ? s.walls.given[w] : std::max(0.0, seen);
        const double m = s.walls.mirrors[w];
        const Vec3 carried = (1 + m) * s.at_walls.push[w] + s.walls.pressure[w] * s.at_walls.slope[w] +
                             m * times(s.at_walls.spread[w], s.walls.head[w]);
        walls.pressure_force[w] = factor * s.walls.share[w] * carried + s.walls.collision_force[w];
    });
}

struct Sums {
    double kinetic{0}, potential{0}, viscous{0}, collisions{0}, pressure{0}, external{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{};
};

Sums operator+(Sums a, const Sums& b) {
    a.kinetic += b.kinetic;
    a.potential += b.potential;
    a.viscous += b.viscous;
    a.collisions += b.collisions;
    a.pressure += b.pressure;
    a.external += b.external;
    a.speed_squared = std::max(a.speed_squared, b.speed_squared);
    a.acceleration_squared = std::max(a.acceleration_squared, b.acceleration_squared);
    a.momentum += b.momentum;
    a.extra += b.extra;
    return a;
}

/// v_(n+1) = u** + dt (pressure + extra force)/m, and the report of all that belongs to particles. Work is that of
/// each force along (v_n + v_(n+1))/2. Energies are the means of those before and after the step: between two kicks
/// they change by half the works of both, to round-off, however hard a particle was hit. (v_n . v_(n+1)/2, the kinetic
/// energy at mid-step of the explicit schemes, is off by |v_(n+1) - v_n|^2/4, and a pressure that is solved for stops
/// water that slaps within one step.)
Sums kick(const MpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt, const MpsScratchData& s,
          const SparseVectors& extra_force) {
    const double m = settings.particle_mass;
    const Vec3 downward = without_periodic(gravity, settings.domain), along = gravity - downward;
    const auto kick_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 extra = extra_force[i];
        const Vec3 start = s.prediction.start_velocity[i];
        const Vec3 collided = state.velocity[i] - start - dt * (s.prediction.viscous_force[i] / m + gravity);
        state.velocity[i] += (dt / m) * (s.water.pressure_force[i] + extra);
        state.density[i] = density_of(settings, s.water.pressure[i]);
        const Vec3 after = state.velocity[i], middle = 0.5 * (start + after);
        Sums sums;
        sums.kinetic = 0.25 * m * (norm_squared(start) + norm_squared(after));
        sums.potential = -m * dot(downward, state.position[i] + 0.25 * dt * (after - start));
        sums.viscous = dt * dot(s.prediction.viscous_force[i], middle);
        sums.collisions = m * dot(collided, middle);
        sums.pressure = dt * dot(s.water.pressure_force[i], middle);
        sums.external = dt * dot(extra + m * along, middle);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared =
            norm_squared((s.water.pressure_force[i] + s.prediction.viscous_force[i] + extra) / m + gravity);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    };
    return parallel::reduce(state.size(), Sums{}, kick_one, [](const Sums& a, const Sums& b) { return a + b; });
}

/// Work on walls by pressure, viscosity and collisions [W].
struct WallPower {
    double pressure{0}, viscous{0}, collisions{0};
};

WallPower power_on_walls(const BoundaryParticles& walls, const MpsScratchData& s) {
    const auto one = [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const Vec3 v = walls.velocity[w];
        return WallPower{dot(walls.pressure_force[w] - s.walls.collision_force[w], v), dot(walls.viscous_force[w], v),
                         dot(s.walls.collision_force[w], v)};
    };
    return parallel::reduce(walls.size(), WallPower{}, one, [](const WallPower& a, const WallPower& b) {
        return WallPower{a.pressure + b.pressure, a.viscous + b.viscous, a.collisions + b.collisions};
    });
}

}  // namespace

MpsScratch::MpsScratch() : data_(std::make_unique<MpsScratchData>()) {}
MpsScratch::~MpsScratch() = default;
MpsScratch::MpsScratch(MpsScratch&&) noexcept = default;
MpsScratch& MpsScratch::operator=(MpsScratch&&) noexcept = default;
std::size_t MpsScratch::bytes() const { return data_->bytes(); }

FluidTimeStep choose_fluid_time_step(const MpsSettings& settings, const ParticleState& state) {
    const double squared = parallel::reduce(
        state.size(), 0.0, [&](std::int64_t i) { return norm_squared(state.velocity[static_cast<std::size_t>(i)]); },
        [](double a, double b) { return std::max(a, b); });
    const double l = settings.spacing, none = std::numeric_limits<double>::infinity();
    const double speed = std::max(settings.expected_speed(), std::sqrt(squared));
    FluidTimeStep step{};
    step.acoustic = speed > 0 ? settings.courant * l / speed : none;
    step.force = none;
    step.viscous = settings.kinematic_viscosity > 0 ? 0.125 * l * l / settings.kinematic_viscosity : none;
    step.limit = std::min(step.acoustic, step.viscous);
    step.reason = step.limit == step.acoustic ? "speed of water" : "viscosity of water";
    return step;
}

void begin_forces(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  const Vec3& gravity, double dt, double time, MpsScratch& scratch, MpsReport& report) {
    find_lost_particle(settings, state, time, report);
    if (!report.problem.empty()) {
        return;
    }
    MpsScratchData& s = scratch.data();
    mps::predict(settings, state, walls, in_plane(gravity, settings.domain), dt, s);
    mps::collide(settings, state, walls, dt, s);
    mps::set_up_pressure(settings, state, walls, dt, s);
}

void load_walls(const MpsSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report) {
    MpsScratchData& s = scratch.data();
    const Vec3 g = in_plane(gravity, settings.domain);
    const linear::SolveReport solve = mps::solve_pressure(settings, state, walls, g, dt, s);
    const int before = report.solve.iterations;
    report.solve = solve;
    report.solve.iterations += before;
    report.unknowns = static_cast<std::int64_t>(s.equation.particle.size());
    if (!solve.is_converged()) {
        report.problem = fmt::format(
            "the pressure equation of {} unknowns is not solved at t = {:.6g} s: {} after {} iterations, residual "
            "{:.3g} where {:.3g} is asked for",
            s.equation.particle.size(), time, linear::describe(solve.status), solve.iterations, solve.residual,
            settings.tolerance);
        report.remedy = remedy_of(solve.status);
    }
    load(settings, walls, g, s);
}

void kick_fluid(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report, const SparseVectors& extra_force) {
    MpsScratchData& s = scratch.data();
    const Vec3 g = in_plane(gravity, settings.domain);
    mps::find_pressure_forces(settings, s);
    const Sums sums = kick(settings, state, g, dt, s, extra_force);
    const WallPower walls_take = power_on_walls(walls, s);
    report.kinetic = sums.kinetic;
    report.potential = sums.potential;
    report.dissipated_viscous = -sums.viscous - dt * walls_take.viscous;
    report.dissipated_collisions = -sums.collisions - dt * walls_take.collisions;
    report.pressure_loss = -sums.pressure - dt * walls_take.pressure;
    report.work_external = sums.external;
    report.momentum = sums.momentum;
    report.mass = settings.particle_mass * static_cast<double>(state.size());
    report.impulse = dt * (report.mass * g + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
    state.max_acceleration = report.max_acceleration;
    book_walls(walls, dt, report);
    find_wild_particle(settings, state, time, report);
}

void accelerate(const MpsSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report, const SparseVectors& extra_force) {
    begin_forces(settings, state, walls, gravity, dt, time, scratch, report);
    if (report.problem.empty()) {
        load_walls(settings, state, walls, gravity, dt, time, scratch, report);
    }
    if (report.problem.empty()) {
        kick_fluid(settings, state, walls, gravity, dt, time, scratch, report, extra_force);
    }
}

void describe_water_at_walls(const Vec3& gravity, const MpsScratch& scratch, WaterAtWalls& water) {
    const MpsScratchData& s = scratch.data();
    const auto count = s.at_walls.weight.size();
    water.weight.resize(count);
    water.slope.resize(count);
    water.pressure.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        water.weight[w] = s.at_walls.cell_weight * s.at_walls.weight[w];
        water.slope[w] = -s.at_walls.slope_factor * s.at_walls.slope[w];
        water.pressure[w] =
            s.at_walls.weight[w] > 0
                ? std::max(0.0, (s.at_walls.pressure[w] + dot(gravity, s.at_walls.moment[w])) / s.at_walls.weight[w])
                : 0;
    });
}

std::span<const std::uint8_t> surface_particles(const MpsScratch& scratch) { return scratch.data().around.surface; }

}  // namespace riprap::fluid
