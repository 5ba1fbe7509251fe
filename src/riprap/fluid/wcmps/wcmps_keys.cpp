// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/key.hpp"
#include "riprap/fluid/mps_operators/mps_keys.hpp"
#include "riprap/fluid/particle/particle_keys.hpp"
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

namespace riprap::fluid {

using namespace key;

MethodKeys<WcmpsSettings> WcmpsSettings::keys() {
    using S = WcmpsSettings;
    return {
        .help = "weakly compressible moving particle semi-implicit method",
        .keys =
            particle_keys<S>() + mps_keys<S>() +
            KeyList<S>{
                number(&S::smoothing_ratio, "smoothing_ratio", dimension::plain, between(1, 2),
                       "Half the support radius over spacing; 1.55 is the support of 3.1 spacings of the source."),
                number(&S::tait_exponent, "tait_exponent", dimension::plain, between(1, 10),
                       "Exponent of the Tait equation."),
                number(&S::kinematic_viscosity, "kinematic_viscosity", dimension::kinematic_viscosity, non_negative(),
                       "Kinematic viscosity of the fluid."),
                number(&S::density_diffusion, "density_diffusion", dimension::plain, between(0, 1),
                       "Strength of the diffusion of number density."),
                number(&S::acoustic_damping, "acoustic_damping", dimension::plain, between(0, 1),
                       "Strength of the bulk viscosity that damps sound inside the water; 0 = off."),
                boolean(&S::diffuses_hydrostatic, "diffuses_hydrostatic",
                        "Diffusion of all of the number density as in the source, not only of what gravity does not "
                        "explain; still water then creeps.")
                    .read_above("density_diffusion", 0),
                number(&S::shifting, "shifting", dimension::plain, between(0, 10),
                       "Multiple of the shifting of particles; 0 = off."),
                number(&S::collision_distance, "collision_distance", dimension::plain, between(0, 1),
                       "Share of the spacing below which particles at the surface collide; 0 = off."),
                number(&S::collision_ratio, "collision_ratio", dimension::plain, between(0, 1),
                       "Speed of separation over speed of approach in such a collision.")
                    .read_above("collision_distance", 0),
                number(&S::courant, "courant", dimension::plain, above(0, 1),
                       "Share of the time that sound needs through a spacing that a step may last."),
                choice(&S::wall_loads, "wall_loads",
                       {{"pair_sum", WallLoads::pair_sum}, {"pressure_area", WallLoads::pressure_area}},
                       "Loads on solids: the reaction pair by pair; or -p A n of the outermost layer as in the source, "
                       "which keeps neither momentum nor energy (for comparison)."),
                integer(&S::sort_interval, "sort_interval", 1, 1e6,
                        "Steps between sorts of the particles by place: part of the result, as sums follow the "
                        "order.")},
        .scene_keys = {"sound_speed", "expected_speed", "wall", "joint_pressure", "domain", "region", "flow", "jitter",
                       "sponge", "inflow", "outflow"}};
}

}  // namespace riprap::fluid
