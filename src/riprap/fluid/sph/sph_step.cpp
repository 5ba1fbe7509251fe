// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/sph_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/schemes.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"

namespace riprap::fluid {
namespace {

Vec3 in_plane(const Vec3& a, const Domain& domain) { return domain.dimension == 2 ? Vec3{a.x, a.y, 0} : a; }

const Scheme& scheme_of(const SphSettings& settings) {
    return settings.scheme == SphScheme::muller ? muller_scheme : delta_sph_scheme;
}

}  // namespace

SphScratch::SphScratch() : data_(std::make_unique<SphScratchData>()) {}
SphScratch::~SphScratch() = default;
SphScratch::SphScratch(SphScratch&&) noexcept = default;
SphScratch& SphScratch::operator=(SphScratch&&) noexcept = default;
std::size_t SphScratch::bytes() const { return data_->bytes(); }

FluidTimeStep choose_fluid_time_step(const SphSettings& settings, const ParticleState& state) {
    struct Fastest {
        double speed_squared{0}, density{0};
    };
    const auto one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        return Fastest{norm_squared(state.velocity[i]), state.density[i]};
    };
    const Fastest fastest =
        parallel::reduce(state.owned(), Fastest{0, settings.rest_density}, one, [](const Fastest& a, const Fastest& b) {
            return Fastest{std::max(a.speed_squared, b.speed_squared), std::max(a.density, b.density)};
        });
    const double h = settings.smoothing_length(), none = std::numeric_limits<double>::infinity();
    const double nu = settings.viscosity.visit([&](const auto& law) { return law.kinematic(settings, 0); });
    FluidTimeStep step{};
    step.acoustic =
        settings.courant * h / (sound_speed_of(settings, fastest.density) + std::sqrt(fastest.speed_squared));
    step.force = state.max_acceleration > 0 ? 0.25 * std::sqrt(h / state.max_acceleration) : none;
    step.viscous = nu > 0 ? 0.125 * h * h / nu : none;
    step.limit = std::min({step.acoustic, step.force, step.viscous});
    step.reason = step.limit == step.acoustic ? "sound in water"
                  : step.limit == step.force  ? "acceleration of water"
                                              : "viscosity of water";
    return step;
}

void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratch& scratch, FluidReport& report) {
    if (const auto update = scheme_of(settings).update_density; update != nullptr) {
        update(settings, state, walls, in_plane(gravity, settings.domain), dt, scratch.data(), report);
    }
}

void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, double time,
                  SphScratch& scratch, FluidReport& report) {
    find_lost_particle(settings, state, time, report);
    if (report.problem.empty()) {
        scheme_of(settings).begin_forces(settings, state, walls, scratch.data());
    }
}

void describe_water_at_walls(const Vec3& gravity, const SphScratch& scratch, WaterAtWalls& water) {
    const SphScratchData& s = scratch.data();
    water.weight.resize(s.at_walls.weight.size());
    water.slope.resize(s.at_walls.slope.size());
    water.pressure.resize(water.weight.size());
    parallel::for_each(static_cast<std::int64_t>(water.weight.size()), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        water.weight[w] = s.at_walls.weight[w];
        water.slope[w] = s.at_walls.slope.vector(w);
        water.pressure[w] =
            water.weight[w] > 0
                ? std::max(0.0, (s.at_walls.pressure[w] + dot(gravity, s.at_walls.moment.vector(w))) / water.weight[w])
                : 0;
    });
}

void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratch& scratch) {
    scheme_of(settings).load_walls(settings, state, walls, in_plane(gravity, settings.domain), scratch.data());
}

void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report, const SparseVectors& extra_force) {
    scheme_of(settings).kick_fluid(settings, state, walls, in_plane(gravity, settings.domain), dt, scratch.data(),
                                   report, extra_force);
    find_wild_particle(settings, state, time, report);
}

void accelerate(const SphSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report, const SparseVectors& extra_force) {
    begin_forces(settings, state, walls, time, scratch, report);
    if (report.problem.empty()) {
        load_walls(settings, state, walls, gravity, scratch);
        kick_fluid(settings, state, walls, gravity, dt, time, scratch, report, extra_force);
    }
}

FluidTimeStep SphFluid::limit(const ParticleState& state) const { return choose_fluid_time_step(*settings_, state); }

void SphFluid::update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                              FluidReport& report) {
    fluid::update_density(*settings_, state, walls, gravity, dt, scratch_, report);
}

void SphFluid::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                            const Vec3& /*gravity*/, FluidReport& report) {
    fluid::begin_forces(*settings_, state, walls, span.time, scratch_, report);
}

void SphFluid::describe_walls(const Vec3& gravity, WaterAtWalls& water) const {
    describe_water_at_walls(gravity, scratch_, water);
}

void SphFluid::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    fluid::load_walls(*settings_, state, walls, gravity, scratch_);
}

void SphFluid::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                    const SparseVectors& extra_force, FluidReport& report) {
    kick_fluid(*settings_, state, walls, gravity, span.dt, span.time, scratch_, report, extra_force);
}

std::unique_ptr<ParticleScheme> make_scheme(const SphSettings& settings) {
    return std::make_unique<SphFluid>(settings);
}

}  // namespace riprap::fluid
