// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/mesh_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

namespace {

/// Sets of numbers, each named by its least.
class Sets {
 public:
    explicit Sets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0); }
    std::int32_t root(std::int32_t i) {
        while (up_[at(i)] != i) {
            i = up_[at(i)] = up_[at(up_[at(i)])];
        }
        return i;
    }
    void join(std::int32_t a, std::int32_t b) {
        a = root(a);
        b = root(b);
        up_[at(std::max(a, b))] = std::min(a, b);
    }

 private:
    std::vector<std::int32_t> up_;
};

struct Edge {
    std::int32_t low, high, triangle;
    bool operator<(const Edge& other) const {
        return std::array{low, high, triangle} < std::array{other.low, other.high, other.triangle};
    }
};

std::vector<Edge> edges_of(const TriangleMesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * at(mesh.size()));
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        const auto& corners = mesh.corners[at(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
            edges.push_back({low, high, t});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// Six times the volume that a triangle adds to that of its part, about the point `origin`.
double six_volumes(const TriangleMesh& mesh, std::int32_t t, const Vec3& origin) {
    return dot(mesh.corner(t, 0) - origin, cross(mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin));
}

/// Looks at the sides of parts: which closed ones face inwards, and where open ones face.
void look_at_sides(const TriangleMesh& mesh, Sets& triangles, const std::vector<std::int32_t>& open, MeshFacts& facts) {
    constexpr double least = 0.1;  // of the area: less, and the surface is nearly closed
    std::vector<double> volume(at(mesh.size()), 0.0);
    Vec3 sum{};
    double area = 0;
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        const std::int32_t part = triangles.root(t);
        if (std::binary_search(open.begin(), open.end(), part)) {
            sum += mesh.area_normal(t);
            area += norm(mesh.area_normal(t));
        } else {
            volume[at(part)] += six_volumes(mesh, t, facts.low);
        }
    }
    facts.hollows =
        static_cast<std::int32_t>(std::count_if(volume.begin(), volume.end(), [](double v) { return v < 0; }));
    facts.outward = norm(sum) > least * area ? normalized(sum) : Vec3{};
}

/// Counts parts, and rims beyond one for each part that has any.
void count_parts(const TriangleMesh& mesh, MeshFacts& facts) {
    const std::vector<Edge> edges = edges_of(mesh);
    Sets triangles(at(mesh.size())), points(mesh.points.size());
    std::vector<Edge> rims;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end) {
            triangles.join(edges[i].triangle, edges[end].triangle);
        }
        if (end == i + 1) {
            rims.push_back(edges[i]);
            points.join(edges[i].low, edges[i].high);
        }
        i = end;
    }
    std::vector<std::int32_t> loops, open;
    facts.rim_edges = static_cast<std::int32_t>(rims.size());
    for (const Edge& rim : rims) {
        facts.rim_length += norm(mesh.points[at(rim.high)] - mesh.points[at(rim.low)]);
        loops.push_back(points.root(rim.low));
        open.push_back(triangles.root(rim.triangle));
    }
    const auto count = [](std::vector<std::int32_t>& list) {
        std::sort(list.begin(), list.end());
        return static_cast<std::int32_t>(std::unique(list.begin(), list.end()) - list.begin());
    };
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        facts.parts += triangles.root(t) == t ? 1 : 0;
    }
    facts.open_parts = count(open);
    open.resize(at(facts.open_parts));
    look_at_sides(mesh, triangles, open, facts);
    facts.holes = std::max(0, count(loops) - facts.open_parts);
}

}  // namespace

MeshFacts facts_of(const TriangleMesh& mesh, const Vec3& up) {
    MeshFacts facts;
    facts.triangles = mesh.size();
    facts.low = facts.high = mesh.corners.empty() ? Vec3{} : mesh.corner(0, 0);
    constexpr double steep = 0.17364817766693033;  // cosine of 80 degrees
    double least = 2;                              // cosine
    std::int32_t steep_ones = 0;
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        for (int k = 0; k < 3; ++k) {  // a file may have points that no triangle uses
            facts.low = min(facts.low, mesh.corner(t, k));
            facts.high = max(facts.high, mesh.corner(t, k));
        }
        const double cosine = std::abs(dot(up, normalized(mesh.area_normal(t))));
        steep_ones += cosine < steep ? 1 : 0;
        if (cosine < least) {
            least = cosine;
            facts.at_steepest = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        }
    }
    facts.steep_share = mesh.size() > 0 ? static_cast<double>(steep_ones) / mesh.size() : 0;
    facts.steepest = std::acos(std::min(least, 1.0));
    count_parts(mesh, facts);
    return facts;
}

namespace {

/// "+z" for a vector that points most along z.
std::string axis_of(const Vec3& v) {
    constexpr double clearly = 1.1;  // ground that leans by 45 degrees still faces upwards
    int most = 2;
    for (int axis = 0; axis < 2; ++axis) {
        most = std::abs(v[axis]) > clearly * std::abs(v[most]) ? axis : most;
    }
    return fmt::format("{}{}", v[most] < 0 ? '-' : '+', "xyz"[most]);
}

/// "closed, solid inside", "no holes, rim 40 m long, facing +z"
std::string sides_text(const MeshFacts& facts) {
    if (facts.open_parts == 0) {
        return facts.hollows == 0             ? "closed, solid inside"
               : facts.hollows == facts.parts ? "closed, solid outside"
                                              : fmt::format("closed, solid outside of {} of them", facts.hollows);
    }
    std::string text = facts.holes == 0   ? "no holes"
                       : facts.holes == 1 ? "1 hole"
                                          : fmt::format("{} holes", facts.holes);
    text += fmt::format(", rim{} {:.4g} m long", facts.holes + facts.open_parts > 1 ? "s" : "", facts.rim_length);
    return norm(facts.outward) > 0 ? text + ", facing " + axis_of(facts.outward) : text;
}

}  // namespace

std::string text_of(const MeshFacts& facts) {
    const auto plural = [](std::int32_t n, const char* what) {
        return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
    };
    return fmt::format(
        "x {:.9g} to {:.9g}, y {:.9g} to {:.9g}, z {:.6g} to {:.6g} m; {} in {}, {}; steepest {:.3g} deg at ({:.9g}, "
        "{:.9g}, "
        "{:.6g})",
        facts.low.x, facts.high.x, facts.low.y, facts.high.y, facts.low.z, facts.high.z,
        plural(facts.triangles, "triangle"), plural(facts.parts, "part"), sides_text(facts),
        facts.steepest * 180 / std::numbers::pi, facts.at_steepest.x, facts.at_steepest.y, facts.at_steepest.z);
}

double farthest(const Vec3& low, const Vec3& high) {
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        most = std::max({most, std::abs(low[axis]), std::abs(high[axis])});
    }
    return most;
}

std::string precision_text(const Vec3& low, const Vec3& high, double epsilon, const char* of) {
    const double most = farthest(low, high);
    return fmt::format("up to {:.4g} m from the origin, where {} resolves {:.2g} m", most, of, epsilon * most);
}

bool is_far(const Vec3& low, const Vec3& high) {
    constexpr double many = 100;
    const Vec3 extent = high - low;
    return farthest(low, high) > many * std::max({extent.x, extent.y, extent.z});
}

std::pair<Vec3, Vec3> box_of_faces(const Surface& surface) {
    if (surface.face_vertex.empty()) {
        return {};
    }
    const Vec3& first = surface.vertices[at(surface.face_vertex.front())];
    std::pair<Vec3, Vec3> box{first, first};
    for (const std::int32_t i : surface.face_vertex) {
        box.first = min(box.first, surface.vertices[at(i)]);
        box.second = max(box.second, surface.vertices[at(i)]);
    }
    return box;
}

std::pair<Vec3, Vec3> box_of(std::span<const Vec3> points) {
    std::pair<Vec3, Vec3> box;
    for (std::size_t i = 0; i < points.size(); ++i) {
        box.first = i == 0 ? points[i] : min(box.first, points[i]);
        box.second = i == 0 ? points[i] : max(box.second, points[i]);
    }
    return box;
}

std::size_t count_apart(std::span<const Polyhedron> pieces) {
    std::vector<std::pair<Vec3, Vec3>> boxes;
    std::vector<std::int32_t> tied;  // a piece with all its faces outside is tied to none
    double extent = 0;
    for (const Polyhedron& piece : pieces) {
        if (std::any_of(piece.is_internal.begin(), piece.is_internal.end(), [](auto flag) { return flag != 0; })) {
            tied.push_back(static_cast<std::int32_t>(boxes.size()));
        }
        boxes.push_back(box_of(piece.vertices));
        extent = std::max(extent, norm(boxes.back().second - boxes.back().first));
    }
    std::sort(tied.begin(), tied.end(), [&boxes](std::int32_t a, std::int32_t b) {
        return std::pair(boxes[at(a)].first.x, a) < std::pair(boxes[at(b)].first.x, b);
    });
    Sets groups(pieces.size());
    const double slack = 1e-6 * extent;
    for (std::size_t k = 0; k < tied.size(); ++k) {
        const auto& a = boxes[at(tied[k])];
        for (std::size_t l = k + 1; l < tied.size() && boxes[at(tied[l])].first.x <= a.second.x + slack; ++l) {
            const auto& b = boxes[at(tied[l])];
            if (b.first.y <= a.second.y + slack && a.first.y <= b.second.y + slack && b.first.z <= a.second.z + slack &&
                a.first.z <= b.second.z + slack) {
                groups.join(tied[k], tied[l]);
            }
        }
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto number = static_cast<std::int32_t>(i);
        count += groups.root(number) == number ? 1 : 0;
    }
    return count;
}

}  // namespace riprap::geometry
