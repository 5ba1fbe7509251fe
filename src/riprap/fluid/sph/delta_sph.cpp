// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/delta_sph.hpp"

#include "riprap/fluid/sph/schemes.hpp"

namespace riprap::fluid {
namespace {

void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratchData& s, FluidReport& report) {
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    delta_sph::update_density(settings, columns_of(state), columns_of(walls), gravity, dt, s, report);
}

void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& s) {
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    delta_sph::begin_forces(settings, columns_of(state), columns_of(walls), s);
}

void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratchData& s) {
    delta_sph::load_walls(settings, columns_of(state), columns_of(walls), gravity, s);
}

void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& s, FluidReport& report, const SparseVectors& extra_force) {
    delta_sph::finish_forces(settings, columns_of(state), columns_of(walls), gravity, dt, s, report);
    kick(settings, state, gravity, dt, s, extra_force, report);
    book_walls(walls, dt, report);
}

}  // namespace

const Scheme delta_sph_scheme{update_density, begin_forces, load_walls, kick_fluid};

}  // namespace riprap::fluid
