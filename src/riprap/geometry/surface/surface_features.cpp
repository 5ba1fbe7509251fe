// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/surface_features.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"

namespace riprap::geometry {

namespace {

/// A place beyond a rim by this share of its length still lies on it [-].
constexpr double rim_slack = 1e-9;

/// One side of an edge, in an order that puts the sides of an edge beside each other.
struct HalfEdge {
    std::int32_t low, high;  ///< points
    bool is_up;              ///< runs from low to high
    std::int32_t triangle, place;

    auto order() const { return std::tuple{low, high, !is_up, triangle}; }
    friend bool operator<(const HalfEdge& a, const HalfEdge& b) { return a.order() < b.order(); }
};

std::vector<HalfEdge> half_edges(const TriangleMesh& mesh) {
    std::vector<HalfEdge> sides;
    sides.reserve(3 * at(mesh.size()));
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        for (std::int32_t k = 0; k < 3; ++k) {
            const std::int32_t p = mesh.corners[at(t)][at(k)], q = mesh.corners[at(t)][at((k + 1) % 3)];
            sides.push_back({std::min(p, q), std::max(p, q), p < q, t, k});
        }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

SurfaceFeatures::SurfaceFeatures(const TriangleMesh& mesh) {
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        normal_.push_back(normalized(mesh.area_normal(t)));
    }
    link_edges(mesh);
    for (SurfaceEdge& edge : edges_) {
        measure_edge(mesh, edge);
    }
    link_points(mesh);
}

void SurfaceFeatures::link_edges(const TriangleMesh& mesh) {
    edges_of_.resize(at(mesh.size()));
    const std::vector<HalfEdge> sides = half_edges(mesh);
    const auto add = [this](const HalfEdge& side, std::int32_t right) {
        edges_of_[at(side.triangle)][at(side.place)] = static_cast<std::int32_t>(edges_.size());
        SurfaceEdge edge{};
        edge.from = side.is_up ? side.low : side.high;
        edge.to = side.is_up ? side.high : side.low;
        edge.left = side.triangle;
        edge.right = right;
        edges_.push_back(edge);
    };
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) {
            ++end;
        }
        // Two triangles that wind against each other, or more than two: every one of them ends here.
        const bool is_plain = end - i == 2 && sides[i].is_up != sides[i + 1].is_up;
        if (is_plain) {
            add(sides[i], sides[i + 1].triangle);
            edges_of_[at(sides[i + 1].triangle)][at(sides[i + 1].place)] = static_cast<std::int32_t>(edges_.size()) - 1;
            continue;
        }
        for (std::size_t k = i; k < end; ++k) {
            add(sides[k], -1);
        }
    }
}

void SurfaceFeatures::measure_edge(const TriangleMesh& mesh, SurfaceEdge& edge) const {
    const Vec3 along = normalized(mesh.points[at(edge.to)] - mesh.points[at(edge.from)]);
    const Vec3& left = normal(edge.left);
    if (edge.right < 0) {
        edge.kind = EdgeKind::ridge;
        edge.wall = normalized(cross(along, left));
        edge.mean = normalized(left + edge.wall);
        edge.half_cosine = dot(edge.mean, left);
        return;
    }
    const Vec3& right = normal(edge.right);
    const Vec3 sum = left + right;
    // A fold of half a turn has no bisector: the wall then is that of a rim.
    edge.mean = norm(sum) > 1e-6 ? normalized(sum) : left;
    edge.wall = normalized(cross(along, edge.mean));
    edge.half_cosine = dot(edge.mean, left);
    const double turn = std::atan2(dot(cross(left, right), along), dot(left, right));
    edge.kind = std::abs(turn) < flat_turn ? EdgeKind::flat
                : turn > 0                 ? EdgeKind::ridge
                : turn > -steep_turn       ? EdgeKind::valley
                                           : EdgeKind::cleft;
}

void SurfaceFeatures::link_points(const TriangleMesh& mesh) {
    const std::size_t count = mesh.points.size();
    fan_begin_.assign(count + 1, 0);
    facing_.assign(count, Vec3{});
    is_sharp_.assign(count, 0);
    for (const SurfaceEdge& edge : edges_) {
        for (const std::int32_t p : {edge.from, edge.to}) {
            ++fan_begin_[at(p) + 1];
            facing_[at(p)] += normal(edge.left) + (edge.right >= 0 ? normal(edge.right) : Vec3{});
            is_sharp_[at(p)] |= edge.kind == EdgeKind::ridge ? 1 : 0;
        }
    }
    for (std::size_t p = 0; p < count; ++p) {
        fan_begin_[p + 1] += fan_begin_[p];
    }
    fan_.resize(at(fan_begin_.back()));
    std::vector<std::int32_t> next = fan_begin_;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        for (const std::int32_t p : {edges_[e].from, edges_[e].to}) {
            fan_[at(next[at(p)]++)] = static_cast<std::int32_t>(e);
        }
    }
}

bool SurfaceFeatures::is_in_cell(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& x) const {
    for (const std::int32_t e : edges_of(triangle)) {
        const SurfaceEdge& side = edge(e);
        const double beyond = dot(side.wall, x - mesh.points[at(side.from)]);
        const double most =
            side.right < 0 ? rim_slack * norm(mesh.points[at(side.to)] - mesh.points[at(side.from)]) : 0;
        if (side.left == triangle ? beyond > most : beyond <= 0) {
            return false;
        }
    }
    return true;
}

std::size_t SurfaceFeatures::bytes() const {
    return bytes_of(normal_, edges_, edges_of_, fan_begin_, fan_, facing_, is_sharp_);
}

}  // namespace riprap::geometry
