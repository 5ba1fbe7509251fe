// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/wcmps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/fluid/particle/unsound_particles.hpp"

namespace riprap::fluid {
namespace {

struct Sums {
    double kinetic{0}, internal{0}, heat{0}, exchange{0}, earlier_exchange{0}, external{0}, collisions{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{}, mass_moment{};

    template <class By>
    static void join(Sums& a, const Sums& b, const By& by) {
        by.add(a.kinetic, b.kinetic);
        by.add(a.internal, b.internal);
        by.add(a.heat, b.heat);
        by.add(a.exchange, b.exchange);
        by.add(a.earlier_exchange, b.earlier_exchange);
        by.add(a.external, b.external);
        by.add(a.collisions, b.collisions);
        by.largest(a.speed_squared, b.speed_squared);
        by.largest(a.acceleration_squared, b.acceleration_squared);
        by.add(a.momentum, b.momentum);
        by.add(a.extra, b.extra);
        by.add(a.mass_moment, b.mass_moment);
    }
};

}  // namespace

FluidTimeStep Wcmps::limit(const ParticleState& state) const {
    struct Fastest {
        double speed_squared{0}, density{0};
    };
    const Fastest fastest = parallel::reduce(
        state.blocks(), Fastest{0, settings_.rest_density},
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            return Fastest{norm_squared(state.velocity[i]), state.density[i]};
        },
        [](const Fastest& a, const Fastest& b) {
            return Fastest{std::max(a.speed_squared, b.speed_squared), std::max(a.density, b.density)};
        });
    const double l = settings_.spacing, none = std::numeric_limits<double>::infinity();
    const double stiffening =
        std::pow(fastest.density / settings_.rest_density, (settings_.tait_exponent - 1) / 2);  // c/c_0
    FluidTimeStep step{};
    step.acoustic = settings_.courant * l / (settings_.sound_speed * stiffening + std::sqrt(fastest.speed_squared));
    step.force = state.max_acceleration > 0 ? 0.25 * std::sqrt(l / state.max_acceleration) : none;
    step.viscous = settings_.kinematic_viscosity > 0 ? 0.125 * l * l / settings_.kinematic_viscosity : none;
    step.limit = std::min({step.acoustic, step.force, step.viscous});
    step.reason = step.limit == step.acoustic ? "sound in water"
                  : step.limit == step.force  ? "acceleration of water"
                                              : "viscosity of water";
    return step;
}

// With v' after the collision c, kinetic energy is m/2 v' v_(n+1): before the kick a collision takes m (v c + c^2/2)
// and half of what the step's acceleration gives to c, as places and densities never saw it. Forces work along v before
// the kick and along v_(n+1) after it.
void Wcmps::kick_particles(ParticleState& state, const Vec3& gravity, double dt, bool collides,
                           const SparseVectors& extra_force, ParticleReport& report) const {
    const double m = settings_.particle_mass, resistance = m / settings_.rest_density * resistance_to_sound();
    const double divergence = -lattice_.first_order(), factor = force_factor();
    const Vec3 along = gravity - without_periodic(gravity, settings_.domain);
    const auto kick_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 extra = extra_force[i];
        const Vec3 acceleration = (factor * forces_.force.vector(i) + extra) / m + gravity;
        const Vec3 collision = collides ? collisions_.change[i] : Vec3{};
        const Vec3 before = state.velocity[i], after = before + collision + dt * acceleration;
        state.velocity[i] = after;
        Sums sums;
        sums.kinetic = 0.5 * m * dot(before + collision, after);
        sums.collisions = -0.5 * m * dot(collision, 2.0 * before + collision + dt * acceleration);
        sums.mass_moment = m * state.position[i];
        sums.internal = m * internal_energy_of(settings_, water_.concentration[i]);
        // of damped sound along the mean velocity of the kick: half now, half at the next update of density
        const double squeezed = divergence * continuity_.rate[i] / water_.concentration[i] - continuity_.slip[i];
        state.dilution[i] = 0.5 * dt * continuity_.damped[i];
        const double heat = factor * (0.5 * forces_.heat[i] + forces_.wall_heat[i]);
        const Vec3 hold = factor * forces_.wall_hold.vector(i);
        sums.heat = heat + 0.5 * resistance * continuity_.damped[i] * squeezed;
        sums.exchange = dot(hold, after) - factor * forces_.wall_hold_power[i];
        sums.earlier_exchange = 0.5 * dot(hold, before - after);
        sums.external = 0.5 * dot(extra + m * along, before + after);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared = norm_squared(acceleration);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    };
    const Sums sums = parallel::sum(state.blocks(), kick_one);
    report.kinetic = sums.kinetic;
    book_potential(gravity, sums.mass_moment, settings_.domain, report);
    report.internal = sums.internal;
    report.dissipated_viscous = dt * sums.heat;
    report.wall_exchange = dt * sums.exchange;
    report.earlier_exchange += dt * sums.earlier_exchange;
    report.earlier_collisions = sums.collisions;
    report.work_external = dt * sums.external;
    report.momentum = sums.momentum;
    report.mass = m * static_cast<double>(state.size());
    report.impulse = dt * (report.mass * gravity + sums.extra);
    report.max_speed = std::sqrt(sums.speed_squared);
    report.max_acceleration = std::sqrt(sums.acceleration_squared);
    state.max_acceleration = report.max_acceleration;
}

void Wcmps::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                 const SparseVectors& extra_force, ParticleReport& report) {
    const Vec3 pull = in_plane(gravity, settings_.domain);
    add_walls(state, walls);
    classify(state);
    const bool collides = find_collisions(state);
    shift(state, without_periodic(pull, settings_.domain), span.dt, report);
    report.by_density.diffusion += flow_.beyond(flow_time_, span.dt);
    kick_particles(state, pull, span.dt, collides, extra_force, report);
    book_walls(walls, span.dt, report);
    find_wild_particle(settings_, state, span.time, report);
}

void Wcmps::describe_walls(const Vec3& gravity, WaterAtWalls& water) const {
    const auto count = at_walls_.weight.size();
    water.weight.resize(count);
    water.slope.resize(count);
    water.pressure.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        water.weight[w] = at_walls_.cell_weight * at_walls_.weight[w];
        water.slope[w] = -at_walls_.slope_factor * at_walls_.slope[w];
        water.pressure[w] =
            at_walls_.weight[w] > 0
                ? std::max(0.0, (at_walls_.pressure[w] + dot(gravity, at_walls_.moment[w])) / at_walls_.weight[w])
                : 0;
    });
}

std::size_t Wcmps::bytes() const {
    return water_.bytes() + continuity_.bytes() + stage_.bytes() + surface_.bytes() + collisions_.bytes() +
           walls_.bytes() + at_walls_.bytes() + lists_.bytes();
}

std::unique_ptr<ParticleScheme> make_scheme(const WcmpsSettings& settings) { return std::make_unique<Wcmps>(settings); }

}  // namespace riprap::fluid
