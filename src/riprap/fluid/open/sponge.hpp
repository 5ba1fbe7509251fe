// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"

namespace riprap::fluid {

/// A box in which water is slowed down, ever more along one direction, so that waves die in it before they reach its
/// end:
///
///     dv/dt = -r s^2 (v - u),   s = share of the way through the box, 0 where waves enter, 1 at its end.
///
/// Over a step it takes the exact decay 1 - exp(-r s^2 dt), so that no rate is unstable. A long wave of speed c loses
/// exp(-r L/(3 c)) of its height on the way through a box of length L and back [-], as friction at rate q takes q/2 of
/// a wave's amplitude in a unit of time, and the mean of s^2 is 1/3.
struct Sponge {
    Vec3 low{}, high{};  ///< [m]
    int axis{0};         ///< along which it grows
    bool is_towards_high{true};
    double rate{0};   ///< r [1/s]
    Vec3 velocity{};  ///< u, of a current that stays [m/s]
};

/// r with which a wave at sqrt(g d), the fastest there is, comes back with a hundredth of its height: 3 ln(100) c/L.
double sponge_rate(double gravity, double depth, double length);

/// Work and impulse of sponges over the last step: Scratch.
struct SpongeWork {
    SparseVectors force, before;  ///< on particles in sponges [N], and their velocity before the kick [m/s]
};

/// Adds the forces of all sponges to `force`, which has room for all particles, and notes them in `work`.
void push_sponges(std::span<const Sponge> sponges, const ParticleSettings& settings, const ParticleState& state,
                  double dt, SparseVectors& force, SpongeWork& work);

/// Energy that sponges took from the water over the kick that these forces were part of [J].
double absorbed_energy(const ParticleState& state, double dt, const SpongeWork& work);

}  // namespace riprap::fluid
