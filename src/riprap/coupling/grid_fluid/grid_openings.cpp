// SPDX-License-Identifier: Apache-2.0
// Sides of the domain that water enters and leaves through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::Inflow;
using fluid::grid::Mesh;
using fluid::grid::Side;
using fluid::grid::SideKind;
using Kind = OpenSide::Kind;

bool is_given(Kind kind) { return kind == Kind::inflow || kind == Kind::drawn; }

/// Share of a cell that an opening covers, by the extent of both across the side [-].
double covered(const Mesh& mesh, const OpenSide& opening, const Vec3& place, int except) {
    double share = 1;
    for (int a = 0; a < mesh.box.axes; ++a) {
        if (a != opening.side / 2 && a != except) {
            const int p = mesh.cell_at(a, place[a]);
            const double low = mesh.edge[at(a)][at(p)], high = mesh.edge[at(a)][at(p + 1)];
            share *= std::max(0.0, std::min(high, opening.high[a]) - std::max(low, opening.low[a])) / (high - low);
        }
    }
    return share;
}

/// Velocity and water of all openings with a given speed on a side; a wall beside them.
Inflow flow_at(const Mesh& mesh, const std::vector<OpenSide>& openings, int up, const Vec3& place, double time) {
    Inflow in{{}, 0, true};
    for (const OpenSide& opening : openings) {
        double share = covered(mesh, opening, place, -1);
        if (share <= 0) {
            continue;
        }
        const int p = mesh.cell_at(up, place[up]);
        const double low = std::max(mesh.edge[at(up)][at(p)], opening.low[up]);
        const double high = std::min(mesh.edge[at(up)][at(p + 1)], opening.high[up]);
        const double wet = std::clamp((opening.level - low) / (high - low), 0.0, 1.0);
        const double growth =
            opening.ramp > 0 && time < opening.ramp ? 0.5 * (1 - std::cos(M_PI * time / opening.ramp)) : 1;
        const double inward = opening.side % 2 == 0 ? 1 : -1;
        const bool is_drawn = opening.kind == Kind::drawn;
        in.is_closed = false;
        in.is_drawn = in.is_drawn || is_drawn;
        in.fraction = is_drawn ? in.fraction : std::max(in.fraction, wet);
        in.velocity[opening.side / 2] += (is_drawn ? -inward : inward * wet) * share * growth * opening.speed;
    }
    return in;
}

/// Says what is wrong with the place of an opening; empty where nothing is.
std::string misplaced(const GridFluidSettings& settings, const OpenSide& opening) {
    const fluid::Domain& domain = settings.scene.domain;
    const int axis = opening.side / 2;
    const double plane = opening.side % 2 == 0 ? domain.low[axis] : domain.high[axis];
    if (std::abs(opening.low[axis] - plane) > 0.5 * settings.spacing) {
        return fmt::format("an opening at {} = {:.6g} m, where the domain ends at {:.6g} m", "xyz"[axis],
                           opening.low[axis], plane);
    }
    for (int a = 0; a < domain.dimension && !is_given(opening.kind); ++a) {
        if (a != axis && (opening.low[a] > domain.low[a] || opening.high[a] < domain.high[a])) {
            return fmt::format("an outflow without a speed from {:.6g} m to {:.6g} m along {}, a part of its side",
                               opening.low[a], opening.high[a], "xyz"[a]);
        }
    }
    return "";
}

}  // namespace

std::vector<KeyProblem> add_openings(GridFluidSettings& settings) {
    std::vector<KeyProblem> problems;
    const int up = up_axis(settings.scene.up);
    std::array<std::vector<OpenSide>, 6> given;
    std::size_t inflows = 0, outflows = 0;
    for (const OpenSide& opening : settings.scene.openings) {
        const std::string_view key =
            opening.kind == Kind::inflow ? entry_key("inflow", inflows++) : entry_key("outflow", outflows++);
        Side& side = settings.grid.side[at(opening.side)];
        if (std::string problem = misplaced(settings, opening); !problem.empty()) {
            problems.push_back({key, problem,
                                "a side of the domain; the whole of it, with bodies before what is to be closed, or a "
                                "'speed'"});
            continue;
        }
        if (side.is_for_air && opening.kind == Kind::free) {
            side.is_for_air = false;  // the open top, water may leave through it too
            continue;
        }
        if (side.kind == SideKind::inflow || side.kind == SideKind::open) {
            problems.push_back(
                {key, "an opening in a side that is open already or that waves come in through", "another side"});
            continue;
        }
        if (is_given(opening.kind)) {
            given[at(opening.side)].push_back(opening);
            continue;
        }
        side.kind = SideKind::open;
        if (opening.kind == Kind::level) {
            side.still_level = opening.level;
            side.up = up;
            const double top = settings.grid.mesh.edge[at(up)].back();
            side.pressure = norm(settings.grid.gravity) * settings.air_density * (top - opening.level);
        }
    }
    for (int s = 0; s < 2 * settings.scene.domain.dimension; ++s) {
        if (!given[at(s)].empty()) {
            settings.grid.side[at(s)].kind = SideKind::inflow;
            settings.grid.side[at(s)].inflow = [mesh = settings.grid.mesh, openings = given[at(s)], up](
                                                   const Vec3& place, double time) {
                return flow_at(mesh, openings, up, place, time);
            };
        }
    }
    return problems;
}

}  // namespace riprap::coupling
