// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps_operators/mps_keys.hpp"
#include "riprap/core/key.hpp"
#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/particle_keys.hpp"

namespace riprap::fluid {

using namespace key;

namespace {

using S = MpsSettings;

KeyList<S> pressure_keys() {
    return {number(&S::compressibility, "compressibility", dimension::plain, above(0, 1e-4),
                   "Artificial compressibility of the pressure equation [1/Pa]."),
            number(&S::relaxation, "relaxation", dimension::plain, above(0, 1),
                   "Share of an error of number density that a step corrects."),
            number(&S::divergence_share, "divergence_share", dimension::plain, between(0, 1),
                   "Share of the divergence of velocity in the pressure equation; 0 as in the source, where still "
                   "water shakes."),
            number(&S::surface_density, "surface_density", dimension::plain, between(0.5, 1),
                   "Particles of the surface have less than this share of the number density of the lattice."),
            number(&S::surface_offset, "surface_offset", dimension::plain, between(0, 1),
                   "And the centre of their neighbours is farther away than this share of the spacing."),
            choice(&S::gradient, "gradient",
                   {{"conservative", MpsGradient::conservative}, {"corrected", MpsGradient::corrected}},
                   "Gradient of pressure that moves particles: pairs in balance, or exact for linear pressures, "
                   "which does not keep momentum."),
            number(&S::tolerance, "tolerance", dimension::plain, between(1e-14, 0.1),
                   "Residual of the pressure equation over its right-hand side."),
            integer(&S::max_iterations, "max_iterations", 1, 100000,
                    "Of the solver of the pressure equation; the run stops where they are not enough.")};
}

}  // namespace

MethodKeys<MpsSettings> MpsSettings::keys() {
    return {
        .help = "moving particle semi-implicit method",
        .keys =
            particle_keys<S>() + mps_keys<S>() +
            KeyList<S>{
                number(
                    &S::smoothing_ratio, "smoothing_ratio", dimension::plain, between(1, 2),
                    "Half the support radius over spacing; 1.05 is the support of 2.1 spacings of the source, two to "
                    "four times as fast, by which light bodies rise too slowly."),
                number(&S::kinematic_viscosity, "kinematic_viscosity", dimension::kinematic_viscosity, non_negative(),
                       "Of the fluid."),
                number(&S::collision_distance, "collision_distance", dimension::plain, between(0, 1),
                       "Share of the spacing below which particles collide; 0 = off."),
                number(&S::collision_ratio, "collision_ratio", dimension::plain, between(0, 1),
                       "Speed of separation over speed of approach in such a collision.")
                    .read_above("collision_distance", 0),
                number(&S::courant, "courant", dimension::plain, above(0, 1),
                       "Share of the time that the fastest water needs through a spacing that a step may last."),
                integer(&S::sort_interval, "sort_interval", 1, 1e6,
                        "Steps between sorts of the particles by place: part of the result, as sums follow the "
                        "order.")} +
            pressure_keys(),
        .scene_keys = {"sound_speed", "expected_speed", "wall", "joint_pressure", "domain", "region", "flow", "jitter",
                       "sponge", "inflow", "outflow"}};
}

}  // namespace riprap::fluid
