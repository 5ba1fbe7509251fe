// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>
#include <vector>

#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/ding/planar_cases.hpp"
#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

namespace {

// One table per suite.

std::span<const ValidationCase> zhao_cases() {
    static constexpr std::array cases{
        ValidationCase{"zhao", "free_columns", "Columns of blocks by themselves on a tilting platform", true,
                       zhao::free_columns},
        ValidationCase{"zhao", "slope_1", "Tilted slope: large blocks, persistent joints", true, zhao::slope_1},
        ValidationCase{"zhao", "slope_2", "Tilted slope: large blocks, stepped joints", false, zhao::slope_2},
        ValidationCase{"zhao", "slope_3", "Tilted slope: cubes, persistent joints", true, zhao::slope_3},
        ValidationCase{"zhao", "slope_4", "Tilted slope: cubes, stepped joints", true, zhao::slope_4},
        ValidationCase{"zhao", "slope_5", "Tilted slope: stepped large blocks pushed by small columns", true,
                       zhao::slope_5},
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
        ValidationCase{"mikola", "wave_maker", "A piston makes waves that run up a beach", false, mikola::wave_maker},
    };
    return cases;
}

std::span<const ValidationCase> mellado_cases() {
    static constexpr std::array cases{
        ValidationCase{"mellado", "cylinder_entry", "A cylinder falls into deep water at two densities", false,
                       mellado::cylinder_entry},
    };
    return cases;
}

std::span<const ValidationCase> ding_cases() {
    static constexpr std::array cases{
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
             {zhao_cases(), rigid_cases(), mikola_cases(), mellado_cases(), ding_cases()}) {
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
