// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/wcmps/wcmps_step.hpp"

namespace riprap::fluid {

FluidTimeStep WcmpsFluid::limit(const ParticleState& state) const { return choose_fluid_time_step(*settings_, state); }

void WcmpsFluid::update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                                FluidReport& report) {
    fluid::update_density(*settings_, state, walls, gravity, dt, scratch_, report);
}

void WcmpsFluid::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                              const Vec3& /*gravity*/, FluidReport& report) {
    fluid::begin_forces(*settings_, state, walls, span.time, scratch_, report);
}

void WcmpsFluid::describe_walls(const Vec3& gravity, WaterAtWalls& water) const {
    describe_water_at_walls(gravity, scratch_, water);
}

void WcmpsFluid::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    fluid::load_walls(*settings_, state, walls, gravity, scratch_);
}

void WcmpsFluid::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                      const SparseVectors& extra_force, FluidReport& report) {
    kick_fluid(*settings_, state, walls, gravity, span.dt, span.time, scratch_, report, extra_force);
}

std::unique_ptr<ParticleScheme> make_scheme(const WcmpsSettings& settings) {
    return std::make_unique<WcmpsFluid>(settings);
}

}  // namespace riprap::fluid
