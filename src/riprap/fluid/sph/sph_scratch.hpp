// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"
#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::fluid {

/// Buffers of a step, one entry per particle; see the pair physics for what they hold.
struct SphScratchData {
    std::vector<double> pressure, volume;   ///< [Pa], [m^3]
    std::vector<double> mass, wall_mass;    ///< as they enter a sum of density [kg]
    std::vector<double> dynamic_viscosity;  ///< molecular and of eddies [Pa s]

    std::vector<std::array<double, 9>> transposed_stress;  ///< mu (grad u)^T, see transposed_stress.hpp [Pa]
    std::vector<Vec3> wall_stress;                         ///< sum of TransposedOnWalls

    std::vector<double> diffusion, strain;       ///< sums of Continuity
    std::vector<double> squeeze;                 ///< -div v [1/s]
    std::vector<double> damped_share;            ///< s_i of Sound (docs/theory/sph.md, 5) [-]
    std::vector<Symmetric> correction;           ///< its moments M; then B [-]
    std::vector<Symmetric> pressure_tensor;      ///< its sums G [1/s]; then p B [Pa]
    std::vector<double> correction_share;        ///< share of it [-]
    std::vector<double> bareness;                ///< 1 at the surface, 0 inside the water [-];
                                                 ///< first that without walls
    std::vector<Vec3> force, surface_direction;  ///< sums of Momentum
    std::vector<Vec3> concentration_gradient;    ///< sum of Continuity, first that without walls [1/m]
    std::vector<double> heat;                    ///< of viscosity, pair by pair; each pair is met twice
    std::vector<double> wall_heat;               ///< that counts once: of viscosity at walls and of damped sound
    std::vector<Vec3> wall_hold;                 ///< part of the force that is due to p_w, and
    std::vector<double> wall_hold_power;         ///< its power on the walls, both with a minus

    std::vector<double> wall_weight, wall_pressure;  ///< sums of WallAverages
    std::vector<Vec3> wall_moment, wall_velocity;
    std::vector<Vec3> wall_slope, wall_push;  ///< sums of PressureOnWalls
    std::vector<Vec3> mirrored_velocity;      ///< u_w [m/s]
    std::vector<double> grip;                 ///< 0 on slippery walls, else 1

    SweepScratch fluid_fluid;
    SweepScratch fluid_walls{SweepScratch::sharing_buffers(fluid_fluid)};
    SweepScratch walls_fluid{SweepScratch::sharing_buffers(fluid_fluid)};

    std::size_t bytes() const {
        return bytes_of(pressure, volume, mass, wall_mass, dynamic_viscosity, transposed_stress, wall_stress, diffusion,
                        strain, squeeze, damped_share, correction, pressure_tensor, correction_share, bareness, force,
                        concentration_gradient, surface_direction, heat, wall_heat, wall_hold, wall_hold_power,
                        wall_weight, wall_pressure, wall_moment, wall_velocity, wall_slope, wall_push,
                        mirrored_velocity, grip) +
               fluid_fluid.bytes() + fluid_walls.bytes() + walls_fluid.bytes();
    }
};

/// One number of a symmetric tensor per particle.
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
