// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "riprap/geometry/surface/surface_mesh.hpp"

namespace riprap::geometry {

namespace {

using Loop = std::vector<std::int32_t>;

/// One shell on its way to a convex polyhedron. A region is a group of coplanar faces that will be one polygon.
class PartMaker {
 public:
    PartMaker(const SurfaceMesh& mesh, const ShellSet& set, const std::vector<std::int32_t>& shell,
              ProblemList& problems)
        : mesh_(mesh), set_(set), shell_(shell), problems_(problems) {}

    ConvexPart make() {
        if (!encloses_volume() || !is_turned_outward()) {
            return {};
        }
        group_coplanar_faces();
        ConvexPart result;
        if (!has_no_concave_edge() || !trace_regions(result) || !is_convex_as_a_whole(result)) {
            return {};
        }
        result.part.name =
            mesh_.source->body_names[static_cast<std::size_t>(mesh_.body_of(static_cast<std::size_t>(shell_.front())))];
        result.part.volume = mass_properties(result.part.polyhedron).volume;
        return result;
    }

 private:
    void problem(std::size_t face, std::string message, std::string allowed) {
        problems_.add(mesh_.place_of(face), std::move(message), std::move(allowed));
    }
    std::string shell_name() const {
        return fmt::format("the shell of {} faces that begins with {}", shell_.size(),
                           mesh_.name_of(static_cast<std::size_t>(shell_.front())));
    }

    void measure() {
        const Vec3 o = mesh_.point(mesh_.faces[static_cast<std::size_t>(shell_.front())].front());
        for (const std::int32_t f : shell_) {
            const Loop& loop = mesh_.faces[static_cast<std::size_t>(f)];
            const Vec3 area = vector_area(mesh_.points, loop);
            volume_ += dot(area, mesh_.point(loop.front()) - o) / 3.0;
            area_ += norm(area);
        }
    }

    /// A slab as thin as the weld tolerance t has volume A t / 2, A its area on both sides.
    bool encloses_volume() {
        measure();
        if (std::abs(volume_) > 0.5 * mesh_.tolerance * area_) {
            return true;
        }
        problem(static_cast<std::size_t>(shell_.front()),
                fmt::format("{} encloses no volume ({:.3g} m^3)", shell_name(), volume_),
                "shells thicker than the weld tolerance");
        return false;
    }
    bool is_turned_outward() {
        if (volume_ > 0.0) {
            return true;
        }
        problem(static_cast<std::size_t>(shell_.front()),
                fmt::format("{} is inside out (volume {:.6g} m^3)", shell_name(), volume_),
                "faces wound counter-clockwise seen from outside; hollow bodies are stated as several convex shells");
        return false;
    }

    std::int32_t& region(std::int32_t face) { return region_of_[face]; }
    std::int32_t region_across(std::int32_t h) {
        return region(set_.half_edge_face[static_cast<std::size_t>(set_.twin[static_cast<std::size_t>(h)])]);
    }
    template <class Visit>
    void for_each_half_edge(std::int32_t face, const Visit& visit) const {
        const auto f = static_cast<std::size_t>(face);
        for (std::int32_t h = set_.half_edge_start[f]; h < set_.half_edge_start[f + 1]; ++h) {
            visit(h);
        }
    }
    std::int32_t from(std::int32_t h) const {
        const auto f = static_cast<std::size_t>(set_.half_edge_face[static_cast<std::size_t>(h)]);
        return mesh_.faces[f][static_cast<std::size_t>(h - set_.half_edge_start[f])];
    }
    std::int32_t next(std::int32_t h) const {
        const auto f = static_cast<std::size_t>(set_.half_edge_face[static_cast<std::size_t>(h)]);
        return h + 1 < set_.half_edge_start[f + 1] ? h + 1 : set_.half_edge_start[f];
    }

    bool is_in_plane(std::int32_t face, const Plane& plane) const {
        const Loop& loop = mesh_.faces[static_cast<std::size_t>(face)];
        constexpr double same_direction = 0.99;  // keeps a fold of a thin plate from passing for its other side
        return dot(normalized(vector_area(mesh_.points, loop)), plane.normal) > same_direction &&
               std::all_of(loop.begin(), loop.end(), [&](std::int32_t p) {
                   return std::abs(dot(plane.normal, mesh_.point(p)) - plane.offset) <= mesh_.tolerance;
               });
    }

    /// Grows regions from the largest faces, whose planes are known best.
    void group_coplanar_faces() {
        std::vector<std::pair<double, std::int32_t>> by_area;
        for (const std::int32_t f : shell_) {
            region_of_[f] = -1;
            by_area.emplace_back(-norm_squared(vector_area(mesh_.points, mesh_.faces[static_cast<std::size_t>(f)])), f);
        }
        std::sort(by_area.begin(), by_area.end());
        for (const auto& [minus_area, seed] : by_area) {
            if (region(seed) >= 0) {
                continue;
            }
            const auto number = static_cast<std::int32_t>(planes_.size());
            planes_.push_back(face_plane(mesh_.points, mesh_.faces[static_cast<std::size_t>(seed)]));
            std::vector<std::int32_t> faces{seed};
            region(seed) = number;
            for (std::size_t i = 0; i < faces.size(); ++i) {
                for_each_half_edge(faces[i], [&](std::int32_t h) {
                    const auto t = static_cast<std::size_t>(set_.twin[static_cast<std::size_t>(h)]);
                    const std::int32_t other = set_.half_edge_face[t];
                    if (region(other) < 0 && is_in_plane(other, planes_.back())) {
                        region(other) = number;
                        faces.push_back(other);
                    }
                });
            }
            region_faces_.push_back(std::move(faces));
        }
    }

    /// Names the edge that folds inwards over which the neighbour rises highest above a face.
    bool has_no_concave_edge() {
        double worst = slack();
        std::int32_t worst_edge = -1;
        for (const std::int32_t f : shell_) {
            for_each_half_edge(f, [&](std::int32_t h) {
                const auto t = static_cast<std::size_t>(set_.twin[static_cast<std::size_t>(h)]);
                const std::int32_t other = set_.half_edge_face[t];
                const Plane& plane = planes_[static_cast<std::size_t>(region(f))];
                const Vec3& there = planes_[static_cast<std::size_t>(region(other))].normal;
                const Vec3 along = mesh_.point(from(next(h))) - mesh_.point(from(h));
                if (region(other) == region(f) || dot(cross(plane.normal, there), along) >= 0.0) {
                    return;
                }
                for (const std::int32_t p : mesh_.faces[static_cast<std::size_t>(other)]) {
                    const double height = dot(plane.normal, mesh_.point(p)) - plane.offset;
                    if (height > worst) {
                        worst = height;
                        worst_edge = h;
                    }
                }
            });
        }
        if (worst_edge >= 0) {
            report_concave(worst_edge, worst);
        }
        return worst_edge < 0;
    }

    void report_concave(std::int32_t h, double height) {
        const std::int32_t f = set_.half_edge_face[static_cast<std::size_t>(h)];
        const Vec3& here = planes_[static_cast<std::size_t>(region(f))].normal;
        const Vec3& there = planes_[static_cast<std::size_t>(region_across(h))].normal;
        const double fold = std::atan2(norm(cross(here, there)), dot(here, there)) * 180.0 / std::numbers::pi;
        problem(static_cast<std::size_t>(f),
                fmt::format("{} is not convex: at the edge from {} to {} it folds inwards by {:.3g} degrees, the "
                            "neighbour of {} rises {:.3g} m above it",
                            shell_name(), coordinates(mesh_.point(from(h))), coordinates(mesh_.point(from(next(h)))),
                            fold, mesh_.name_of(static_cast<std::size_t>(f)), height),
                "a body that is not convex is stated as several closed convex shells in one file");
    }

    /// The outline of every region becomes a polygon; corners between two edges to the same neighbour lie on a line.
    bool trace_regions(ConvexPart& result) {
        if (planes_.size() > audit_faces_of_a_part) {
            problem(static_cast<std::size_t>(shell_.front()),
                    fmt::format("{} has {} faces after joining coplanar ones", shell_name(), planes_.size()),
                    fmt::format("at most {} faces of one convex part", audit_faces_of_a_part));
            return false;
        }
        std::map<std::int32_t, std::int32_t> vertex_of;  // welded point -> vertex of the part
        for (std::size_t r = 0; r < planes_.size(); ++r) {
            Loop points;
            if (!trace(static_cast<std::int32_t>(r), points) || points.size() < 3) {
                const auto f = static_cast<std::size_t>(region_faces_[r].front());
                problem(f,
                        fmt::format("{} is not convex: the faces in the plane of {} do not form one polygon",
                                    shell_name(), mesh_.name_of(f)),
                        "a body that is not convex is stated as several closed convex shells in one file");
                return false;
            }
            Loop& loop = result.part.polyhedron.faces.emplace_back();
            for (const std::int32_t p : points) {
                const auto [entry, is_new] = vertex_of.try_emplace(p, static_cast<std::int32_t>(result.point.size()));
                if (is_new) {
                    result.point.push_back(p);
                    result.part.polyhedron.vertices.push_back(mesh_.point(p));
                }
                loop.push_back(entry->second);
            }
        }
        return true;
    }

    bool trace(std::int32_t number, Loop& points) {
        std::int32_t first = -1;
        std::size_t outline_length = 0;
        for (const std::int32_t f : region_faces_[static_cast<std::size_t>(number)]) {
            for_each_half_edge(f, [&](std::int32_t h) {
                if (region_across(h) != number) {
                    first = first < 0 ? h : first;
                    ++outline_length;
                }
            });
        }
        if (first < 0) {
            return false;
        }
        std::vector<std::int32_t> outline;
        std::int32_t h = first;
        do {
            outline.push_back(h);
            h = next(h);
            while (region_across(h) == number) {
                h = next(set_.twin[static_cast<std::size_t>(h)]);
            }
        } while (h != first && outline.size() <= outline_length);
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const std::int32_t before = outline[(i + outline.size() - 1) % outline.size()];
            if (region_across(before) != region_across(outline[i])) {
                points.push_back(from(outline[i]));
            }
        }
        return outline.size() == outline_length;
    }

    /// Locally convex everywhere is not enough: a surface may wind round twice. Every point must be below every face.
    bool is_convex_as_a_whole(const ConvexPart& result) {
        std::vector<std::int32_t> points;
        for (const std::int32_t f : shell_) {
            const Loop& loop = mesh_.faces[static_cast<std::size_t>(f)];
            points.insert(points.end(), loop.begin(), loop.end());
        }
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        const Polyhedron& polyhedron = result.part.polyhedron;
        constexpr std::size_t most_tests = 400'000'000;
        if (points.size() * polyhedron.faces.size() > most_tests) {
            problem(
                static_cast<std::size_t>(shell_.front()),
                fmt::format("{} has {} vertices and {} faces", shell_name(), points.size(), polyhedron.faces.size()),
                fmt::format("at most {} vertices times faces in one convex part", most_tests));
            return false;
        }
        for (std::size_t r = 0; r < polyhedron.faces.size(); ++r) {
            const Plane plane = face_plane(polyhedron.vertices, polyhedron.faces[r]);
            for (const std::int32_t p : points) {
                const double height = dot(plane.normal, mesh_.point(p)) - plane.offset;
                if (!(height <= slack())) {  // also refuses a polygon without an area
                    const auto f = static_cast<std::size_t>(region_faces_[r].front());
                    problem(f,
                            fmt::format("{} is not convex: the vertex at {} lies {:.3g} m above the plane of {}",
                                        shell_name(), coordinates(mesh_.point(p)), height, mesh_.name_of(f)),
                            "a body that is not convex is stated as several closed convex shells in one file");
                    return false;
                }
            }
        }
        return true;
    }

    /// Height above a face that still counts as in its plane [m]: both planes and the vertex are known to the
    /// tolerance.
    double slack() const { return 3.0 * mesh_.tolerance; }

    const SurfaceMesh& mesh_;
    const ShellSet& set_;
    const std::vector<std::int32_t>& shell_;
    ProblemList& problems_;
    double volume_{0.0};
    double area_{0.0};
    std::map<std::int32_t, std::int32_t> region_of_;
    std::vector<Plane> planes_;
    std::vector<std::vector<std::int32_t>> region_faces_;
};

}  // namespace

ConvexPart make_convex_part(const SurfaceMesh& mesh, const ShellSet& shells, std::size_t shell, ProblemList& problems) {
    return PartMaker(mesh, shells, shells.shells[shell], problems).make();
}

}  // namespace riprap::geometry
