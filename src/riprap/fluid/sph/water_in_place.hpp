// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"
#include "riprap/fluid/particle/sweep/sweep_lists.hpp"

namespace riprap::fluid {

/// Where a scheme of SPH finds the particles that its loops run over: in the State itself, on the host. A scheme takes
/// them before it reads, asks for their columns, and gives back what it has changed; the other place is a copy of them
/// (device/water_copy.hpp).
class WaterInPlace {
 public:
    using Where = parallel::Host;

    /// Takes all that the update of density reads.
    void take(const SweepReach& reach, const ParticleState& state, const BoundaryParticles& walls) {
        lists_.place(reach, state.blocks(), state.position, walls.position);
    }
    /// Takes places again, and all of walls but accelerations.
    void take_for_forces(const SweepReach& reach, const ParticleState& state, const BoundaryParticles& walls) {
        lists_.place(reach, state.blocks(), state.position, walls.position);
    }
    /// Takes how walls move and accelerate.
    void take_motion(const BoundaryParticles& /*walls*/) {}

    void give_density(ParticleState& /*state*/) const {}
    void give_motion(ParticleState& /*state*/) const {}
    void give_loads(BoundaryParticles& /*walls*/) const {}

    ParticleColumns water(const ParticleState& state) { return columns_of(state); }
    WallColumns walls(const BoundaryParticles& walls) { return columns_of(walls); }
    WallColumns walls_to_load(BoundaryParticles& walls) { return columns_of(walls); }
    SweepLists& lists() { return lists_; }

    /// Extra forces by the number of a particle, as a functor holds them.
    struct Extra {
        const SparseVectors* force;
        Vec3 operator[](std::size_t i) const { return (*force)[i]; }
    };
    Extra extra(const SparseVectors& force, std::size_t /*count*/) { return {&force}; }

    std::size_t bytes() const { return lists_.bytes(); }

 private:
    SweepLists lists_;
};

}  // namespace riprap::fluid
