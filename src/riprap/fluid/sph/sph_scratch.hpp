// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of SPH, one entry per particle, grouped by the stage that writes them. Each group is made anew in every step;
// only the lists of neighbours are kept for speed.

#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/numbers.hpp"
#include "riprap/fluid/particle/sweep_lists.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"
#include "riprap/fluid/sph/push_places.hpp"
#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::fluid {

/// Sums of Continuity and ContinuityAtWalls: read by the update of density, the last two also later.
template <class Where>
struct ContinuitySumsIn {
    Numbers<1, Where> diffusion;
    Numbers<6, Where> rates;  ///< G [1/s]
    Numbers<1, Where> strain;
    Numbers<3, Where> concentration_gradient;  ///< [1/m]

    std::size_t bytes() const {
        return diffusion.bytes() + rates.bytes() + strain.bytes() + concentration_gradient.bytes();
    }
};

/// Fields of the water that one stage hands on to the next.
template <class Where>
struct WaterFieldsIn {
    // From the state equation, for the sums at hand: the forces see a pressure with the damping of sound in it.
    Numbers<1, Where> pressure, volume;  ///< [Pa], [m^3]
    // From the update of density, which finds sums in their places: M, tr M of the water alone and the share of a
    // particle inside the water alone with neighbours evenly all around.
    Numbers<6, Where> correction;        ///< B [-]
    Numbers<1, Where> correction_share;  ///< share of it [-]
    Numbers<1, Where> damped_share;      ///< s_i of Sound (docs/theory/sph.md, 5) [-]
    Numbers<1, Where> bareness;          ///< 1 at the surface, 0 inside the water [-]
    Numbers<1, Where> compression_rate;  ///< -div v [1/s]
    // For the sums of forces.
    Numbers<1, Where> dynamic_viscosity;  ///< molecular and of eddies; one for all where it is the same [Pa s]
    Numbers<9, Where> transposed_stress;  ///< mu (grad u)^T, see transposed_stress.hpp [Pa]
    Numbers<1, Where> mass;               ///< as it enters a sum of density [kg]

    std::size_t bytes() const {
        return pressure.bytes() + volume.bytes() + correction.bytes() + correction_share.bytes() +
               damped_share.bytes() + bareness.bytes() + compression_rate.bytes() + dynamic_viscosity.bytes() +
               transposed_stress.bytes() + mass.bytes();
    }
};

/// Sums of Momentum and MomentumFromWalls (PushPlaces), per volume of the particle: read by the kick.
template <class Where>
struct ForceSumsIn {
    Numbers<6, Where> pushes;           ///< force, and where the surface is
    Numbers<1, Where> heat;             ///< of viscosity, pair by pair; each pair is met twice
    Numbers<1, Where> wall_heat;        ///< that counts once: of viscosity at walls and of damped sound
    Numbers<3, Where> wall_hold;        ///< part of the force that is due to p_w, and
    Numbers<1, Where> wall_hold_power;  ///< its power on the walls, both with a minus

    std::size_t bytes() const {
        return pushes.bytes() + heat.bytes() + wall_heat.bytes() + wall_hold.bytes() + wall_hold_power.bytes();
    }
};

/// Sums over the water at every wall particle, which do not depend on how the walls move.
template <class Where>
struct WaterAtWallSumsIn {
    Numbers<1, Where> weight, pressure;  ///< of WallAverages
    Numbers<3, Where> moment, velocity;
    Numbers<3, Where> slope, push;  ///< of PressureOnWalls
    Numbers<3, Where> stress;       ///< of TransposedOnWalls

    std::size_t bytes() const {
        return weight.bytes() + pressure.bytes() + moment.bytes() + velocity.bytes() + slope.bytes() + push.bytes() +
               stress.bytes();
    }
};

/// Fields of wall particles as the water sees them move.
template <class Where>
struct WallFieldsIn {
    Numbers<3, Where> mirrored_velocity;  ///< u_w [m/s]
    Numbers<1, Where> grip;               ///< 0 on slippery walls, else 1
    Numbers<1, Where> mass;               ///< as it enters a sum of density [kg]

    std::size_t bytes() const { return mirrored_velocity.bytes() + grip.bytes() + mass.bytes(); }
};

/// All of them, in memory of the host or of a device.
template <class Memory>
struct SphNumbers {
    using Where = Memory;
    ContinuitySumsIn<Where> continuity;
    WaterFieldsIn<Where> water;
    ForceSumsIn<Where> forces;
    WaterAtWallSumsIn<Where> at_walls;
    WallFieldsIn<Where> walls;

    /// Hands memory that the update of density no longer reads to the sums of forces, or takes it back.
    void exchange_memory() {
        continuity.rates.swap(forces.pushes);
        continuity.diffusion.swap(forces.wall_heat);
    }
    /// The same with what is no longer read once the fields for the sums of forces are there.
    void exchange_memory_of_rate() { water.compression_rate.swap(forces.heat); }
    std::size_t bytes() const {
        return continuity.bytes() + water.bytes() + forces.bytes() + at_walls.bytes() + walls.bytes();
    }
};

struct SphScratchData : SphNumbers<parallel::Host> {
    SweepLists lists;
    std::size_t bytes() const { return SphNumbers::bytes() + lists.bytes(); }
};
using WaterFields = WaterFieldsIn<parallel::Host>;
using ForceSums = ForceSumsIn<parallel::Host>;

/// Makes `count` zeros of it.
template <class T>
void make_zero(std::vector<T>& sums, std::size_t count) {
    sums.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count),
                       [&](std::int64_t i) { sums[static_cast<std::size_t>(i)] = T{}; });
}

}  // namespace riprap::fluid
