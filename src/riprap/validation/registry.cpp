// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>
#include <vector>

#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/ding/breakwater.hpp"
#include "riprap/validation/ding/cases_3d.hpp"
#include "riprap/validation/ding/planar_cases.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

namespace {

// One table per suite; those of dda and ding in space come before those in the plane.

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

std::span<const ValidationCase> water_cases() {
    static constexpr std::array cases{
        ValidationCase{"water", "still_tank", "Water at rest stays at rest", false, water::still_tank},
        ValidationCase{"water", "submerged_square", "Buoyancy of a square held under water", false,
                       water::submerged_square},
        ValidationCase{"water", "floating_box", "A box finds its draft", false, water::floating_box},
        ValidationCase{"water", "heave_decay", "A floating cylinder comes to rest (Ursell)", false, water::heave_decay},
        ValidationCase{"water", "standing_wave", "Period of a standing wave", false, water::standing_wave},
        ValidationCase{"water", "dam_break_front", "Front of a dam break on a dry floor", false,
                       water::dam_break_front},
        ValidationCase{"water", "floating_stability", "Which boxes float upright", true, water::floating_stability},
        ValidationCase{"water", "elliptic_drop", "A drop that stretches freely", false, water::elliptic_drop},
        ValidationCase{"water", "jet_on_plate", "A steady jet on a plate", false, water::jet_on_plate},
        ValidationCase{"water", "wall_impact", "Pressure of a dam break on a wall", false, water::wall_impact},
        ValidationCase{"water", "dam_break_obstacle", "Dam break against a box (SPHERIC 2)", false,
                       water::dam_break_obstacle},
        ValidationCase{"water", "submerged_cube", "Buoyancy of a cube held under water", false, water::submerged_cube},
        ValidationCase{"water", "poiseuille", "Flow between plates starts under a body force", false,
                       water::poiseuille},
        ValidationCase{"water", "couette", "Flow between plates starts with one of them", false, water::couette},
        ValidationCase{"water", "solitary_wave", "A solitary wave travels and runs up a wall", false,
                       water::solitary_wave},
        ValidationCase{"water", "wave_run_up", "Regular waves run up a smooth slope (Hunt; Seelig)", true,
                       water::wave_run_up},
        ValidationCase{"water", "sloshing", "Water in a pitching tank", false, water::sloshing},
        ValidationCase{"water", "sway", "Shallow water in a swaying tank (Bouscasse and others)", true, water::sway},
        ValidationCase{"water", "cylinder_entry", "A cylinder falls into water (Greenhow and Lin)", false,
                       water::cylinder_entry},
        ValidationCase{"water", "sinking_block", "A block sinks (Qiu and others)", false, water::sinking_block},
        ValidationCase{"water", "dam_break_cube", "A dam break carries a cube (Canelas and others)", false,
                       water::dam_break_cube},
        ValidationCase{"water", "dam_break_cubes", "A dam break knocks down a pyramid of cubes (Canelas and others)",
                       false, water::dam_break_cubes},
        ValidationCase{"water", "stacked_blocks", "Joints of five blocks under water carry buoyant weights", false,
                       water::stacked_blocks},
        ValidationCase{"water", "taylor_green", "Vortices die by viscosity", false, water::taylor_green},
        ValidationCase{"water", "viscous_wave", "A standing wave dies by viscosity", false, water::viscous_wave},
        ValidationCase{"water", "spinning_disc", "Torque on a disc that turns in a vessel", false,
                       water::spinning_disc},
        ValidationCase{"water", "ritter", "Dam break on a dry bed", false, water::ritter},
        ValidationCase{"water", "stoker", "Dam break on a wet bed", false, water::stoker},
        ValidationCase{"water", "torricelli", "Flow through a sharp slot", false, water::torricelli},
        ValidationCase{"water", "colliding_squares", "Two squares of water collide", false, water::colliding_squares},
        ValidationCase{"water", "wedge_slamming", "A wedge goes through a surface", false, water::wedge_slamming},
        ValidationCase{"water", "other_schemes", "The scheme of Mueller", false, water::other_schemes},
    };
    return cases;
}

std::span<const ValidationCase> mikola_cases() {
    static constexpr std::array cases{
        ValidationCase{"mikola", "wave_maker", "A piston makes waves that run up a beach", false, mikola::wave_maker},
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
        ValidationCase{"mellado", "cylinder_entry", "A cylinder falls into deep water at two densities", false,
                       mellado::cylinder_entry},
    };
    return cases;
}

std::span<const ValidationCase> grid_cases() {
    static constexpr std::array cases{
        ValidationCase{"grid", "cavity", "Flow in a box whose lid moves (Ghia and others)", false, grid::cavity},
        ValidationCase{"grid", "poiseuille", "Flow between plates starts under a body force", false, grid::poiseuille},
        ValidationCase{"grid", "couette", "Flow between plates starts with one of them", false, grid::couette},
        ValidationCase{"grid", "kovasznay", "Steady flow behind a grid, equal and graded cells: order of convergence",
                       false, grid::kovasznay},
        ValidationCase{"grid", "taylor_green", "A vortex decays: order of convergence", false, grid::taylor_green},
        ValidationCase{"grid", "slotted_disc", "A slotted disc is carried around (Zalesak)", false, grid::slotted_disc},
        ValidationCase{"grid", "vortex", "A disc in a vortex that turns back (Rider and Kothe)", false, grid::vortex},
        ValidationCase{"grid", "sway", "Shallow water in a swaying tank (Bouscasse and others)", false, grid::sway},
        ValidationCase{"grid", "rising_bubble", "A bubble rises (Hysing and others)", false, grid::rising_bubble},
        ValidationCase{"grid", "regular_waves", "Regular waves come in, travel and go out", false, grid::regular_waves},
        ValidationCase{"grid", "wave_propagation", "Regular waves keep their height over ten lengths", true,
                       grid::wave_propagation},
        ValidationCase{"grid", "run_up", "A solitary wave runs up a slope (Synolakis)", false, grid::run_up},
        ValidationCase{"grid", "oscillating_cylinder", "A cylinder swings in viscous fluid: noise of its force", false,
                       grid::oscillating_cylinder},
        ValidationCase{"grid", "heave_decay", "A floating cylinder comes to rest (Ursell)", false, water::heave_decay},
        ValidationCase{"grid", "cylinder_entry", "A cylinder falls into water (Greenhow and Lin)", false,
                       water::cylinder_entry},
        ValidationCase{"grid", "sinking_block", "A block sinks (Qiu and others)", true, water::sinking_block},
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
             {zhao_cases(), rigid_cases(), water_cases(), mikola_cases(), ding_in_space_cases(), mellado_cases(),
              grid_cases(), ding_in_plane_cases()}) {
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
