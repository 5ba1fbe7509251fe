// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::fluid {

/// The particles of a fluid that this machine owns, where loops over them run, on the host or on a device: pointers to
/// the columns of ParticleState. A view: whoever has it may write.
struct ParticleColumns {
    std::int64_t count{0};
    Vec3* position{nullptr};
    Vec3* velocity{nullptr};
    double* density{nullptr};
    double* dilution{nullptr};
    double* damping{nullptr};  ///< nullptr: none

    std::span<const Vec3> positions() const { return {position, static_cast<std::size_t>(count)}; }
    std::span<const Vec3> velocities() const { return {velocity, static_cast<std::size_t>(count)}; }
    std::span<const double> densities() const { return {density, static_cast<std::size_t>(count)}; }
};

/// The columns of BoundaryParticles, as a view too.
struct WallColumns {
    std::int64_t count{0};
    const Vec3* position{nullptr};
    const Vec3* velocity{nullptr};
    const Vec3* foot_velocity{nullptr};
    const Vec3* acceleration{nullptr};
    const double* volume{nullptr};
    const std::uint8_t* is_slippery{nullptr};
    const double* given_pressure{nullptr};  ///< nullptr: none
    bool may_stick{false};                  ///< some are not slippery
    double* pressure{nullptr};
    Vec3* pressure_force{nullptr};
    Vec3* viscous_force{nullptr};

    std::span<const Vec3> positions() const { return {position, static_cast<std::size_t>(count)}; }
    std::span<const Vec3> velocities() const { return {velocity, static_cast<std::size_t>(count)}; }
    std::span<const double> volumes() const { return {volume, static_cast<std::size_t>(count)}; }
    std::span<const double> pressures() const { return {pressure, static_cast<std::size_t>(count)}; }
};

/// Tells whether there is viscous force at some wall.
inline bool may_stick(const BoundaryParticles& walls) {
    return std::find(walls.is_slippery.begin(), walls.is_slippery.end(), 0) != walls.is_slippery.end();
}

inline ParticleColumns columns_of(ParticleState& state) {
    return {state.size(),         state.position.data(), state.velocity.data(),
            state.density.data(), state.dilution.data(), state.damping.empty() ? nullptr : state.damping.data()};
}
/// To be read only.
inline ParticleColumns columns_of(const ParticleState& state) { return columns_of(const_cast<ParticleState&>(state)); }

/// To be read only.
inline WallColumns columns_of(const BoundaryParticles& walls) {
    return {.count = walls.size(),
            .position = walls.position.data(),
            .velocity = walls.velocity.data(),
            .foot_velocity = walls.at_face().data(),
            .acceleration = walls.acceleration.data(),
            .volume = walls.volume.data(),
            .is_slippery = walls.is_slippery.data(),
            .given_pressure = walls.given_pressure.empty() ? nullptr : walls.given_pressure.data(),
            .may_stick = may_stick(walls),
            .pressure = const_cast<double*>(walls.pressure.data())};
}
/// With room for what the fluid finds there.
inline WallColumns columns_of(BoundaryParticles& walls) {
    WallColumns columns = columns_of(std::as_const(walls));
    walls.pressure.resize(walls.position.size());
    walls.pressure_force.resize(walls.position.size());
    walls.viscous_force.resize(walls.position.size());
    columns.pressure = walls.pressure.data();
    columns.pressure_force = walls.pressure_force.data();
    columns.viscous_force = walls.viscous_force.data();
    return columns;
}

}  // namespace riprap::fluid
