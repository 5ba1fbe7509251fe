// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>

#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/geometry/surface/surface_mesh.hpp"

namespace riprap::geometry {

namespace {

using Loop = std::vector<std::int32_t>;

/// Points seen so far, in cells of eight tolerances: a point and those within the tolerance are in at most eight cells.
class PointGrid {
 public:
    PointGrid(const Vec3& origin, double tolerance) : origin_(origin), tolerance_(tolerance), cell_(8.0 * tolerance) {}

    /// The first point within the tolerance of x, or x as a new one.
    std::int32_t find_or_add(const Vec3& x, std::vector<Vec3>& points) {
        std::int32_t found = -1;
        const auto low = cell_of(x - Vec3{tolerance_, tolerance_, tolerance_});
        const auto high = cell_of(x + Vec3{tolerance_, tolerance_, tolerance_});
        for (std::int64_t i = low[0]; i <= high[0]; ++i) {
            for (std::int64_t j = low[1]; j <= high[1]; ++j) {
                for (std::int64_t k = low[2]; k <= high[2]; ++k) {
                    found = earlier(found, find_in_cell(key(i, j, k), x, points));
                }
            }
        }
        if (found < 0) {
            found = static_cast<std::int32_t>(points.size());
            points.push_back(x);
            const auto at = cell_of(x);
            const auto [entry, is_new] = first_in_cell_.try_emplace(key(at[0], at[1], at[2]), found);
            next_in_cell_.push_back(is_new ? -1 : std::exchange(entry->second, found));
        }
        return found;
    }

 private:
    static std::int32_t earlier(std::int32_t a, std::int32_t b) { return a < 0 || (b >= 0 && b < a) ? b : a; }

    std::array<std::int64_t, 3> cell_of(const Vec3& x) const {
        const Vec3 at = (x - origin_) / cell_;
        return {static_cast<std::int64_t>(std::floor(at.x)), static_cast<std::int64_t>(std::floor(at.y)),
                static_cast<std::int64_t>(std::floor(at.z))};
    }
    /// Distances are compared as well, so cells that share a key only cost time.
    static std::uint64_t key(std::int64_t i, std::int64_t j, std::int64_t k) {
        constexpr std::uint64_t mask = (1U << 21U) - 1U;
        return (static_cast<std::uint64_t>(i) & mask) << 42U | (static_cast<std::uint64_t>(j) & mask) << 21U |
               (static_cast<std::uint64_t>(k) & mask);
    }
    std::int32_t find_in_cell(std::uint64_t cell, const Vec3& x, const std::vector<Vec3>& points) const {
        std::int32_t found = -1;
        const auto entry = first_in_cell_.find(cell);
        for (std::int32_t p = entry == first_in_cell_.end() ? -1 : entry->second; p >= 0;
             p = next_in_cell_[static_cast<std::size_t>(p)]) {
            if (norm_squared(points[static_cast<std::size_t>(p)] - x) <= tolerance_ * tolerance_) {
                found = p;  // later links are earlier points
            }
        }
        return found;
    }

    Vec3 origin_;
    double tolerance_;
    double cell_;
    std::unordered_map<std::uint64_t, std::int32_t> first_in_cell_;
    std::vector<std::int32_t> next_in_cell_;
};

/// Reports what is wrong with one polygon by itself; true if it can be kept.
bool is_sound(const SurfaceMesh& mesh, const Loop& loop, std::size_t source_face, ProblemList& problems) {
    const Surface& surface = *mesh.source;
    const auto refuse_face = [&](const std::string& what, const char* allowed) {
        problems.add(surface.place_of(source_face), surface.name_of(source_face) + ' ' + what, allowed);
        return false;
    };
    Loop sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        return refuse_face("passes twice through the vertex at " +
                               coordinates(mesh.point(*std::adjacent_find(sorted.begin(), sorted.end()))),
                           "every corner of a face once");
    }
    std::vector<Vec3> corners;
    corners.reserve(loop.size());
    for (const std::int32_t p : loop) {
        corners.push_back(mesh.point(p));
    }
    const double area = norm(vector_area(mesh.points, loop));
    if (2.0 * area <= mesh.tolerance * length_scale(corners)) {
        return refuse_face(fmt::format("has zero area ({:.3g} m^2) at {}", area, coordinates(corners.front())),
                           "faces thicker than the weld tolerance; remove the face or join its corners");
    }
    const Plane plane = face_plane(mesh.points, loop);
    for (const Vec3& x : corners) {
        const double height = dot(plane.normal, x) - plane.offset;
        if (std::abs(height) > mesh.tolerance) {
            return refuse_face(fmt::format("is not flat: the corner at {} is {:.3g} m off its plane", coordinates(x),
                                           std::abs(height)),
                               "flat faces; split it into triangles");
        }
    }
    return true;
}

/// Drops corners that repeat the one before.
Loop without_repeats(const Loop& corners) {
    Loop loop;
    for (const std::int32_t p : corners) {
        if (loop.empty() || loop.back() != p) {
            loop.push_back(p);
        }
    }
    while (loop.size() > 1 && loop.front() == loop.back()) {
        loop.pop_back();
    }
    return loop;
}

/// The loop started at its lowest point: equal for faces that have the same corners in the same order.
Loop canonical(Loop loop) {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    return loop;
}

void report_flat(const SurfaceMesh& mesh, ProblemList& problems) {
    std::size_t widest = 0;
    double area = -1.0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const double a = norm_squared(vector_area(mesh.points, mesh.faces[f]));
        if (a > area) {
            area = a;
            widest = f;
        }
    }
    const Plane plane = face_plane(mesh.points, mesh.faces[widest]);
    const bool is_flat = std::all_of(mesh.points.begin(), mesh.points.end(), [&](const Vec3& x) {
        return std::abs(dot(plane.normal, x) - plane.offset) <= mesh.tolerance;
    });
    if (is_flat) {
        problems.add(
            mesh.place_of(widest),
            fmt::format("all vertices lie in one plane, that of {}; the surface has no volume", mesh.name_of(widest)),
            "a closed surface around a volume");
    }
}

}  // namespace

SurfaceMesh weld_surface(const Surface& surface, const SurfaceAuditOptions& options, ProblemList& problems,
                         std::vector<Diagnostic>& notes) {
    SurfaceMesh mesh{&surface, 0.0, {}, {}, {}};
    Vec3 low, high;
    for (std::size_t i = 0; i < surface.face_vertex.size(); ++i) {
        const Vec3& x = surface.vertices[static_cast<std::size_t>(surface.face_vertex[i])];
        low = i == 0 ? x : min(low, x);
        high = i == 0 ? x : max(high, x);
    }
    const double diagonal = norm(high - low);
    constexpr double smallest_diagonal = 1e-9;  // [m]; volumes of anything smaller drown in the range of a double
    if (!(diagonal >= smallest_diagonal) || !(options.weld_tolerance >= 1e-9 && options.weld_tolerance <= 1e-2)) {
        problems.add(surface.file,
                     fmt::format("the surface is {:.3g} m long, the weld tolerance {:g} of it", diagonal,
                                 options.weld_tolerance),
                     fmt::format("at least {:g} m, and 1e-9 to 0.01", smallest_diagonal));
        return mesh;
    }
    mesh.tolerance = options.weld_tolerance * diagonal;

    std::vector<std::int32_t> point_of(surface.vertices.size(), -1);
    PointGrid grid(low, mesh.tolerance);
    constexpr double round_off = 1e-12;  // boxes in decimals that meet are not worth a word
    std::size_t moved_count = 0;
    for (const std::int32_t vertex : surface.face_vertex) {
        auto& point = point_of[static_cast<std::size_t>(vertex)];
        if (point < 0) {
            const Vec3& x = surface.vertices[static_cast<std::size_t>(vertex)];
            point = grid.find_or_add(x, mesh.points);
            moved_count += norm(mesh.point(point) - x) > round_off * (diagonal + norm(x)) ? 1 : 0;
        }
    }

    std::map<Loop, std::size_t> seen;
    std::size_t duplicate_count = 0, collapsed_count = 0, first_duplicate = 0, first_collapsed = 0;
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
        Loop corners;
        for (const std::int32_t vertex : surface.face(f)) {
            corners.push_back(point_of[static_cast<std::size_t>(vertex)]);
        }
        Loop loop = without_repeats(corners);
        if (loop.size() < 3) {
            if (collapsed_count++ == 0) {
                first_collapsed = f;
            }
            if (!options.drop_collapsed) {
                problems.add(surface.place_of(f),
                             fmt::format("{} has zero area: its corners coincide at {}", surface.name_of(f),
                                         coordinates(mesh.point(corners.front()))),
                             "at least three corners apart; remove the face");
            }
            continue;
        }
        if (!seen.try_emplace(canonical(loop), f).second) {
            first_duplicate = duplicate_count++ == 0 ? f : first_duplicate;
            continue;
        }
        if (is_sound(mesh, loop, f, problems)) {
            mesh.faces.push_back(std::move(loop));
            mesh.origin.push_back(static_cast<std::int32_t>(f));
        }
    }
    const auto note = [&](std::size_t f, std::string message) {
        Diagnostic& entry = notes.emplace_back();
        entry.place = surface.place_of(f);
        entry.message = std::move(message);
    };
    if (moved_count > 0) {
        note(0, fmt::format("{} vertices were welded to others within {:.3g} m", moved_count, mesh.tolerance));
    }
    if (duplicate_count > 0) {
        note(first_duplicate, fmt::format("{} faces, the first {}, repeat others and were joined with them",
                                          duplicate_count, surface.name_of(first_duplicate)));
    }
    if (collapsed_count > 0 && options.drop_collapsed) {
        note(first_collapsed, fmt::format("{} faces of zero area, the first {}, were left out", collapsed_count,
                                          surface.name_of(first_collapsed)));
    }
    if (mesh.faces.empty() && problems.is_empty()) {
        problems.add(surface.file, "no face with an area is left", "a closed surface around a volume");
    }
    if (problems.is_empty()) {
        report_flat(mesh, problems);
    }
    return mesh;
}

}  // namespace riprap::geometry
