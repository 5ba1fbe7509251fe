// SPDX-License-Identifier: Apache-2.0
// The grid that a case asks for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

/// A domain longer than so many cells along an axis is refused, and so are more cells in all.
constexpr double most_cells = 2e8;

/// Widths of cells from a place of the fine box outwards over `length`, the last ones scaled to end there.
std::vector<double> growing_widths(double length, double spacing, double growth, double coarsest) {
    std::vector<double> widths;
    double sum = 0, width = spacing;
    while (sum < length * (1 - 1e-9)) {
        width = std::min(width * growth, coarsest);
        widths.push_back(width);
        sum += width;
    }
    for (double& w : widths) {
        w *= length / sum;
    }
    return widths;
}

/// Faces of cells that are narrower beside both ends, by a share of their mean width.
std::vector<double> narrowing_edges(double low, double high, double spacing, double share) {
    const int cells = std::max(1, static_cast<int>(std::lround((high - low) / spacing)));
    std::vector<double> edges{low};
    for (int i = 1; i < cells; ++i) {
        const double turn = 2 * M_PI * i / cells;
        edges.push_back(low + (high - low) * (static_cast<double>(i) / cells - share / (2 * M_PI) * std::sin(turn)));
    }
    edges.push_back(high);
    return edges;
}

/// Faces of cells along an axis: equal cells in the fine box, growing ones beyond.
/// @param spacing  width of a cell of the fine box along the axis [m]
std::vector<double> edges_along(const GridFluidSettings& settings, double spacing, double low, double high,
                                double fine_low, double fine_high) {
    if (settings.wall_narrowing > 0) {
        return narrowing_edges(low, high, spacing, settings.wall_narrowing);
    }
    const double coarsest = settings.coarsest.value_or(1e300) * (spacing / settings.spacing);
    const bool grows = settings.growth > 1;
    const double from = grows ? std::clamp(fine_low, low, high) : low,
                 to = grows ? std::clamp(fine_high, low, high) : high;
    std::vector<double> edges{low};
    std::vector<double> before = growing_widths(from - low, spacing, settings.growth, coarsest);
    std::reverse(before.begin(), before.end());
    for (const double width : before) {
        edges.push_back(edges.back() + width);
    }
    edges.back() = from;
    const int cells = to > from ? std::max(1, static_cast<int>(std::lround((to - from) / spacing))) : 0;
    for (int i = 1; i <= cells; ++i) {
        edges.push_back(from + (to - from) * i / cells);
    }
    for (const double width : growing_widths(high - to, spacing, settings.growth, coarsest)) {
        edges.push_back(edges.back() + width);
    }
    edges.back() = high;
    return edges;
}

}  // namespace

std::string_view entry_key(std::string_view list, std::size_t entry) {
    static std::mutex guard;
    static std::set<std::string> keys;  // whose entries stay where they are
    const std::scoped_lock lock(guard);
    return *keys.insert(fmt::format("{}[{}]", list, entry)).first;
}

std::string cells_text(const GridFluidSettings& settings) {
    const fluid::grid::Mesh& mesh = settings.grid.mesh;
    if (mesh.edge[0].empty()) {
        return {};
    }
    const auto& cells = mesh.box.cells;
    return fmt::format("{} x {}{} cells, the narrowest {:.4g} m wide", cells[0], cells[1],
                       mesh.box.axes == 3 ? fmt::format(" x {}", cells[2]) : "", mesh.smallest_width());
}

std::vector<KeyProblem> GridFluidSettings::prepare(const FieldScene& given) {
    std::vector<KeyProblem> problems;
    scene = given;
    const fluid::Domain& domain = scene.domain;
    double cells = 1;
    for (int a = 0; a < domain.dimension; ++a) {
        const double length = domain.high[a] - domain.low[a], width = stretch[a] * spacing;
        cells *= growth > 1 ? 1 : length / width;
        if (domain.is_periodic[at(a)]) {
            problems.push_back({"domain", "a periodic domain with method = \"grid\"", "walls or an open top"});
        }
        if (length < 4 * width) {
            problems.push_back({"spacing",
                                fmt::format("the domain is {:.4g} m long along {}, {:.3g} cells of {:.4g} m", length,
                                            "xyz"[a], length / width, width),
                                "four cells at least: a smaller spacing or a larger domain"});
        }
    }
    if (cells > most_cells) {
        problems.push_back(
            {"spacing", fmt::format("{:.3g} cells", cells),
             fmt::format("at most {:.3g}: a larger spacing, a smaller domain or growing cells", most_cells)});
    }
    if (!problems.empty()) {
        return problems;
    }
    std::array<std::vector<double>, 3> edges{};
    for (int a = 0; a < 3; ++a) {
        edges[at(a)] = a < domain.dimension ? edges_along(*this, stretch[a] * spacing, domain.low[a], domain.high[a],
                                                          fine_low[a], fine_high[a])
                                            : std::vector<double>{-0.5, 0.5};
    }
    grid.mesh = fluid::grid::Mesh(edges, domain.dimension);
    grid.water = {rest_density, kinematic_viscosity};
    grid.air = {air_density, air_viscosity};
    grid.gravity = scene.gravity.at(0);
    if (scene.gravity.changes()) {
        grid.full_gravity = norm(scene.gravity.value);
        grid.frame_acceleration = [gravity = scene.gravity, at_start = grid.gravity](double time) {
            return gravity.at(time) - at_start;
        };
    }
    grid.surface_tension = surface_tension;
    for (fluid::grid::Side& side : grid.side) {
        side.kind = domain_walls;
    }
    if (has_open_top) {
        const int axis = up_axis(scene.up);
        fluid::grid::Side& top = grid.side[at(2 * axis + (scene.up[axis] > 0 ? 1 : 0))];
        top.kind = fluid::grid::SideKind::open;
        top.is_for_air = true;
    }
    grid.turbulence = turbulence;
    grid.vof = vof;
    grid.compression = compression;
    grid.outer_corrections = outer_corrections;
    grid.pressure_corrections = pressure_corrections;
    grid.courant = courant;
    grid.tolerance = tolerance;
    problems = add_sides(*this);
    for (KeyProblem& problem : add_waves(*this)) {
        problems.push_back(std::move(problem));
    }
    for (const auto add : {add_openings, add_zones}) {
        for (KeyProblem& problem : add(*this)) {
            problems.push_back(std::move(problem));
        }
    }
    return problems;
}

}  // namespace riprap::coupling
