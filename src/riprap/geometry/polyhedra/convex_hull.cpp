// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/convex_hull.hpp"

#include <fmt/format.h>
#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "riprap/geometry/polyhedra/half_edge.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"

namespace riprap::geometry {

namespace {

/// Points closer than this are one, and bodies thinner than this are flat, as a fraction of the extent.
constexpr double weld_tolerance = 1e-9;

/// The lowest-numbered of each cluster of points within `distance` of it, in the given order: a sweep along x.
std::vector<Vec3> welded(std::span<const Vec3> points, double distance) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::array{points[a].x, points[a].y, points[a].z, static_cast<double>(a)} <
               std::array{points[b].x, points[b].y, points[b].z, static_cast<double>(b)};
    });
    std::vector<std::uint8_t> is_kept(points.size(), 1);
    std::vector<std::size_t> recent;  // kept points that a later one may still be close to, by x
    std::size_t oldest = 0;
    for (const std::size_t i : order) {
        while (oldest < recent.size() && points[recent[oldest]].x < points[i].x - distance) {
            ++oldest;
        }
        for (std::size_t k = oldest; k < recent.size() && is_kept[i] != 0; ++k) {
            is_kept[i] = norm(points[recent[k]] - points[i]) <= distance ? 0 : 1;
        }
        if (is_kept[i] != 0) {
            recent.push_back(i);
        }
    }
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (is_kept[i] != 0) {
            kept.push_back(points[i]);
        }
    }
    return kept;
}

/// The index where measure(point) is largest.
template <class Measure>
std::size_t farthest(const std::vector<Vec3>& points, Measure&& measure) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double value = measure(points[i]);
        if (value > most) {
            most = value;
            best = i;
        }
    }
    return best;
}

/// "on one line", "in one plane", or empty when four far points span a volume.
std::string flatness(const std::vector<Vec3>& points, double tolerance) {
    const Vec3& a = points[0];
    const Vec3& b = points[farthest(points, [&](const Vec3& x) { return norm(x - a); })];
    const Vec3 along = normalized(b - a);
    const auto off_line = [&](const Vec3& x) { return norm(cross(along, x - a)); };
    const Vec3& c = points[farthest(points, off_line)];
    if (off_line(c) <= tolerance) {
        return "on one line";
    }
    const Vec3 normal = normalized(cross(along, c - a));
    const auto off_plane = [&](const Vec3& x) { return std::abs(dot(normal, x - a)); };
    return off_plane(points[farthest(points, off_plane)]) <= tolerance ? "in one plane" : "";
}

/// Owns one Qhull computation and the text of its complaints.
class QhullRun {
 public:
    explicit QhullRun(std::vector<Vec3>& points) : complaints_(open_memstream(&text_, &length_)) {
        if (complaints_ == nullptr) {
            throw std::bad_alloc();
        }
        QHULL_LIB_CHECK
        qh_zero(&qhull_, complaints_);
        std::string command = "qhull";
        static_assert(sizeof(Vec3) == 3 * sizeof(coordT));
        exit_code_ = qh_new_qhull(&qhull_, 3, static_cast<int>(points.size()), &points.front().x, False, command.data(),
                                  nullptr, complaints_);
    }
    ~QhullRun() {
        qh_freeqhull(&qhull_, !qh_ALL);
        int still_used = 0, still_held = 0;
        qh_memfreeshort(&qhull_, &still_used, &still_held);
        std::fclose(complaints_);
        std::free(text_);
    }
    QhullRun(const QhullRun&) = delete;
    QhullRun& operator=(const QhullRun&) = delete;

    bool has_failed() const { return exit_code_ != 0; }
    /// The first line of what Qhull says about a failure.
    std::string complaint() {
        std::fflush(complaints_);
        const std::string text(text_, length_);
        return text.substr(0, text.find('\n'));
    }

    /// Vertex loops of all facets, counter-clockwise seen from outside, numbers of the points.
    std::vector<std::vector<std::int32_t>> facets() {
        std::vector<std::vector<std::int32_t>> loops;
        qhT* qh = &qhull_;
        facetT* facet = nullptr;
        FORALLfacets {
            setT* corners = qh_facet3vertex(qh, facet);
            std::vector<std::int32_t> loop;
            vertexT *vertex = nullptr, **vertexp = nullptr;
            FOREACHvertex_(corners) { loop.push_back(qh_pointid(qh, vertex->point)); }
            qh_settempfree(qh, &corners);
            loops.push_back(std::move(loop));
        }
        return loops;
    }

 private:
    qhT qhull_{};
    char* text_{nullptr};
    std::size_t length_{0};
    FILE* complaints_;
    int exit_code_{0};
};

std::vector<GeometryProblem> point_problems(std::span<const Vec3> points) {
    if (points.size() > hull_point_limit) {
        return {{fmt::format("a hull of {} points", points.size()), fmt::format("at most {}", hull_point_limit)}};
    }
    std::vector<GeometryProblem> problems;
    for (std::size_t i = 0; i < points.size() && problems.size() < problem_limit; ++i) {
        if (!is_finite(points[i])) {
            problems.push_back({fmt::format("point {} of the hull is not finite", i), "give finite coordinates"});
        }
    }
    if (problems.empty() && points.size() < 4) {
        problems.push_back({fmt::format("a hull of {} points has no volume", points.size()), "give at least 4 points"});
    }
    return problems;
}

/// Turns each loop so that its vector area points away from `middle`.
void orient_outwards(Polyhedron& hull, const Vec3& middle) {
    for (auto& loop : hull.faces) {
        const Vec3 area = vector_area(hull.vertices, loop);
        if (dot(area, hull.vertices[static_cast<std::size_t>(loop[0])] - middle) < 0) {
            std::reverse(loop.begin(), loop.end());
        }
    }
}

/// No vertex is higher than `tolerance` above any face.
bool is_convex(const Polyhedron& hull, double tolerance) {
    return std::all_of(hull.faces.begin(), hull.faces.end(), [&](const auto& loop) {
        const Vec3 normal = face_plane(hull.vertices, loop).normal;
        const Vec3& origin = hull.vertices[static_cast<std::size_t>(loop[0])];
        return std::all_of(hull.vertices.begin(), hull.vertices.end(),
                           [&](const Vec3& x) { return dot(normal, x - origin) <= tolerance; });
    });
}

}  // namespace

Outcome<Polyhedron> convex_hull(std::span<const Vec3> points) {
    std::vector<GeometryProblem> problems = point_problems(points);
    if (!problems.empty()) {
        return problems;
    }
    const double scale = length_scale(points);
    if (!(scale > 0) || !std::isfinite(scale)) {
        return GeometryProblem{scale > 0 ? "the points of the hull are too far apart for double precision"
                                         : "the points of the hull are all in one place",
                               "give points that span a volume"};
    }
    if (!(scale >= least_extent && scale <= most_extent)) {
        return extent_problem({scale, scale, scale}, false);
    }
    const std::vector<Vec3> given = welded(points, weld_tolerance * scale);
    const std::string flat = flatness(given, weld_tolerance * scale);
    if (!flat.empty()) {
        return GeometryProblem{"the points of the hull lie " + flat, "give points that span a volume"};
    }
    // Qhull sees numbers of order one about the middle of the points; the hull is built on the numbers given.
    Vec3 middle{};
    for (const Vec3& x : given) {
        middle += x / static_cast<double>(given.size());
    }
    std::vector<Vec3> scaled;
    scaled.reserve(given.size());
    for (const Vec3& x : given) {
        scaled.push_back((x - middle) / scale);
    }
    QhullRun run(scaled);
    if (run.has_failed()) {
        return GeometryProblem{fmt::format("no convex hull was found: {}", run.complaint()),
                               "give points that span a volume"};
    }
    Polyhedron hull{given, run.facets(), {}};
    orient_outwards(hull, middle);
    hull = merge_coplanar_faces(hull);
    const Outcome<HalfEdgeMesh> topology = half_edges(hull);
    if (!topology || !is_convex(hull, weld_tolerance * scale)) {
        problems = topology.problems();
        problems.insert(problems.begin(),
                        {"the points of the hull are too close to a flat shape, or too far from the origin for their "
                         "extent",
                         "give points that span a volume"});
        return problems;
    }
    return hull;
}

Outcome<Polyhedron> random_hull(std::uint64_t seed, int corner_count, double circumradius) {
    if (corner_count < 4 || corner_count > 200) {
        return GeometryProblem{fmt::format("a random block of {} corners", corner_count), "give 4 to 200 corners"};
    }
    if (!(circumradius > 0) || !std::isfinite(circumradius)) {
        return GeometryProblem{fmt::format("a random block of circumradius {} m", circumradius),
                               "give a positive finite length"};
    }
    std::uint64_t drawn = 0;
    const auto uniform = [&] { return unit_interval(mix_bits(seed, drawn++)); };
    constexpr int attempts = 100'000;  // four points: about one draw in a hundred will do
    constexpr double smallest_depth = 0.1;
    std::vector<Vec3> points(static_cast<std::size_t>(corner_count));
    for (int attempt = 0; attempt < attempts; ++attempt) {
        for (Vec3& x : points) {
            const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform();
            const double r = std::sqrt(1 - z * z);
            x = {r * std::cos(angle), r * std::sin(angle), z};
        }
        Outcome<Polyhedron> outcome = convex_hull(points);
        if (!outcome) {
            continue;
        }
        Polyhedron hull = std::move(outcome).value();
        double depth = std::numeric_limits<double>::infinity();
        for (const auto& loop : hull.faces) {
            depth = std::min(depth, face_plane(hull.vertices, loop).offset);
        }
        if (depth >= smallest_depth) {
            for (Vec3& x : hull.vertices) {
                x *= circumradius;
            }
            return hull;
        }
    }
    return GeometryProblem{fmt::format("no compact block of {} corners was drawn", corner_count), "give more corners"};
}

}  // namespace riprap::geometry
