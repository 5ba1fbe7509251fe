// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/cell_sweep.hpp"
#include "riprap/fluid/sph/device/device_columns.hpp"

namespace riprap::fluid {

template <class Where, PairPhysics Pair>
void add_pair_sums(const ParticleSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, CellPairs<Where>& pairs) {
    cell_sweep(pair, reach_of(settings), targets, candidates, sums, pairs);
}
template <class Where, MutualPhysics Pair>
void add_pair_sums_within(const ParticleSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          CellPairs<Where>& pairs) {
    add_pair_sums(settings, pair, particles, particles, sums, pairs);
}

/// Particles for the loops of a step in memory of `Memory`, see WaterInPlace, and the cells that its sums go by. The
/// State stays with the host, which may change all of it before update_density, places of particles and all of walls
/// before begin_forces, and how walls move before each load_walls: that is what is taken.
template <class Memory>
class WaterCopy {
 public:
    using Where = Memory;

    void take(const SweepReach& reach, const ParticleState& state, const BoundaryParticles& walls) {
        water_.take(state);
        walls_.take(walls);
        place(reach, state, walls);
    }
    void take_for_forces(const SweepReach& reach, const ParticleState& state, const BoundaryParticles& walls) {
        water_.take_places(state);
        walls_.take_for_forces(walls);
        place(reach, state, walls);
    }
    void take_motion(const BoundaryParticles& walls) { walls_.take_motion(walls); }

    void give_density(ParticleState& state) const { water_.give_density(state); }
    void give_motion(ParticleState& state) const { water_.give_motion(state); }
    void give_loads(BoundaryParticles& walls) const { walls_.give_loads(walls); }

    ParticleColumns water(const ParticleState& /*state*/) { return water_.columns(); }
    WallColumns walls(const BoundaryParticles& /*walls*/) { return walls_.columns(); }
    WallColumns walls_to_load(BoundaryParticles& /*walls*/) { return walls_.columns(); }
    CellLists<Where>& lists() { return lists_; }
    SparseColumns extra(const SparseVectors& force, std::size_t count) { return extra_.take(force, count); }

    std::size_t bytes() const { return water_.bytes() + walls_.bytes() + extra_.bytes() + lists_.bytes(); }

 private:
    void place(const SweepReach& reach, const ParticleState& state, const BoundaryParticles& walls) {
        lists_.place(reach, box_of(state.position), water_.columns().positions(), box_of(walls.position),
                     walls_.columns().positions());
    }

    WaterThere<Where> water_;
    WallsThere<Where> walls_;
    SparseThere<Where> extra_;
    CellLists<Where> lists_;
};

}  // namespace riprap::fluid
