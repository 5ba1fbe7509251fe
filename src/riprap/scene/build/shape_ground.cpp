// SPDX-License-Identifier: Apache-2.0
// Ground: cells under the triangles of a height grid or of a surface.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "riprap/geometry/ground_cells.hpp"
#include "riprap/geometry/height_grid.hpp"
#include "riprap/geometry/obj.hpp"
#include "riprap/geometry/stl.hpp"
#include "riprap/io/vtp_surface.hpp"
#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/build/shape_library.hpp"
#include "riprap/scene/keys/limits.hpp"
#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

using geometry::HeightGrid;
using geometry::Polyhedron;

namespace {

/// Intervals that the solid is thick where the case does not say.
constexpr double default_thickness = 2;

bool ends_with(std::string_view path, std::string_view ending) {
    const auto is_same = [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); };
    return path.size() >= ending.size() &&
           std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()), is_same);
}

geometry::Rectangle region_of(const Value* corners) {
    if (corners == nullptr) {
        return {};
    }
    const auto& low = corners->items[0].items;
    const auto& high = corners->items[1].items;
    return {low[0].as_number(), low[1].as_number(), high[0].as_number(), high[1].as_number()};
}

bool are_few_enough(std::int64_t cells, const SourcePlace& place, std::vector<Diagnostic>& problems) {
    if (cells > 0 && cells <= limits::ground_cells) {
        return true;
    }
    problems.push_back(
        {place, cells == 0 ? "there is no triangle of ground" : fmt::format("ground of {} triangles", cells),
         cells == 0 ? "a region that lies within the file, with at least three heights side by side"
                    : fmt::format("at most {}: use a smaller region or a coarser resolution", limits::ground_cells)});
    return false;
}

}  // namespace

std::optional<std::vector<Polyhedron>> ShapeLibrary::make_profile(const Value& table) {
    std::vector<Vec3> line;
    for (const Value& point : get(table, "profile").items) {
        line.push_back({point.items[0].as_number(), point.items[1].as_number(), 0});
        if (line.size() > 1 && !(line.back().x > line[line.size() - 2].x)) {
            problems_.push_back({point.place, "the points of the profile do not go from left to right", "growing x"});
            return std::nullopt;
        }
    }
    const double mean = (line.back().x - line.front().x) / static_cast<double>(line.size() - 1);
    return geometry::cells_under_line(line, get_number_or(table, "thickness", default_thickness * mean));
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::make_terrain(const Value& table) {
    const Value* path = table.find("file");
    if ((path == nullptr) != is_planar_) {
        problems_.push_back({table.place, is_planar_ ? "terrain of a planar scene is a line" : "a profile is planar",
                             is_planar_ ? "profile = [[x, y], ...]" : "file = ... of heights, or dimension = 2"});
        return std::nullopt;
    }
    if (is_planar_) {
        return make_profile(table);
    }
    const auto bytes = files_.read(path->text, limits::surface_bytes, path->place, problems_);
    if (!bytes) {
        return std::nullopt;
    }
    HeightGrid grid;
    try {
        const double unit = get_word(table, "units", length_units());
        grid = ends_with(path->text, ".asc") ? geometry::read_esri_ascii(*bytes, path->text, unit)
                                             : geometry::read_xyz(*bytes, path->text, unit);
    } catch (const CaseError& error) {
        problems_.insert(problems_.end(), error.problems().begin(), error.problems().end());
        return std::nullopt;
    }
    grid = geometry::cut_grid(grid, region_of(table.find("region")), get_number_or(table, "resolution", 0));
    const geometry::TriangleMesh mesh = geometry::mesh_of(grid, get_vector(table, "origin"));
    if (!are_few_enough(mesh.size(), table.place, problems_)) {
        return std::nullopt;
    }
    const double thickness = get_number_or(table, "thickness", default_thickness * std::max(grid.dx, grid.dy));
    return geometry::cells_under(mesh, thickness, Vec3{0, 0, -1});
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::make_mesh(const Value& table) {
    const Value& path = get(table, "file");
    const SurfaceReader reader = ends_with(path.text, ".stl")   ? geometry::read_stl
                                 : ends_with(path.text, ".obj") ? geometry::read_obj
                                 : ends_with(path.text, ".vtp") ? io::read_vtp_surface
                                                                : nullptr;
    if (is_planar_ || reader == nullptr) {
        problems_.push_back({path.place,
                             is_planar_ ? "a mesh cannot stand in a planar scene" : "neither an STL, OBJ nor VTP file",
                             is_planar_ ? "terrain = { profile = ... }" : "a name that ends in .stl, .obj or .vtp"});
        return std::nullopt;
    }
    const auto surface = read_surface(table, reader);
    if (!surface) {
        return std::nullopt;
    }
    const geometry::TriangleMesh mesh = geometry::mesh_of(*surface);
    if (!are_few_enough(mesh.size(), table.place, problems_)) {
        return std::nullopt;
    }
    auto cells = geometry::cells_under(mesh, get_number(table, "thickness"), std::nullopt);
    std::erase_if(cells, [](const Polyhedron& cell) { return cell.faces.empty(); });
    return cells;
}

}  // namespace riprap::scene
