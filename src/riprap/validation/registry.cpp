// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <array>

#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation {

std::span<const ValidationCase> all_cases() {
    static constexpr std::array cases{
        ValidationCase{"zhao", "golden_values", "Contact of two blocks: energy, force and moment to ten digits", false,
                       zhao::golden_values},
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
        ValidationCase{"zhao", "detection", "Time of contact detection against the number of blocks", false,
                       zhao::detection},
        ValidationCase{"zhao", "wedge_static", "A wedge slides down its line of intersection", false,
                       zhao::wedge_static},
        ValidationCase{"zhao", "wedge_dynamic", "A wedge on a shaken slope slides, stops and rests", false,
                       zhao::wedge_dynamic},
        ValidationCase{"rigid", "free_flight", "Free fall; a spinning projectile", false, rigid::free_flight},
        ValidationCase{"rigid", "axis_flip", "A free body tumbles about its middle axis", false, rigid::axis_flip},
        ValidationCase{"rigid", "sliding_block", "A block on an incline slides, holds, stops", false,
                       rigid::sliding_block},
        ValidationCase{"rigid", "tip_or_slide", "A block on a slope raised slowly tips or slides", false,
                       rigid::tip_or_slide},
        ValidationCase{"rigid", "shaken_block", "A block on a base that speeds up ever faster tips or slides", false,
                       rigid::shaken_block},
        ValidationCase{"rigid", "rocking", "A block rocks from one edge to the other (Housner)", false, rigid::rocking},
        ValidationCase{"rigid", "bounce", "A cube dropped face down bounces and comes to rest", false, rigid::bounce},
        ValidationCase{"rigid", "collisions", "Equal cubes in a row hand on their speed", false, rigid::collisions},
        ValidationCase{"rigid", "stacks", "Stacked blocks carry their weight; bricks lean out to the harmonic limit",
                       false, rigid::stacks},
        ValidationCase{"rigid", "dragged_block", "A block on a plank sliding on ice", false, rigid::dragged_block},
        ValidationCase{"rigid", "plane_failure", "A block on a joint with cohesion and water pressure", false,
                       rigid::plane_failure},
        ValidationCase{"rigid", "keystone", "A roof block wedged between two that are pushed together", false,
                       rigid::keystone},
        ValidationCase{"rigid", "rock_wedges", "Wedges on two joint planes hold or slide (Hoek and Bray)", false,
                       rigid::rock_wedges},
        ValidationCase{"rigid", "toppling_columns", "Sixteen columns on a stepped base (Goodman and Bray)", false,
                       rigid::toppling_columns},
        ValidationCase{"rigid", "arch", "A semicircular arch stands or falls", false, rigid::arch},
        ValidationCase{"water", "still_tank", "Water at rest stays at rest", false, water::still_tank},
        ValidationCase{"water", "submerged_square", "Buoyancy of a square held under water", false,
                       water::submerged_square},
        ValidationCase{"water", "floating_box", "A box finds its draft", false, water::floating_box},
        ValidationCase{"water", "standing_wave", "Period of a standing wave", false, water::standing_wave},
        ValidationCase{"water", "dam_break_front", "Front of a dam break on a dry floor", false,
                       water::dam_break_front},
        ValidationCase{"water", "floating_stability", "Which boxes float upright", true, water::floating_stability},
        ValidationCase{"water", "wall_impact", "Pressure of a dam break on a wall", false, water::wall_impact},
        ValidationCase{"water", "dam_break_obstacle", "Dam break against a box (SPHERIC 2)", false,
                       water::dam_break_obstacle},
        ValidationCase{"water", "submerged_cube", "Buoyancy of a cube held under water", false, water::submerged_cube},
        ValidationCase{"water", "poiseuille", "Flow between plates starts under a body force", false,
                       water::poiseuille},
        ValidationCase{"water", "couette", "Flow between plates starts with one of them", false, water::couette},
        ValidationCase{"water", "solitary_wave", "A solitary wave travels and runs up a wall", false,
                       water::solitary_wave},
        ValidationCase{"water", "sloshing", "Water in a pitching tank", false, water::sloshing},
        ValidationCase{"water", "cylinder_entry", "A cylinder falls into water (Greenhow and Lin)", false,
                       water::cylinder_entry},
        ValidationCase{"water", "sinking_block", "A block sinks (Qiu and others)", false, water::sinking_block},
        ValidationCase{"water", "dam_break_cube", "A dam break carries a cube (Canelas and others)", false,
                       water::dam_break_cube},
        ValidationCase{"mikola", "sliding_wedge", "A wedge slides down a plane into water", false,
                       mikola::sliding_wedge},
        ValidationCase{"mikola", "wave_maker", "A piston makes waves that run up a beach", false, mikola::wave_maker},
        ValidationCase{"mikola", "submarine_wedge", "A wedge slides under water (Heinrich)", false,
                       mikola::submarine_wedge},
        ValidationCase{"mikola", "scott_russell", "A box falls into water and sends off a solitary wave", false,
                       mikola::scott_russell},
    };
    return cases;
}

}  // namespace riprap::validation
