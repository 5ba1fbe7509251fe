// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "riprap/core/key.hpp"
#include "riprap/coupling/grid_fluid/grid_fluid.hpp"

namespace riprap::coupling {

using fluid::grid::SideKind;
using fluid::grid::Turbulence;
using fluid::grid::VofScheme;

MethodKeys<GridFluidSettings> GridFluidSettings::keys() {
    using namespace key;
    using S = GridFluidSettings;
    return {
        .help = "water and air on a grid of cells, incompressible, bodies cut out of the cells",
        .keys =
            {number(&S::spacing, "spacing", dimension::length, positive(), "Width of a cell.").required(),
             vector(&S::stretch, "stretch", dimension::plain, between(1, 100),
                    "Width of cells along x, y and z over `spacing`: long cells for long waves."),
             number(&S::wall_narrowing, "wall_narrowing", dimension::plain, between(0, 0.9),
                    "Cells beside both ends of the domain are narrower than `spacing` by this share, and those in the "
                    "middle wider: faces at x - wall_narrowing L/(2 pi) sin(2 pi x/L). Without growth."),
             number(&S::growth, "growth", dimension::plain, between(1, 1.3),
                    "Width of a cell over that of its neighbour nearer to the box of fine_low and fine_high; 1: all "
                    "cells are equal."),
             vector(&S::fine_low, "fine_low", dimension::length, any(),
                    "Low corner of the box with cells of `spacing`, where others grow.")
                 .read_above("growth", 1),
             vector(&S::fine_high, "fine_high", dimension::length, any(), "High corner of that box.")
                 .read_above("growth", 1),
             number_or(&S::coarsest, "coarsest", "none", dimension::length, positive(),
                       "Width up to which cells grow; \"none\": any.")
                 .read_above("growth", 1),
             number(&S::rest_density, "density", dimension::density, positive(), "At rest, without pressure."),
             number(&S::kinematic_viscosity, "kinematic_viscosity", dimension::kinematic_viscosity, non_negative(),
                    "Kinematic viscosity of water."),
             number(&S::air_density, "air_density", dimension::density, positive(),
                    "Density of the air above the water."),
             number(&S::air_viscosity, "air_viscosity", dimension::kinematic_viscosity, non_negative(),
                    "Kinematic viscosity of air."),
             number(&S::surface_tension, "surface_tension", Dimension{0, 1, -2, 0}, non_negative(),
                    "Surface tension between water and air."),
             choice(
                 &S::domain_walls, "domain_walls",
                 {{"slip", SideKind::slip}, {"no_slip", SideKind::no_slip}, {"wall_function", SideKind::wall_function}},
                 "Sides of the domain, where nothing else is said of them: without friction; with the layer of "
                 "water that sticks to them; with the shear of a turbulent layer by the log law."),
             boolean(&S::has_open_top, "open_top",
                     "Air goes in and out through the side against gravity; water leaves through it in splashes alone, "
                     "see `domain`, where no outflow lies on it."),
             choice(&S::turbulence, "turbulence",
                    {{"none", Turbulence::laminar},
                     {"k_epsilon", Turbulence::k_epsilon},
                     {"k_epsilon_stable", Turbulence::k_epsilon_stable}},
                    "Eddies below the size of cells: none; standard k and epsilon; the same, its viscosity limited "
                    "under waves."),
             choice(&S::vof, "vof", {{"plic", VofScheme::plic}, {"compressive", VofScheme::compressive}},
                    "Advection of the surface: by planes in cells, or by compressive fluxes."),
             number(&S::compression, "compression", dimension::plain, between(0, 4),
                    "Strength of the compressive scheme.")
                 .read_with("vof", {"compressive"}),
             integer(&S::outer_corrections, "outer_corrections", 1, 4,
                     "Passes over transport, momentum and pressure in a step; 2: second order in time."),
             integer(
                 &S::pressure_corrections, "pressure_corrections", 1, 4,
                 "Pressures in a pass, each but the first after the explicit momentum has been found again with the "
                 "mean velocity of both ends of the step."),
             boolean(&S::is_carried, "carried",
                     "The water has the velocity of `flow` at all times: it is carried, and nothing acts on it. For "
                     "schemes of the surface; without bodies in the water."),
             choice(&S::coupling, "coupling", {{"two_way", GridCoupling::two_way}, {"one_way", GridCoupling::one_way}},
                    "Water and bodies move each other; or water flows around bodies that stand where they start, and "
                    "bodies feel its pressure there."),
             number(&S::courant, "courant", dimension::plain, above(0, 0.5),
                    "Share of a cell that water crosses in a step, summed over axes."),
             number(&S::tolerance, "tolerance", dimension::plain, above(0, 0.01),
                    "Share of the initial residual of the pressure equation that a solve leaves.")},
        .scene_keys = {"domain", "region", "flow", "side", "wave", "porous", "sponge", "inflow", "outflow"},
        .check = [](const S& s) {
            std::vector<KeyProblem> problems;
            if (s.growth > 1 && !(s.fine_low.x < s.fine_high.x && s.fine_low.y < s.fine_high.y)) {
                problems.push_back({"growth", "cells grow away from a box that is not given",
                                    "fine_low below fine_high, or growth = 1"});
            }
            if (s.growth > 1 && s.wall_narrowing > 0) {
                problems.push_back({"wall_narrowing", "cells that grow away from a box and narrow towards the sides",
                                    "one of growth and wall_narrowing"});
            }
            if (s.coarsest && *s.coarsest < s.spacing) {
                problems.push_back({"coarsest",
                                    fmt::format("coarsest = {} m is below the spacing, {} m", *s.coarsest, s.spacing),
                                    "at least the spacing"});
            }
            return problems;
        }};
}

}  // namespace riprap::coupling
