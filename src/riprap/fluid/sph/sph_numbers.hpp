// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of SPH, grouped by the stage that writes them, in memory of the host or of a device. Each group is made anew
// in every step.

#include "riprap/fluid/particle/sweep/numbers.hpp"
#include "riprap/fluid/particle/sweep/symmetric.hpp"

namespace riprap::fluid {

// clang-format off
/// Places in the StageMemory of a step. Those in one line follow each other in time: AdvanceDensity makes B of M in its
/// place, particle by particle, and the sums of forces take the places of what the update of density has read.
struct SphPlaces {
    enum : std::size_t {
        moments = 0, correction = moments,
        moments_alone = moments + symmetric_numbers, correction_share = moments_alone,
        inside = moments_alone + 1, damped_share = inside,
        rates = inside + 1, force = rates, to_surface = force + 3,
        diffusion = rates + symmetric_numbers, wall_heat = diffusion,
        compression_rate = diffusion + 1, heat = compression_rate,
        wall_hold = compression_rate + 1, rates_alone = wall_hold,
        wall_hold_power = wall_hold + 3,
        velocity_gradient = wall_hold_power + 1,
        count = velocity_gradient,
    };
};
// clang-format on

/// Sums of Continuity and ContinuityAtWalls that the update of density alone reads.
struct DensitySums {
    NumbersView<symmetric_numbers> moments;  ///< M [-]
    NumbersView<1> moments_alone;            ///< tr M of the water alone [-]
    NumbersView<1> inside;  ///< share of a particle inside the water alone, with neighbours evenly all around [-]
    NumbersView<symmetric_numbers> rates;  ///< G [1/s]
    NumbersView<1> diffusion;
    NumbersView<1> rates_alone;  ///< tr G of the water alone [1/s]
};
template <class Where>
DensitySums lend_density_sums(StageMemory<Where>& memory) {
    return {memory.template lend<symmetric_numbers>(SphPlaces::moments),
            memory.template lend<1>(SphPlaces::moments_alone),
            memory.template lend<1>(SphPlaces::inside),
            memory.template lend<symmetric_numbers>(SphPlaces::rates),
            memory.template lend<1>(SphPlaces::diffusion),
            memory.template lend<1>(SphPlaces::rates_alone)};
}

/// Made by the update of density: read by the sums of forces and, the first two, by shifting.
struct Corrections {
    NumbersView<symmetric_numbers> tensor;  ///< B [-]
    NumbersView<1> share;                   ///< s of GradientCorrection [-]
    NumbersView<1> damped;                  ///< s_i of Sound (docs/theory/sph.md, 5) [-]
    NumbersView<1> compression_rate;        ///< -div v, before the sums of forces [1/s]
};
template <class Where>
Corrections lend_corrections(StageMemory<Where>& memory) {
    return {memory.template lend<symmetric_numbers>(SphPlaces::correction),
            memory.template lend<1>(SphPlaces::correction_share), memory.template lend<1>(SphPlaces::damped_share),
            memory.template lend<1>(SphPlaces::compression_rate)};
}

/// Sums of Momentum and MomentumFromWalls per volume of the particle: read by the kick.
struct ForceSums {
    NumbersView<3> force;
    NumbersView<1> heat;             ///< of viscosity, pair by pair; each pair is met twice
    NumbersView<3> to_surface;       ///< the way to particles of the surface
    NumbersView<1> wall_heat;        ///< that counts once: of viscosity at walls and of damped sound
    NumbersView<3> wall_hold;        ///< part of the force that is due to p_w, and
    NumbersView<1> wall_hold_power;  ///< its power on the walls, both with a minus
};
template <class Where>
ForceSums lend_force_sums(StageMemory<Where>& memory) {
    return {memory.template lend<3>(SphPlaces::force),      memory.template lend<1>(SphPlaces::heat),
            memory.template lend<3>(SphPlaces::to_surface), memory.template lend<1>(SphPlaces::wall_heat),
            memory.template lend<3>(SphPlaces::wall_hold),  memory.template lend<1>(SphPlaces::wall_hold_power)};
}

/// Fields of the water that one stage hands on to later ones.
template <class Where>
struct WaterFieldsIn {
    // From the state equation, for the sums at hand: the forces see a pressure with the damping of sound in it.
    Numbers<1, Where> pressure, volume;  ///< [Pa], [m^3]
    // From the update of density.
    Numbers<1, Where> strain;                  ///< sum of Continuity
    Numbers<3, Where> concentration_gradient;  ///< likewise [1/m]
    Numbers<1, Where> bareness;                ///< 1 at the surface, 0 inside the water [-]
    // For the sums of forces.
    Numbers<1, Where> dynamic_viscosity;  ///< or roughness [-]; one for all where it is the same [Pa s]

    std::size_t bytes() const {
        return pressure.bytes() + volume.bytes() + strain.bytes() + concentration_gradient.bytes() + bareness.bytes() +
               dynamic_viscosity.bytes();
    }
};

/// Sums over the water at every wall particle, which do not depend on how the walls move.
template <class Where>
struct WaterAtWallSumsIn {
    Numbers<1, Where> weight, pressure;  ///< of WallAverages
    Numbers<3, Where> moment, velocity;
    Numbers<3, Where> slope, push;  ///< of PressureOnWalls

    std::size_t bytes() const {
        return weight.bytes() + pressure.bytes() + moment.bytes() + velocity.bytes() + slope.bytes() + push.bytes();
    }
};

/// Fields of wall particles as the water sees them move.
template <class Where>
struct WallFieldsIn {
    Numbers<3, Where> mirrored_velocity;  ///< u_w [m/s]
    Numbers<1, Where> grip;               ///< 0 on slippery walls, else 1

    std::size_t bytes() const { return mirrored_velocity.bytes() + grip.bytes(); }
};

}  // namespace riprap::fluid
