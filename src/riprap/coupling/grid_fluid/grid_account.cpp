// SPDX-License-Identifier: Apache-2.0
// The account of the water: bodies that press a closed pocket together, or water that has no room left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/coupling/grid_fluid/pocket_pressure.hpp"
#include "riprap/fluid/grid/pockets.hpp"
#include "riprap/fluid/grid/surface.hpp"
#include "riprap/fluid/open/leaving.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::Pocket;

/// A body that moves as it is told does not stop by itself: it may press a pocket together by this [-].
constexpr double most_pressed = 0.03;
/// Sums up what bodies do to a pocket.
struct Squeeze {
    std::int32_t body{-1};  ///< that moves most of it; -1: none
    double rate{0};         ///< volume that this body takes, less what it gives [m^3/s]
    double skin{0};         ///< facets in the pocket, of it or of a free body that has more, times the width of their
                            ///< cells [m^3]: what the pocket loses as that body goes on by a cell
    bool has_free{false};   ///< bodies in it that can follow its water
};

Squeeze squeeze_of(const FluidScene& scene, const fluid::grid::Mesh& mesh, const GridFluid::Scratch& scratch,
                   const Pocket& pocket) {
    std::vector<std::int64_t> cells = pocket.cells;
    std::sort(cells.begin(), cells.end());
    std::vector<double> rate(scratch.bodies.size()), skin(scratch.bodies.size());
    Squeeze most;
    for (const CutFacet& facet : scratch.cut.facets) {
        if (!moves_fluid(facet) || !std::binary_search(cells.begin(), cells.end(), facet.cell)) {
            continue;
        }
        const double moved = dot(scratch.bodies[at(facet.body)].velocity_at(facet.place()), facet.area);
        rate[at(facet.body)] += moved;
        const bool is_free = body::may_move(scene.bodies, at(facet.body));
        most.has_free = most.has_free || is_free;
        for (int a = 0; a < mesh.box.axes && (is_free || moved != 0); ++a) {
            skin[at(facet.body)] += std::abs(facet.area[a]) * mesh.h(a, mesh.cell_at(a, facet.place()[a]));
        }
    }
    double widest = 0;
    for (std::size_t b = 0; b < rate.size(); ++b) {
        if (std::abs(rate[b]) > std::abs(most.rate)) {
            most = {static_cast<std::int32_t>(b), rate[b], skin[b], most.has_free};
        }
        widest = body::may_move(scene.bodies, b) ? std::max(widest, skin[b]) : widest;
    }
    most.skin = std::max(most.skin, widest);
    return most;
}

/// Names a pocket by its middle and its size: "the pocket of 0.42 m^2 around (0.5, 0.21) m".
std::string name_of(const fluid::grid::Mesh& mesh, const fluid::grid::GridScratch& s, const Pocket& pocket) {
    Vec3 middle{};
    double volume = 0;
    for (const std::int64_t c : pocket.cells) {
        const std::array<int, 3> place = fluid::grid::place_of(mesh.box, c);
        middle += s.room.capacity[at(c)] * mesh.centre(place[0], place[1], place[2]);
        volume += s.room.capacity[at(c)];
    }
    middle = middle / volume;
    return mesh.box.axes == 2
               ? fmt::format("the pocket of {:.3g} m^2 around ({:.3g}, {:.3g}) m", volume, middle.x, middle.y)
               : fmt::format("the pocket of {:.3g} m^3 around ({:.3g}, {:.3g}, {:.3g}) m", volume, middle.x, middle.y,
                             middle.z);
}

std::string name_of(const FluidScene& scene, const Squeeze& squeeze) {
    return squeeze.body < 0 ? "bodies" : fmt::format("'{}'", scene.bodies.name(BodyId{squeeze.body}));
}

std::string remedy(const GridFluidSettings& settings) {
    return fmt::format(
        "water that can get away keeps its volume: a gap of {:.4g} m, two cells, or more beside the "
        "body, or a body that stops before",
        2 * settings.spacing);
}

}  // namespace

Outcome pocket_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                       const fluid::grid::GridState& water, const TimeSpan& span) {
    const double least = fluid::share_let_go * water.water.ever;
    for (const Pocket& pocket : scratch.grid.pockets) {
        const double room = room_of(pocket, scratch.grid), fraction = mean_fraction(water, scratch.grid, pocket);
        constexpr double round_off = 1e-6;
        if (!(fraction > 1 - fluid::grid::most_hollow * (1 + round_off)) || !(room > least)) {
            continue;  // air gives way
        }
        const bool is_hollow = fraction < 1 - fluid::grid::most_hollow * (1 - round_off);
        const Squeeze squeeze = squeeze_of(scene, settings.grid.mesh, scratch, pocket);
        if (squeeze.body < 0 || !(room > least_cells * squeeze.skin)) {
            continue;
        }
        const bool is_driven = scene.bodies.drive[at(squeeze.body)] == body::Drive::driven;
        const double most = is_driven ? most_pressed : fluid::grid::most_overfull;
        const std::string name = name_of(settings.grid.mesh, scratch.grid, pocket);
        if (fraction > 1 + most * (1 - share_of_water_missing)) {
            return {fmt::format("{} presses together {} by t = {:.6g} s: it holds {} of water and has room for {}; "
                                "allowed: {:g} % more",
                                name_of(scene, squeeze), name, span.end(), mass_of(settings, fraction * room),
                                mass_of(settings, room), 100 * most),
                    0, remedy(settings)};
        }
        if (is_driven && (is_hollow || !squeeze.has_free) &&
            -squeeze.rate * span.dt > share_of_water_missing * water.water.ever) {
            return {fmt::format("{} draws apart {} at t = {:.6g} s: it is full, and {} of water would come in through "
                                "closed walls in a step",
                                name_of(scene, squeeze), name, span.end(), mass_of(settings, -squeeze.rate * span.dt)),
                    0, remedy(settings)};
        }
    }
    return {};
}

Outcome mass_outcome(const FluidScene& scene, const GridFluidSettings& settings, const GridFluid::Scratch& scratch,
                     const fluid::grid::GridState& water, double time) {
    const double missing = water.water.held - water_volume(settings.grid, water, scratch.grid);
    if (!(std::abs(missing) > share_of_water_missing * water.water.ever)) {
        return {};
    }
    std::string cause = "there is no room left for it in the domain";
    double largest = 0;
    for (const Pocket& pocket : scratch.grid.pockets) {
        const Squeeze squeeze = squeeze_of(scene, settings.grid.mesh, scratch, pocket);
        if (std::abs(squeeze.rate) > largest) {
            largest = std::abs(squeeze.rate);
            cause =
                fmt::format("{} {} {}", name_of(scene, squeeze), squeeze.rate > 0 ? "presses together" : "draws apart",
                            name_of(settings.grid.mesh, scratch.grid, pocket));
        }
    }
    return {fmt::format("{} of water would {} by t = {:.6g} s; allowed: {}, {:g} of all: {}",
                        mass_of(settings, std::abs(missing)), missing > 0 ? "vanish" : "come from nothing", time,
                        mass_of(settings, share_of_water_missing * water.water.ever), share_of_water_missing, cause),
            0, remedy(settings)};
}

}  // namespace riprap::coupling
