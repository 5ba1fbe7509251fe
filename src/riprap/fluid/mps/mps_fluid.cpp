// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/bodies_in_pressure.hpp"
#include "riprap/fluid/mps/mps_scratch.hpp"
#include "riprap/fluid/mps/mps_step.hpp"

namespace riprap::fluid {

namespace {

/// Semi-implicit MPS as a scheme of a particle fluid.
class Mps final : public ParticleScheme, public SolvesForBodies {
 public:
    explicit Mps(const MpsSettings& settings) : settings_(&settings) {}

    FluidTimeStep limit(const ParticleState& state) const override { return choose_fluid_time_step(*settings_, state); }
    void update_density(ParticleState&, const BoundaryParticles&, const Vec3&, double, FluidReport&) override {}
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      FluidReport& report) override {
        span_ = span;
        solved_ = {};
        fluid::begin_forces(*settings_, state, walls, gravity, span.dt, span.time, scratch_, solved_);
        report.worst_particle = solved_.worst_particle;
        report.problem = solved_.problem;
        report.remedy = solved_.remedy;
    }
    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override {
        describe_water_at_walls(gravity, scratch_, water);
    }
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override {
        fluid::load_walls(*settings_, state, walls, gravity, span_.dt, span_.time, scratch_, solved_);
    }
    SolvesForBodies* for_bodies() override { return this; }
    bool correct(const LooseBodies& bodies, std::span<const Twist> residual, std::span<Twist> change) override {
        return mps::correct_bodies(*settings_, bodies, residual, scratch_.data(), change);
    }
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, FluidReport& report) override {
        if (solved_.problem.empty()) {
            kick_fluid(*settings_, state, walls, gravity, span.dt, span.time, scratch_, solved_, extra_force);
        }
        report = solved_;
        report.solver_iterations = solved_.solve.iterations;
        report.solver_residual = solved_.solve.residual;
    }
    std::size_t bytes() const override { return scratch_.bytes(); }

 private:
    const MpsSettings* settings_;
    MpsScratch scratch_;
    TimeSpan span_{0, 0};  ///< of the step begun
    MpsReport solved_;     ///< by the loads of it
};

}  // namespace

std::unique_ptr<ParticleScheme> make_scheme(const MpsSettings& settings) { return std::make_unique<Mps>(settings); }

}  // namespace riprap::fluid
