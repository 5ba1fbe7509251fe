// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>
#include <vector>

#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/ding/breakwater.hpp"
#include "riprap/validation/ding/cases_3d.hpp"
#include "riprap/validation/ding/planar_cases.hpp"
#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

namespace {

// One table per suite; those of dda and ding in space come before those in the plane.

std::span<const ValidationCase> zhao_cases() {
    static constexpr std::array cases{
        ValidationCase{"zhao", "two_tetrahedra", "A tetrahedron falls on the ridge of another and returns", false,
                       zhao::two_tetrahedra},
        ValidationCase{"zhao", "incline", "A block slides up an incline, stops, and slides back or stays", false,
                       zhao::incline},
        ValidationCase{"zhao", "free_columns", "Columns of blocks by themselves on a tilting platform", true,
                       zhao::free_columns},
        ValidationCase{"zhao", "slope_1", "Tilted slope: large blocks, persistent joints", true, zhao::slope_1},
        ValidationCase{"zhao", "slope_2", "Tilted slope: large blocks, stepped joints", false, zhao::slope_2},
        ValidationCase{"zhao", "slope_3", "Tilted slope: cubes, persistent joints", true, zhao::slope_3},
        ValidationCase{"zhao", "slope_4", "Tilted slope: cubes, stepped joints", true, zhao::slope_4},
        ValidationCase{"zhao", "slope_5", "Tilted slope: stepped large blocks pushed by small columns", true,
                       zhao::slope_5},
        ValidationCase{"zhao", "pillar_impact", "A block hits a row and a pillar of blocks", false,
                       zhao::pillar_impact},
        ValidationCase{"zhao", "mixed_pile", "1093 blocks of six kinds and three sizes come to rest", true,
                       zhao::mixed_pile},
        ValidationCase{"zhao", "cubes_in_box", "Cubes fall into a box and come to rest", false, zhao::cubes_in_box},
        ValidationCase{"zhao", "cubes_of_tetrahedra", "The same cubes made of tetrahedra with the FDEM potential", true,
                       zhao::cubes_of_tetrahedra},
    };
    return cases;
}

std::span<const ValidationCase> rigid_cases() {
    static constexpr std::array cases{
        ValidationCase{"rigid", "granular_column", "Columns of grains collapse and run out (Lube et al.)", true,
                       rigid::granular_column},
    };
    return cases;
}

std::span<const ValidationCase> mikola_cases() {
    static constexpr std::array cases{
        ValidationCase{"mikola", "sliding_wedge", "A wedge slides down a plane into water", false,
                       mikola::sliding_wedge},
        ValidationCase{"mikola", "wave_maker", "A piston makes waves that run up a beach", false, mikola::wave_maker},
        ValidationCase{"mikola", "submarine_wedge", "A wedge slides under water (Heinrich)", false,
                       mikola::submarine_wedge},
        ValidationCase{"mikola", "scott_russell", "A box falls into water and sends off a solitary wave", false,
                       mikola::scott_russell},
        ValidationCase{"mikola", "rotating_block", "A block turns many times", false, mikola::rotating_block},
    };
    return cases;
}

std::span<const ValidationCase> ding_in_space_cases() {
    static constexpr std::array cases{
        ValidationCase{"ding", "arch_3d", "3D-DDA: an arch against the same in two dimensions", false, ding::arch_3d},
        ValidationCase{"ding", "dam_uplift", "The top of a dam under rising water, with uplift and cohesion", false,
                       ding::dam_uplift},
    };
    return cases;
}

std::span<const ValidationCase> mellado_cases() {
    static constexpr std::array cases{
        ValidationCase{"mellado", "block_entry", "A block falls into water at three densities", false,
                       mellado::block_entry},
        ValidationCase{"mellado", "cylinder_entry", "A cylinder falls into deep water at two densities", false,
                       mellado::cylinder_entry},
        ValidationCase{"mellado", "floes_4", "Dam breaks over four beds carry four floes", false, mellado::floes_4},
        ValidationCase{"mellado", "floes_sph", "The four by SPH with water in the gaps between floes", false,
                       mellado::floes_sph},
        ValidationCase{"mellado", "floes_9", "Dam breaks over four beds carry nine floes", false, mellado::floes_9},
        ValidationCase{"mellado", "floes_fine", "Four floes over a dry and a wet bed, at 3.26 mm (hours)", true,
                       mellado::floes_fine},
        ValidationCase{"mellado", "floes_none", "Dam breaks over four beds without floes", false, mellado::floes_none},
        ValidationCase{"mellado", "floe_methods", "A dam break with floes by every pair of methods", false,
                       mellado::floe_methods},
        ValidationCase{"mellado", "three_cubes", "A dam break meets three cubes of spheres", false,
                       mellado::three_cubes},
    };
    return cases;
}

std::span<const ValidationCase> ding_in_plane_cases() {
    static constexpr std::array cases{
        ValidationCase{"ding", "layer_thickness", "Turbulence over armour layers of four thicknesses", false,
                       ding::layer_thickness},
        ValidationCase{"ding", "flow_patterns", "A solitary wave grows, breaks and jets at a caisson", false,
                       ding::flow_patterns},
        ValidationCase{"ding", "unit_shapes", "Cubes, accropodes and tetrapods behind a caisson", false,
                       ding::unit_shapes},
        ValidationCase{"ding", "shoreward_slopes", "Cubes behind a caisson on three slopes", false,
                       ding::shoreward_slopes},
        ValidationCase{"ding", "unit_cohesion", "Cubes behind a caisson with and without cohesion", false,
                       ding::unit_cohesion},
        ValidationCase{"ding", "planar_shaken_stack", "Seven blocks on a shaking table", false,
                       ding::planar_shaken_stack},
        ValidationCase{"ding", "planar_air_cannon", "Ice from an air cannon hits ballast", true,
                       ding::planar_air_cannon},
        ValidationCase{"ding", "planar_air_cannon_level", "Ice from an air cannon, along the track", true,
                       ding::planar_air_cannon_level},
        ValidationCase{"ding", "planar_cross_section", "Ice falls on ballast beside a rail", true,
                       ding::planar_cross_section},
        ValidationCase{"ding", "planar_train_speed", "Ice from a moving train hits ballast", true,
                       ding::planar_train_speed},
        ValidationCase{"ding", "planar_incident_angle", "Ice hits ballast at four angles", true,
                       ding::planar_incident_angle},
        ValidationCase{"ding", "planar_ice_shape", "A circle, a triangle and a square of ice hit ballast", true,
                       ding::planar_ice_shape},
    };
    return cases;
}

}  // namespace

std::span<const ValidationCase> all_cases() {
    static const std::vector<ValidationCase> cases = [] {
        std::vector<ValidationCase> all;
        for (const std::span<const ValidationCase> suite :
             {zhao_cases(), rigid_cases(), mikola_cases(), ding_in_space_cases(), mellado_cases(),
              ding_in_plane_cases()}) {
            all.insert(all.end(), suite.begin(), suite.end());
        }
        const std::vector<ValidationCase> files = file_cases(all);
        all.insert(all.end(), files.begin(), files.end());
        const std::vector<ValidationCase> crossed = cross::scenes();
        all.insert(all.end(), crossed.begin(), crossed.end());
        return all;
    }();
    return cases;
}

}  // namespace riprap::validation
