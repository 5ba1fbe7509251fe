// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/fluid/sph/delta_sph.hpp"
#include "riprap/fluid/sph/sound_loops.hpp"
#include "riprap/fluid/sph/sound_sums.hpp"

namespace riprap::fluid {

/// delta_sph with two clocks [Zhang2020]: a flow step of n sound steps tau has one geometry, whose neighbours, weights
/// and corrections are those of
///
///     x^g = x + T/2 v,    T = n tau,    n = min(sound_steps, 0.25 h/(v_max tau), T_viscous/tau),
///
/// at the beginning of the flow step. Sound steps sum 2 numbers of density and 3 of force over pairs of x^g; places
/// move by the velocities of all of them. Viscosity and shifting belong to the flow step (docs/theory/sph.md, 12).
/// Where n is 1, and where walls move, a step is that of DeltaSph to the bit.
///
/// Differs from the source: density is never set anew, and the loads of walls follow the sound.
class TwoClocks : public DeltaSph<WaterInPlace> {
    using Base = DeltaSph<WaterInPlace>;

 public:
    using Base::Base;

    double renew(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                 bool are_walls_still, double& since, ParticleReport& report) override;
    bool has_two_clocks() const override { return true; }
    void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        ParticleReport& report) override;
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      ParticleReport& report) override;
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, ParticleReport& report) override;
    std::size_t bytes() const override;

 private:
    /// Update of density within a flow step.
    enum class Update {
        first,   ///< with the sums of its geometry
        within,  ///< by sums of its own
        closing  ///< of half a step, on a geometry that ends; another follows on the next one
    };
    static std::uint64_t stamp_of(const FlowClock& flow);
    static void begin_flow_step(ParticleState& state, std::int64_t steps, double dt);
    /// Carries the density on a geometry, which is found where it is not at hand.
    void advance(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt, bool is_closing,
                 ParticleReport& report);
    /// Carries it by the rates and the diffusion that were summed.
    void carry_density(ParticleState& state, NumbersView<1> diffusion, double dt, Update update,
                       ParticleReport& report);
    /// The sound steps that a flow step from this State may have.
    std::int64_t sound_steps(const ParticleState& state, double dt) const;
    /// The particles in their geometry, with the velocities of now.
    ParticleColumns in_geometry(const ParticleState& state) const;
    void place(const ParticleState& state, const BoundaryParticles& walls);
    /// Finds all that lasts as long as the geometry, from the FlowClock alone. Its sums are those of the first sound
    /// step too: that one carries the density by them, for dt > 0.
    void find_geometry(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                       ParticleReport& report);
    void find_slow_forces(const ParticleColumns& start, const BoundaryParticles& walls, const Vec3& gravity);
    void shift_flow(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                    ParticleReport& report);
    void find_concentration(const parallel::Blocks& blocks, const BoundaryParticles& walls,
                            const std::vector<Vec3>& places);
    void finish_kick_in_flow(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                             const TimeSpan& span, const SparseVectors& extra_force, ParticleReport& report);
    Surroundings around() const;

    // Keeps what lasts as long as a geometry; the rest of it is in the buffers of the base.
    Numbers<1> leaves_wall_, caught_, rate_;
    Numbers<3> wall_slope_, slow_force_;
    std::vector<Vec3> viscous_on_walls_;  ///< [N]
    std::vector<double> no_pressure_;     ///< at walls
    std::vector<Vec3> no_force_;          ///< likewise, room
    std::vector<Vec3> shifted_;           ///< places of the geometry while it is shifted [m]
    std::uint64_t known_{0};              ///< stamp of the geometry that the buffers are of; 0: none
};

}  // namespace riprap::fluid
