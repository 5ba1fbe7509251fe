// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"

namespace riprap::fluid {

/// Particles of a fluid in memory of `Where`: a copy for the loops of one step.
template <class Where>
class WaterThere {
 public:
    void take_places(const ParticleState& state) { Where::template upload<Vec3>(state.position, position_); }
    void take(const ParticleState& state) {
        take_places(state);
        Where::template upload<Vec3>(state.velocity, velocity_);
        Where::template upload<double>(state.density, density_);
        Where::template upload<double>(state.dilution, dilution_);
        Where::template upload<double>(state.damping, damping_);
    }
    void give_density(ParticleState& state) const {
        Where::template download<double>(density_, state.density);
        Where::template download<double>(damping_, state.damping);
    }
    void give_motion(ParticleState& state) const {
        Where::template download<Vec3>(position_, state.position);
        Where::template download<Vec3>(velocity_, state.velocity);
        Where::template download<double>(dilution_, state.dilution);
    }
    ParticleColumns columns() {
        return {static_cast<std::int64_t>(position_.size()),
                position_.data(),
                velocity_.data(),
                density_.data(),
                dilution_.data(),
                damping_.size() > 0 ? damping_.data() : nullptr};
    }
    std::size_t bytes() const {
        return (position_.capacity() + velocity_.capacity()) * sizeof(Vec3) +
               (density_.capacity() + dilution_.capacity() + damping_.capacity()) * sizeof(double);
    }

 private:
    typename Where::template Array<Vec3> position_, velocity_;
    typename Where::template Array<double> density_, dilution_, damping_;
};

/// Walls likewise.
template <class Where>
class WallsThere {
 public:
    /// Takes what the update of density reads: where they are, how they move, their volumes.
    void take(const BoundaryParticles& walls) {
        Where::template upload<Vec3>(walls.position, position_);
        Where::template upload<Vec3>(walls.velocity, velocity_);
        Where::template upload<double>(walls.volume, volume_);
    }
    /// The same with all else but accelerations, and makes room for loads.
    void take_for_forces(const BoundaryParticles& walls) {
        take(walls);
        may_stick_ = fluid::may_stick(walls);
        Where::template upload<Vec3>(walls.at_face(), foot_velocity_);
        has_given_ = !walls.given_pressure.empty();
        Where::template upload<std::uint8_t>(walls.is_slippery, is_slippery_);
        Where::template upload<double>(walls.given_pressure, given_pressure_);
        pressure_.resize(walls.position.size());
        pressure_force_.resize(walls.position.size());
        viscous_force_.resize(walls.position.size());
    }
    /// Takes how they move and accelerate.
    void take_motion(const BoundaryParticles& walls) {
        Where::template upload<Vec3>(walls.velocity, velocity_);
        Where::template upload<Vec3>(walls.at_face(), foot_velocity_);
        Where::template upload<Vec3>(walls.acceleration, acceleration_);
    }
    void give_loads(BoundaryParticles& walls) const {
        walls.pressure.resize(walls.position.size());
        walls.pressure_force.resize(walls.position.size());
        walls.viscous_force.resize(walls.position.size());
        Where::template download<double>(pressure_, walls.pressure);
        Where::template download<Vec3>(pressure_force_, walls.pressure_force);
        Where::template download<Vec3>(viscous_force_, walls.viscous_force);
    }
    WallColumns columns() {
        return {static_cast<std::int64_t>(position_.size()),
                position_.data(),
                velocity_.data(),
                foot_velocity_.data(),
                acceleration_.data(),
                volume_.data(),
                is_slippery_.data(),
                has_given_ ? given_pressure_.data() : nullptr,
                may_stick_,
                pressure_.data(),
                pressure_force_.data(),
                viscous_force_.data()};
    }
    std::size_t bytes() const {
        return (position_.capacity() + velocity_.capacity() + foot_velocity_.capacity() + acceleration_.capacity() +
                pressure_force_.capacity() + viscous_force_.capacity()) *
                   sizeof(Vec3) +
               (volume_.capacity() + given_pressure_.capacity() + pressure_.capacity()) * sizeof(double) +
               is_slippery_.capacity();
    }

 private:
    bool may_stick_{false}, has_given_{false};
    typename Where::template Array<Vec3> position_, velocity_, foot_velocity_, acceleration_, pressure_force_,
        viscous_force_;
    typename Where::template Array<double> volume_, given_pressure_, pressure_;
    typename Where::template Array<std::uint8_t> is_slippery_;
};

/// SparseVectors as a functor holds them.
struct SparseColumns {
    const std::int32_t* place;  ///< of each block among those with room, or -1
    const Vec3* vectors;

    RIPRAP_HD Vec3 operator[](std::size_t i) const {
        constexpr auto size = static_cast<std::size_t>(SparseVectors::block_size);
        const std::int32_t block = place[i / size];
        return block < 0 ? Vec3{} : vectors[static_cast<std::size_t>(block) * size + i % size];
    }
};

/// A copy of SparseVectors in memory of `Where`.
template <class Where>
class SparseThere {
 public:
    SparseColumns take(const SparseVectors& force, std::size_t count) {
        constexpr auto size = static_cast<std::size_t>(SparseVectors::block_size);
        std::vector<std::int32_t> place((count + size - 1) / size, -1);
        std::vector<Vec3> vectors;
        force.for_each_block([&](std::size_t block, std::span<const Vec3> some) {
            if (block < place.size()) {
                place[block] = static_cast<std::int32_t>(vectors.size() / size);
                vectors.insert(vectors.end(), some.begin(), some.end());
            }
        });
        Where::template upload<std::int32_t>(place, place_);
        Where::template upload<Vec3>(vectors, vectors_);
        return {place_.data(), vectors_.data()};
    }
    std::size_t bytes() const { return place_.capacity() * sizeof(std::int32_t) + vectors_.capacity() * sizeof(Vec3); }

 private:
    typename Where::template Array<std::int32_t> place_;
    typename Where::template Array<Vec3> vectors_;
};

}  // namespace riprap::fluid
