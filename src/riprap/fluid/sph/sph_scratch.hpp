// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of SPH, one entry per particle, grouped by the stage that writes them. Each group is made anew in every step;
// only the lists of neighbours are kept for speed.

#include <array>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep_lists.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"
#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::fluid {

/// Sums of Continuity and ContinuityAtWalls: read by the update of density, the gradient and the strain also later.
struct ContinuitySums {
    std::vector<double> diffusion, strain;
    std::vector<Symmetric> moments;            ///< M [-]
    std::vector<Symmetric> rates;              ///< G [1/s]
    std::vector<Vec3> concentration_gradient;  ///< [1/m]
    // Of the water alone, without walls:
    std::vector<double> trace_alone;  ///< tr M [-]
    std::vector<double> even_inside;  ///< share of a particle inside the water, neighbours evenly all around [-]

    std::size_t bytes() const {
        return bytes_of(diffusion, strain, moments, rates, concentration_gradient, trace_alone, even_inside);
    }
};

/// Fields of the water that one stage hands on to the next.
struct WaterFields {
    // From the state equation, for the sums at hand: the forces see a pressure with the damping of sound in it.
    std::vector<double> pressure, volume;  ///< [Pa], [m^3]
    // From the update of density.
    std::vector<Symmetric> correction;     ///< B [-]
    std::vector<double> correction_share;  ///< share of it [-]
    std::vector<double> bareness;          ///< 1 at the surface, 0 inside the water [-]
    std::vector<double> compression_rate;  ///< -div v [1/s]
    std::vector<double> damped_share;      ///< s_i of Sound (docs/theory/sph.md, 5) [-]
    // For the sums of forces.
    std::vector<double> dynamic_viscosity;                 ///< molecular and of eddies [Pa s]
    std::vector<Symmetric> pressure_tensor;                ///< p B [Pa]
    std::vector<std::array<double, 9>> transposed_stress;  ///< mu (grad u)^T, see transposed_stress.hpp [Pa]
    std::vector<double> mass;                              ///< as it enters a sum of density [kg]

    std::size_t bytes() const {
        return bytes_of(pressure, volume, correction, correction_share, bareness, compression_rate, damped_share,
                        dynamic_viscosity, pressure_tensor, transposed_stress, mass);
    }
};

/// Sums of Momentum and MomentumFromWalls, per volume of the particle: read by the kick.
struct ForceSums {
    std::vector<Vec3> force;
    std::vector<Vec3> surface_direction;
    std::vector<double> heat;             ///< of viscosity, pair by pair; each pair is met twice
    std::vector<double> wall_heat;        ///< that counts once: of viscosity at walls and of damped sound
    std::vector<Vec3> wall_hold;          ///< part of the force that is due to p_w, and
    std::vector<double> wall_hold_power;  ///< its power on the walls, both with a minus

    std::size_t bytes() const {
        return bytes_of(force, surface_direction, heat, wall_heat, wall_hold, wall_hold_power);
    }
};

/// Sums over the water at every wall particle, which do not depend on how the walls move.
struct WaterAtWallSums {
    std::vector<double> weight, pressure;  ///< of WallAverages
    std::vector<Vec3> moment, velocity;
    std::vector<Vec3> slope, push;  ///< of PressureOnWalls
    std::vector<Vec3> stress;       ///< of TransposedOnWalls

    std::size_t bytes() const { return bytes_of(weight, pressure, moment, velocity, slope, push, stress); }
};

/// Fields of wall particles as the water sees them move.
struct WallFields {
    std::vector<Vec3> mirrored_velocity;  ///< u_w [m/s]
    std::vector<double> grip;             ///< 0 on slippery walls, else 1
    std::vector<double> mass;             ///< as it enters a sum of density [kg]

    std::size_t bytes() const { return bytes_of(mirrored_velocity, grip, mass); }
};

struct SphScratchData {
    ContinuitySums continuity;
    WaterFields water;
    ForceSums forces;
    WaterAtWallSums at_walls;
    WallFields walls;
    SweepLists lists;

    std::size_t bytes() const {
        return continuity.bytes() + water.bytes() + forces.bytes() + at_walls.bytes() + walls.bytes() + lists.bytes();
    }
};

/// Returns a view of one number of a symmetric tensor per particle.
inline FieldView tensor_component(const std::vector<Symmetric>& tensors, std::size_t k) {
    return {tensors.empty() ? nullptr : tensors[0].data() + k, symmetric_numbers};
}
inline FieldSink sink_tensor(std::vector<Symmetric>& tensors, std::size_t k) {
    return {tensors.empty() ? nullptr : tensors[0].data() + k, symmetric_numbers};
}

/// Makes `count` zeros of it.
template <class T>
void make_zero(std::vector<T>& sums, std::size_t count) {
    sums.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count),
                       [&](std::int64_t i) { sums[static_cast<std::size_t>(i)] = T{}; });
}

}  // namespace riprap::fluid
