// SPDX-License-Identifier: Apache-2.0
// Ground: cells under the triangles of a height grid or of a surface.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "riprap/geometry/ground/ground_cells.hpp"
#include "riprap/geometry/ground/height_grid.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"
#include "riprap/geometry/surface/mesh_audit.hpp"
#include "riprap/geometry/surface/mesh_facts.hpp"
#include "riprap/geometry/surface/obj.hpp"
#include "riprap/geometry/surface/stl.hpp"
#include "riprap/io/vtp_surface.hpp"
#include "riprap/scene/case/case_build.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/scene/shapes/shape_library.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"

namespace riprap::scene {

using geometry::HeightGrid;
using geometry::Polyhedron;

namespace {

/// "51 by 51 points 0.5 by 0.5 m apart, 3 without height, the first at (2, 3)"
std::string text_of(const HeightGrid& grid) {
    std::string text =
        fmt::format("{} by {} points {:.6g} by {:.6g} m apart", grid.columns, grid.rows, grid.dx, grid.dy);
    const auto is_missing = [](double z) { return !std::isfinite(z); };
    const auto first = std::find_if(grid.z.begin(), grid.z.end(), is_missing);
    if (first == grid.z.end()) {
        return text + ", all with a height";
    }
    const auto n = static_cast<std::int64_t>(first - grid.z.begin());
    return text + fmt::format(", {} without height, the first at ({:.9g}, {:.9g}): no ground in the cells around them",
                              std::count_if(first, grid.z.end(), is_missing),
                              grid.x0 + grid.dx * static_cast<double>(n % grid.columns),
                              grid.y0 + grid.dy * static_cast<double>(n / grid.columns));
}

/// Holds what the case says of heights that stand for none.
geometry::NoHeight no_height_of(const Value& table) {
    const Value* nodata = table.find("nodata");
    if (nodata == nullptr) {
        return {};
    }
    return nodata->text == "none" ? geometry::NoHeight{{}, true} : geometry::NoHeight{nodata->as_number(), true};
}

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

/// Why a grid was cut to nothing.
Diagnostic problem_of_cut(const HeightGrid& whole, const Value& table) {
    const geometry::Rectangle region = region_of(table.find("region"));
    const double width = std::min(whole.x_end(), region.x_high) - std::max(whole.x0, region.x_low);
    const double depth = std::min(whole.y_end(), region.y_high) - std::max(whole.y0, region.y_low);
    const Value* resolution = table.find("resolution");
    if (!(width > 0 && depth > 0) || resolution == nullptr) {
        return {table.place,
                fmt::format("the region holds no ground: heights go from ({:.9g}, {:.9g}) to ({:.9g}, {:.9g})",
                            whole.x0, whole.y0, whole.x_end(), whole.y_end()),
                "a region that lies within the file"};
    }
    const double step = resolution->as_number();
    return {resolution->place,
            fmt::format("a resolution of {:g} m makes {:.3g} heights of {:.6g} by {:.6g} m", step,
                        (width / step + 1) * (depth / step + 1), width, depth),
            fmt::format("at most {} heights: a coarser resolution or a smaller region", geometry::most_heights)};
}

const SourcePlace& place_of_thickness(const Value& table) {
    const Value* given = table.find("thickness");
    return given != nullptr ? given->place : table.place;
}

/// Sizes of the face of a cell that bodies meet [m].
struct TopSize {
    double longest{0};    ///< of its edges
    double narrowest{0};  ///< of its altitudes
};

TopSize top_of(const Polyhedron& cell) {
    const auto top = static_cast<std::size_t>(std::find(cell.is_internal.begin(), cell.is_internal.end(), 0) -
                                              cell.is_internal.begin());
    const auto& loop = cell.faces[top];
    TopSize size;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3& next = cell.vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
        size.longest = std::max(size.longest, norm(next - cell.vertices[static_cast<std::size_t>(loop[k])]));
    }
    size.narrowest = 2 * norm(geometry::vector_area(cell.vertices, loop)) / size.longest;
    return size;
}

/// Refuses ground whose thickness leaves cells no volume, and takes out those that have none for their triangle: it is
/// so narrow that nothing fits through, or folds sharply.
/// @param place  of its thickness
bool are_sound(std::vector<Polyhedron>& cells, double thickness, const std::string& file, const SourcePlace& place,
               std::vector<Diagnostic>& problems, std::vector<std::string>& warnings) {
    constexpr double narrow = 1e-8;  // of the longest edge: ten times what tells one plane from another
    double longest = 0, narrowest = std::numeric_limits<double>::infinity();
    for (const Polyhedron& cell : cells) {
        const TopSize top = top_of(cell);
        longest = std::max(longest, top.longest);
        narrowest = top.narrowest < narrow * top.longest ? narrowest : std::min(narrowest, top.narrowest);
    }
    const double least = geometry::safe_slenderness * longest;
    const double most = std::max(longest, narrowest / geometry::safe_slenderness);
    const bool is_in_range = longest >= geometry::least_extent && longest <= geometry::most_extent;
    const bool is_thickness_good = is_in_range && thickness >= least && thickness <= most;
    std::optional<geometry::GeometryProblem> problem;
    const std::size_t before = cells.size();
    std::erase_if(cells, [&](const Polyhedron& cell) {
        const auto found = geometry::part_problem(cell, false);
        const TopSize top = found ? top_of(cell) : TopSize{};
        if (found && is_in_range && (is_thickness_good || top.narrowest < narrow * top.longest)) {
            return true;
        }
        problem = problem ? problem : found;
        return false;
    });
    if (before > cells.size()) {
        warnings.push_back(fmt::format(
            "{}: {} of {} triangles are so narrow, or fold so sharply, that the solid under them has no volume in "
            "double precision: they are left out",
            file, before - cells.size(), before));
    }
    if (problem && is_in_range) {
        problems.push_back(
            {place, fmt::format("ground {:.3g} m thick under triangles up to {:.3g} m long", thickness, longest),
             fmt::format("a thickness from {:.3g} to {:.3g} m, for solids that double precision tells from planes",
                         least, most)});
    } else if (problem) {
        problems.push_back({place, problem->message, problem->allowed});
    }
    return !problem;
}

/// Refuses ground of which nothing is left.
bool has_ground(const std::vector<Polyhedron>& cells, const geometry::TriangleMesh& mesh, double thickness,
                const SourcePlace& place, std::vector<Diagnostic>& problems) {
    if (!cells.empty()) {
        return true;
    }
    const auto [low, high] = geometry::box_of(mesh.points);
    const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    problems.push_back(
        {place,
         fmt::format("nothing is left of ground {:.3g} m thick under a mesh {:.3g} m in extent", thickness, size),
         fmt::format("a thickness of, say, {:.3g} m", 1e-3 * size)});
    return false;
}

/// The place of a point of the profile, or of the profile where points have none.
const SourcePlace& place_of_point(const Value& table, std::size_t point) {
    const Value& profile = get(table, "profile");
    const SourcePlace& own = profile.items[point].place;
    return own.line > 0 ? own : profile.place.line > 0 ? profile.place : table.place;
}

/// Names what makes the solid under one piece of a profile thin: its points, or else its thickness.
/// @param end  number of the point at its right end
Diagnostic thin_profile(const Value& table, const Vec3& a, const Vec3& b, std::size_t end, double thickness) {
    constexpr double longest = 1 / geometry::safe_slenderness;  // a planar scene is a metre wide
    const double width = b.x - a.x, rise = std::abs(b.y - a.y);
    const SourcePlace& point = place_of_point(table, end);
    if (std::max(width, rise) > longest * std::max(1.0, std::min(width, 1.0))) {
        return {point, fmt::format("the profile goes from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m", a.x, a.y, b.x, b.y),
                fmt::format("steps of at most {:g} m along x and in height", longest)};
    }
    if (width < geometry::safe_slenderness * std::max(1.0, rise)) {
        return {point,
                fmt::format("the profile goes from ({:.16g}, {:.6g}) to ({:.16g}, {:.6g}) m, {:.3g} m along x: the "
                            "solid below is so thin that double precision cannot tell it from a plane",
                            a.x, a.y, b.x, b.y, width),
                fmt::format("points at least {:.3g} m apart along x",
                            geometry::safe_slenderness * std::max({1.0, rise, std::min(thickness, longest)}))};
    }
    return {place_of_thickness(table),
            fmt::format("ground {:.3g} m thick under {:.3g} m of a profile", thickness, width),
            fmt::format("a thickness from {:.3g} to {:.3g} m",
                        geometry::safe_slenderness * std::max({1.0, rise, width}), std::max(1.0, width))};
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

ShapePieces ShapeLibrary::make_profile(const Value& table) {
    std::vector<Vec3> line;
    for (const Value& point : get(table, "profile").items) {
        line.push_back({point.items[0].as_number(), point.items[1].as_number(), 0});
        if (line.size() > 1 && !(line.back().x > line[line.size() - 2].x)) {
            problems_.push_back({place_of_point(table, line.size() - 1),
                                 "the points of the profile do not go from left to right", "growing x"});
            return std::nullopt;
        }
    }
    const double mean = (line.back().x - line.front().x) / static_cast<double>(line.size() - 1);
    const double thickness = get_number_or(table, "thickness", default_thickness * mean);
    auto cells = geometry::cells_under_line(line, thickness);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (geometry::part_problem(cells[i], true)) {
            problems_.push_back(thin_profile(table, line[i], line[i + 1], i + 1, thickness));
            return std::nullopt;
        }
    }
    return cells;
}

ShapePieces ShapeLibrary::make_terrain(const Value& table) {
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
        const geometry::TableForm form = form_of(columns_of_places(), geometry::most_heights, unit);
        grid = ends_with(path->text, ".asc") || geometry::is_esri_ascii(*bytes)
                   ? geometry::read_esri_ascii(*bytes, path->text, unit, no_height_of(table))
                   : geometry::read_xyz(*bytes, path->text, unit, &form, no_height_of(table));
    } catch (const CaseError& error) {
        add_problems_of(error, path->place, problems_);
        return std::nullopt;
    }
    for (const std::string& note : grid.notes) {
        notes_.push_back(fmt::format("{}: {}", path->text, note));
    }
    const HeightGrid whole = std::move(grid);
    grid = geometry::cut_grid(whole, region_of(table.find("region")), get_number_or(table, "resolution", 0));
    if (grid.z.empty()) {
        problems_.push_back(problem_of_cut(whole, table));
        return std::nullopt;
    }
    // A run says what bodies fall through; the note of a grid without holes is for `check`.
    const bool is_whole = std::all_of(grid.z.begin(), grid.z.end(), [](double z) { return std::isfinite(z); });
    (is_whole ? notes_ : warnings_).push_back(fmt::format("{}: {}", path->text, text_of(grid)));
    const geometry::TriangleMesh mesh = geometry::mesh_of(grid, get_vector(table, "origin"));
    if (!are_few_enough(mesh.size(), table.place, problems_)) {
        return std::nullopt;
    }
    const double thickness = get_number_or(table, "thickness", default_thickness * std::max(grid.dx, grid.dy));
    auto cells = ground_of(mesh, path->text, std::numeric_limits<double>::epsilon(), thickness, Vec3{0, 0, -1});
    if (!are_sound(cells, thickness, path->text, place_of_thickness(table), problems_, warnings_) ||
        !has_ground(cells, mesh, thickness, place_of_thickness(table), problems_)) {
        return std::nullopt;
    }
    return cells;
}

ShapePieces ShapeLibrary::make_mesh(const Value& table) {
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
    geometry::TriangleMesh mesh = geometry::mesh_of(*surface);
    if (!are_few_enough(mesh.size(), table.place, problems_)) {
        return std::nullopt;
    }
    const std::int64_t with_area = mesh.size();
    const geometry::MeshAudit audit = geometry::audit_mesh(mesh, *surface);
    for (const std::string& warning : audit.warnings) {
        warnings_.push_back(fmt::format("{}: {}", path.text, warning));
    }
    if (!audit.problems.empty()) {
        add_problems_of(CaseError(audit.problems), path.place, problems_);
        return std::nullopt;
    }
    std::size_t fans = 0;
    for (std::size_t f = 0; f < surface->face_count(); ++f) {
        fans += surface->face(f).size() - 2;
    }
    if (const auto left = static_cast<std::int64_t>(fans) - with_area; left > 0) {
        warnings_.push_back(fmt::format("{}: {} of {} triangles have no area and are left out", path.text, left, fans));
    }
    const double epsilon =
        surface->grain > 0 ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
    const double thickness = get_number(table, "thickness");
    auto cells = ground_of(mesh, path.text, epsilon, thickness, std::nullopt);
    if (!are_sound(cells, thickness, path.text, place_of_thickness(table), problems_, warnings_) ||
        !has_ground(cells, mesh, thickness, place_of_thickness(table), problems_)) {
        return std::nullopt;
    }
    return cells;
}

std::vector<Polyhedron> ShapeLibrary::ground_of(geometry::TriangleMesh mesh, const std::string& file, double epsilon,
                                                double thickness, const std::optional<Vec3>& down) {
    const geometry::MeshFacts facts = geometry::facts_of(mesh, {0, 0, 1});
    notes_.push_back(fmt::format("{}: {}", file, geometry::text_of(facts)));
    constexpr double most_steep = 0.5;
    if (down && facts.steep_share > most_steep) {  // of a height grid, which has no walls
        warnings_.push_back(
            fmt::format("{}: {:.0f} % of the ground is steeper than 80 degrees: are x and y in another unit than z, "
                        "such as degrees "
                        "or kilometres? 'units' is that of all three",
                        file, 100 * facts.steep_share));
    }
    const bool is_double = epsilon == std::numeric_limits<double>::epsilon();
    notes_.push_back(
        fmt::format("{}: {}", file,
                    geometry::precision_text(facts.low, facts.high, epsilon,
                                             is_double ? "double precision" : "the file's single precision")));
    if (geometry::is_far(facts.low, facts.high)) {
        origin_ = facts.low;
        for (Vec3& x : mesh.points) {
            x -= origin_;
        }
    }
    auto cells = geometry::cells_under(mesh, thickness, down);
    const auto is_lost = [](const Polyhedron& cell) { return cell.faces.empty(); };
    const auto lost = std::find_if(cells.begin(), cells.end(), is_lost);
    if (lost != cells.end()) {
        const auto t = static_cast<std::int32_t>(lost - cells.begin());
        const Vec3 x = origin_ + (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        warnings_.push_back(fmt::format(
            "{}: {} of {} triangles, the first at ({:.9g}, {:.9g}, {:.6g}), fold so sharply that nothing of "
            "the solid under them is left: bodies pass through them; a smaller 'thickness' helps",
            file, std::count_if(cells.begin(), cells.end(), is_lost), cells.size(), x.x, x.y, x.z));
        std::erase_if(cells, is_lost);
    }
    return cells;
}

}  // namespace riprap::scene
