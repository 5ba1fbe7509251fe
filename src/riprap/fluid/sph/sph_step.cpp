// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/sph_step.hpp"

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/schemes.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid {
namespace {

const Scheme& scheme_of(const SphSettings& settings) {
    return settings.scheme == SphScheme::muller ? muller_scheme : delta_sph_scheme;
}

}  // namespace

SphScratch::SphScratch() : data_(std::make_unique<SphScratchData>()) {}
SphScratch::~SphScratch() = default;
SphScratch::SphScratch(SphScratch&&) noexcept = default;
SphScratch& SphScratch::operator=(SphScratch&&) noexcept = default;
std::size_t SphScratch::bytes() const { return data_->bytes(); }

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
    const WaterAtWallSumsIn<parallel::Host>& sums = scratch.data().at_walls;
    const PressureAtWall at_wall = pressure_at_wall(sums);
    water.weight.resize(sums.weight.size());
    water.slope.resize(sums.slope.size());
    water.pressure.resize(water.weight.size());
    parallel::for_each(static_cast<std::int64_t>(water.weight.size()), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        water.weight[w] = sums.weight[w];
        water.slope[w] = sums.slope.vector(w);
        water.pressure[w] = at_wall(w, gravity);
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
    if (settings.is_on_device()) {
        return make_device_scheme(settings);
    }
    return std::make_unique<SphFluid>(settings);
}

}  // namespace riprap::fluid
