// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/mesh_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "riprap/core/index.hpp"

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
    for (const Edge& rim : rims) {
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
    facts.holes = std::max(0, count(loops) - facts.open_parts);
}

}  // namespace

MeshFacts facts_of(const TriangleMesh& mesh, const Vec3& up) {
    MeshFacts facts;
    facts.triangles = mesh.size();
    facts.low = facts.high = mesh.points.empty() ? Vec3{} : mesh.points.front();
    for (const Vec3& x : mesh.points) {
        facts.low = min(facts.low, x);
        facts.high = max(facts.high, x);
    }
    double least = 2;  // cosine
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        const double cosine = std::abs(dot(up, normalized(mesh.area_normal(t))));
        if (cosine < least) {
            least = cosine;
            facts.at_steepest = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
        }
    }
    facts.steepest = std::acos(std::min(least, 1.0));
    count_parts(mesh, facts);
    return facts;
}

std::string text_of(const MeshFacts& facts) {
    const auto plural = [](std::int32_t n, const char* what) {
        return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
    };
    return fmt::format(
        "x {:.9g} to {:.9g}, y {:.9g} to {:.9g}, z {:.6g} to {:.6g} m; {} in {}, {}; steepest {:.3g} deg at ({:.9g}, "
        "{:.9g}, "
        "{:.6g})",
        facts.low.x, facts.high.x, facts.low.y, facts.high.y, facts.low.z, facts.high.z,
        plural(facts.triangles, "triangle"), plural(facts.parts, "part"),
        facts.open_parts == 0 ? "closed"
        : facts.holes == 0    ? "no holes"
                              : plural(facts.holes, "hole"),
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
