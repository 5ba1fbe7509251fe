// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_step.hpp"

namespace riprap::fluid {

FluidTimeStep MpsFluid::limit(const ParticleState& state) const { return choose_fluid_time_step(*settings_, state); }

void MpsFluid::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                            const Vec3& gravity, FluidReport& report) {
    span_ = span;
    solved_ = {};
    fluid::begin_forces(*settings_, state, walls, gravity, span.dt, span.time, scratch_, solved_);
    report.worst_particle = solved_.worst_particle;
    report.problem = solved_.problem;
}

void MpsFluid::describe_walls(const Vec3& gravity, WaterAtWalls& water) const {
    describe_water_at_walls(gravity, scratch_, water);
}

void MpsFluid::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    fluid::load_walls(*settings_, state, walls, gravity, span_.dt, span_.time, scratch_, solved_);
}

void MpsFluid::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                    std::span<const Vec3> extra_force, FluidReport& report) {
    if (solved_.problem.empty()) {
        kick_fluid(*settings_, state, walls, gravity, span.dt, span.time, scratch_, solved_, extra_force);
    }
    report = solved_;
    report.solver_iterations = solved_.solve.iterations;
    report.solver_residual = solved_.solve.residual;
}

std::unique_ptr<ParticleScheme> make_scheme(const MpsSettings& settings) {
    return std::make_unique<MpsFluid>(settings);
}

}  // namespace riprap::fluid
