// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/fluid/particle/unsound_particles.hpp"

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

struct Sums {
    double kinetic{0}, viscous{0}, collisions{0}, pressure{0}, external{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{}, mass_moment{};

    template <class By>
    static void join(Sums& a, const Sums& b, const By& by) {
        by.add(a.kinetic, b.kinetic);
        by.add(a.viscous, b.viscous);
        by.add(a.collisions, b.collisions);
        by.add(a.pressure, b.pressure);
        by.add(a.external, b.external);
        by.largest(a.speed_squared, b.speed_squared);
        by.largest(a.acceleration_squared, b.acceleration_squared);
        by.add(a.momentum, b.momentum);
        by.add(a.extra, b.extra);
        by.add(a.mass_moment, b.mass_moment);
    }
};

/// v_(n+1) = u** + dt (pressure + extra force)/m, and the report of all that belongs to particles. Work is that of
/// each force along (v_n + v_(n+1))/2. Energies are the means of those before and after the step: between two kicks
/// they change by half the works of both, to round-off, however hard a particle was hit. (v_n . v_(n+1)/2, the kinetic
/// energy at mid-step of the explicit schemes, is off by |v_(n+1) - v_n|^2/4, and a pressure that is solved for stops
/// water that slaps within one step.)
Sums kick_particles(const MpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
                    const MpsScratch& s, const SparseVectors& extra_force) {
    const double m = settings.particle_mass;
    const Vec3 along = gravity - without_periodic(gravity, settings.domain);
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
        sums.mass_moment = m * (state.position[i] + 0.25 * dt * (after - start));
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
    return parallel::sum(state.blocks(), kick_one);
}

/// Work on walls by pressure, viscosity and collisions [W].
struct WallPower {
    double pressure{0}, viscous{0}, collisions{0};

    template <class By>
    static void join(WallPower& a, const WallPower& b, const By& by) {
        by.add(a.pressure, b.pressure);
        by.add(a.viscous, b.viscous);
        by.add(a.collisions, b.collisions);
    }
};

WallPower power_on_walls(const BoundaryParticles& walls, const MpsScratch& s) {
    const auto one = [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const Vec3 v = walls.velocity[w];
        return WallPower{dot(walls.pressure_force[w] - s.walls.collision_force[w], v), dot(walls.viscous_force[w], v),
                         dot(s.walls.collision_force[w], v)};
    };
    return parallel::sum(walls.size(), one);
}

}  // namespace

FluidTimeStep Mps::limit(const ParticleState& state) const {
    const double squared = parallel::reduce(
        state.blocks(), 0.0, [&](std::int64_t i) { return norm_squared(state.velocity[static_cast<std::size_t>(i)]); },
        [](double a, double b) { return std::max(a, b); });
    const double l = settings_.spacing, none = std::numeric_limits<double>::infinity();
    const double speed = std::max(settings_.expected_speed(), std::sqrt(squared));
    FluidTimeStep step{};
    step.acoustic = speed > 0 ? settings_.courant * l / speed : none;
    step.force = none;
    step.viscous = settings_.kinematic_viscosity > 0 ? 0.125 * l * l / settings_.kinematic_viscosity : none;
    step.limit = std::min(step.acoustic, step.viscous);
    step.reason = step.limit == step.acoustic ? "speed of water" : "viscosity of water";
    return step;
}

void Mps::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                       FluidReport& report) {
    span_ = span;
    solved_ = {};
    problem_.clear();
    remedy_.clear();
    find_lost_particle(settings_, state, span.time, report);
    if (report.problem.empty()) {
        predict(state, walls, in_plane(gravity, settings_.domain), span.dt);
        collide(state, walls, span.dt);
        set_up_pressure(state, walls, span.dt);
    }
}

void Mps::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    const Vec3 pull = in_plane(gravity, settings_.domain);
    const linear::SolveReport solve = solve_pressure(state, walls, pull, span_.dt);
    const int before = solved_.iterations;
    solved_ = solve;
    solved_.iterations += before;
    if (!solve.is_converged()) {
        problem_ = fmt::format(
            "the pressure equation of {} unknowns is not solved at t = {:.6g} s: {} after {} iterations, residual "
            "{:.3g} where {:.3g} is asked for",
            scratch_.equation.particle.size(), span_.time, linear::describe(solve.status), solve.iterations,
            solve.residual, settings_.tolerance);
        remedy_ = remedy_of(solve.status);
    }
    find_wall_loads(walls, pull);
}

void Mps::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
               const SparseVectors& extra_force, FluidReport& report) {
    report.solver_iterations = solved_.iterations;
    report.solver_residual = solved_.residual;
    report.problem = problem_;
    report.remedy = remedy_;
    if (!report.problem.empty()) {
        return;
    }
    const Vec3 pull = in_plane(gravity, settings_.domain);
    const double dt = span.dt;
    find_pressure_forces();
    const Sums sums = kick_particles(settings_, state, pull, dt, scratch_, extra_force);
    const WallPower walls_take = power_on_walls(walls, scratch_);
    report.kinetic = sums.kinetic;
    book_potential(pull, sums.mass_moment, settings_.domain, report);
    report.dissipated_viscous = -sums.viscous - dt * walls_take.viscous;
    report.dissipated_collisions = -sums.collisions - dt * walls_take.collisions;
    report.pressure_loss = -sums.pressure - dt * walls_take.pressure;
    report.work_external = sums.external;
    report.momentum = sums.momentum;
    report.mass = settings_.particle_mass * static_cast<double>(state.size());
    report.impulse = dt * (report.mass * pull + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
    state.max_acceleration = report.max_acceleration;
    book_walls(walls, dt, report);
    find_wild_particle(settings_, state, span.time, report);
}

void Mps::describe_walls(const Vec3& gravity, WaterAtWalls& water) const {
    const MpsScratch& s = scratch_;
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

std::unique_ptr<ParticleScheme> make_scheme(const MpsSettings& settings) { return std::make_unique<Mps>(settings); }

}  // namespace riprap::fluid
