// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/sph/muller_kernels.hpp"
#include "riprap/fluid/sph/sph_forces.hpp"
#include "riprap/fluid/sph/water_in_place.hpp"

namespace riprap::fluid {

/// Density summed over neighbours, p = c_0^2 (rho - rho_0) where positive, forces with the spiky kernel [Muller2003] as
/// corrected in docs/theory/sph.md, 9. With the drifts before and after, it is the symplectic Euler step of the source.
/// Density and forces come from different kernels, so no energy belongs to the forces: the ledger's residual is theirs.
class Muller final : public SphForces<SpikyKernel, WaterInPlace> {
 public:
    explicit Muller(const SphSettings& settings)
        : SphForces(settings, SpikyKernel(settings.support_radius(), settings.domain.dimension)) {}

    /// Density is summed with the forces.
    void update_density(ParticleState&, const BoundaryParticles&, const Vec3&, double, ParticleReport&) override {}
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      ParticleReport& report) override;
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, ParticleReport& report) override;
    std::size_t bytes() const override { return SphForces::bytes() + mass_.bytes() + wall_mass_.bytes(); }

 private:
    void sum_density(ParticleState& state, const BoundaryParticles& walls);

    Numbers<1> mass_, wall_mass_;  ///< as they enter the sum of density [kg]
};

}  // namespace riprap::fluid
