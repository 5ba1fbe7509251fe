// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/wcmps_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/wcmps/continuity.hpp"
#include "riprap/fluid/wcmps/forces.hpp"
#include "riprap/fluid/wcmps/surface.hpp"

namespace riprap::fluid {

using wcmps::resistance_to_sound;

namespace {

struct Sums {
    double kinetic{0}, potential{0}, internal{0}, heat{0}, exchange{0}, earlier_exchange{0}, external{0}, collisions{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{};
};

Sums operator+(Sums a, const Sums& b) {
    a.kinetic += b.kinetic;
    a.potential += b.potential;
    a.internal += b.internal;
    a.heat += b.heat;
    a.exchange += b.exchange;
    a.earlier_exchange += b.earlier_exchange;
    a.external += b.external;
    a.collisions += b.collisions;
    a.speed_squared = std::max(a.speed_squared, b.speed_squared);
    a.acceleration_squared = std::max(a.acceleration_squared, b.acceleration_squared);
    a.momentum += b.momentum;
    a.extra += b.extra;
    return a;
}

/// v += collision + dt (force + extra force)/m + dt g, and the report of all that belongs to particles. With v' after
/// the collision c, kinetic energy is m/2 v' v_(n+1): before the kick a collision takes m (v c + c^2/2) and half of
/// what the step's acceleration gives to c, as places and densities never saw it. Forces work along v before the kick
/// and along v_(n+1) after it.
void kick(const WcmpsSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
          const WcmpsScratchData& s, bool collides, const SparseVectors& extra_force, WcmpsReport& report) {
    const double m = settings.particle_mass, resistance = m / settings.rest_density * resistance_to_sound(settings);
    const double divergence = -settings.lattice().first_order();
    const Vec3 downward = without_periodic(gravity, settings.domain), along = gravity - downward;
    const auto kick_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 extra = extra_force[i];
        const Vec3 acceleration = (s.forces.force[i] + extra) / m + gravity;
        const Vec3 collision = collides ? s.collisions.change[i] : Vec3{};
        const Vec3 before = state.velocity[i], after = before + collision + dt * acceleration;
        state.velocity[i] = after;
        Sums sums;
        sums.kinetic = 0.5 * m * dot(before + collision, after);
        sums.collisions = -0.5 * m * dot(collision, 2.0 * before + collision + dt * acceleration);
        sums.potential = -m * dot(downward, state.position[i]);
        sums.internal = m * internal_energy_of(settings, s.water.concentration[i]);
        // of damped sound along the mean velocity of the kick: half now, half at the next update of density
        const double squeezed = divergence * s.continuity.rate[i] / s.water.concentration[i] - s.continuity.slip[i];
        state.dilution[i] = 0.5 * dt * s.continuity.damped[i];
        sums.heat = s.forces.heat[i] + 0.5 * resistance * s.continuity.damped[i] * squeezed;
        sums.exchange = dot(s.forces.wall_hold[i], after) - s.forces.wall_hold_power[i];
        sums.earlier_exchange = 0.5 * dot(s.forces.wall_hold[i], before - after);
        sums.external = 0.5 * dot(extra + m * along, before + after);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared = norm_squared(acceleration);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    };
    const Sums sums =
        parallel::reduce(state.owned(), Sums{}, kick_one, [](const Sums& a, const Sums& b) { return a + b; });
    report.kinetic = sums.kinetic;
    report.potential = sums.potential;
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

}  // namespace

WcmpsScratch::WcmpsScratch() : data_(std::make_unique<WcmpsScratchData>()) {}
WcmpsScratch::~WcmpsScratch() = default;
WcmpsScratch::WcmpsScratch(WcmpsScratch&&) noexcept = default;
WcmpsScratch& WcmpsScratch::operator=(WcmpsScratch&&) noexcept = default;
std::size_t WcmpsScratch::bytes() const { return data_->bytes(); }

FluidTimeStep choose_fluid_time_step(const WcmpsSettings& settings, const ParticleState& state) {
    struct Fastest {
        double speed_squared{0}, density{0};
    };
    const Fastest fastest = parallel::reduce(
        state.owned(), Fastest{0, settings.rest_density},
        [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            return Fastest{norm_squared(state.velocity[i]), state.density[i]};
        },
        [](const Fastest& a, const Fastest& b) {
            return Fastest{std::max(a.speed_squared, b.speed_squared), std::max(a.density, b.density)};
        });
    const double l = settings.spacing, none = std::numeric_limits<double>::infinity();
    const double stiffening =
        std::pow(fastest.density / settings.rest_density, (settings.tait_exponent - 1) / 2);  // c/c_0
    FluidTimeStep step{};
    step.acoustic = settings.courant * l / (settings.sound_speed * stiffening + std::sqrt(fastest.speed_squared));
    step.force = state.max_acceleration > 0 ? 0.25 * std::sqrt(l / state.max_acceleration) : none;
    step.viscous = settings.kinematic_viscosity > 0 ? 0.125 * l * l / settings.kinematic_viscosity : none;
    step.limit = std::min({step.acoustic, step.force, step.viscous});
    step.reason = step.limit == step.acoustic ? "sound in water"
                  : step.limit == step.force  ? "acceleration of water"
                                              : "viscosity of water";
    return step;
}

void update_density(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, WcmpsScratch& scratch, FluidReport& report) {
    wcmps::update_density(settings, state, walls, in_plane(gravity, settings.domain), dt, scratch.data(), report);
}

void begin_forces(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, double time,
                  WcmpsScratch& scratch, FluidReport& report) {
    find_lost_particle(settings, state, time, report);
    if (report.problem.empty()) {
        wcmps::begin_forces(settings, state, walls, scratch.data());
    }
}

void describe_water_at_walls(const Vec3& gravity, const WcmpsScratch& scratch, WaterAtWalls& water) {
    const WcmpsScratchData& s = scratch.data();
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

void load_walls(const WcmpsSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                const Vec3& gravity, WcmpsScratch& scratch) {
    wcmps::load_walls(settings, state, walls, in_plane(gravity, settings.domain), scratch.data());
}

void kick_fluid(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                const Vec3& gravity, double dt, double time, WcmpsScratch& scratch, WcmpsReport& report,
                const SparseVectors& extra_force) {
    WcmpsScratchData& s = scratch.data();
    const Vec3 g = in_plane(gravity, settings.domain);
    wcmps::add_walls(settings, state, walls, s);
    wcmps::classify(settings, state, s);
    const bool collides = wcmps::find_collisions(settings, state, s);
    const wcmps::Shifting shifting = wcmps::shift(settings, state, without_periodic(g, settings.domain), dt, s);
    report.shifted += shifting.potential;
    report.max_shift = std::sqrt(shifting.longest_squared);
    kick(settings, state, g, dt, s, collides, extra_force, report);
    book_walls(walls, dt, report);
    find_wild_particle(settings, state, time, report);
}

void accelerate(const WcmpsSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, WcmpsScratch& scratch, WcmpsReport& report, const SparseVectors& extra_force) {
    begin_forces(settings, state, walls, time, scratch, report);
    if (report.problem.empty()) {
        load_walls(settings, state, walls, gravity, scratch);
        kick_fluid(settings, state, walls, gravity, dt, time, scratch, report, extra_force);
    }
}

std::span<const SurfaceClass> surface_classes(const WcmpsScratch& scratch) { return scratch.data().surface.classes; }

}  // namespace riprap::fluid
