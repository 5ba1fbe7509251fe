// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/clip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::geometry {

namespace {

using Loop = std::vector<std::int32_t>;

struct CutEdge {
    std::int32_t low, high;  ///< ends of the edge, low < high
    std::int32_t vertex;     ///< the vertex that the cut puts on it
};

/// One attempt to cut at a given tolerance. Vertices of both pieces live in one pool until the end.
class Cutter {
 public:
    Cutter(const Polyhedron& input, const Plane& plane, double tolerance) : input_(input), pool_(input.vertices) {
        height_.reserve(pool_.size());
        side_.reserve(pool_.size());
        for (const Vec3& x : pool_) {
            const double height = dot(plane.normal, x) - plane.offset;
            height_.push_back(height);
            side_.push_back(height > tolerance ? 1 : height < -tolerance ? -1 : 0);
        }
    }

    bool has_side(int side) const { return std::find(side_.begin(), side_.end(), side) != side_.end(); }

    /// False if the outline of the cut is not a single loop, which only a tolerance below round-off can cause.
    bool cut(CutPieces& pieces) {
        for (std::size_t f = 0; f < input_.faces.size(); ++f) {
            split_face(f, pieces);
        }
        return close(pieces.below) && close(pieces.above);
    }

 private:
    int side(std::int32_t v) const { return side_[static_cast<std::size_t>(v)]; }

    std::int32_t vertex_on_edge(std::int32_t a, std::int32_t b) {
        const std::int32_t low = std::min(a, b), high = std::max(a, b);
        for (const CutEdge& edge : cut_edges_) {
            if (edge.low == low && edge.high == high) {
                return edge.vertex;
            }
        }
        const auto l = static_cast<std::size_t>(low), h = static_cast<std::size_t>(high);
        const double t = height_[l] / (height_[l] - height_[h]);
        const auto vertex = static_cast<std::int32_t>(pool_.size());
        // From the nearer end, so that the error is relative to the shorter piece of the edge.
        pool_.push_back(t <= 0.5 ? pool_[l] + t * (pool_[h] - pool_[l]) : pool_[h] + (1.0 - t) * (pool_[l] - pool_[h]));
        cut_edges_.push_back({low, high, vertex});
        return vertex;
    }

    void split_face(std::size_t f, CutPieces& pieces) {
        const Loop& loop = input_.faces[f];
        Loop below, above;
        bool is_below = false, is_above = false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::int32_t a = loop[k], b = loop[(k + 1) % loop.size()];
            is_below = is_below || side(a) < 0;
            is_above = is_above || side(a) > 0;
            if (side(a) <= 0) {
                below.push_back(a);
            }
            if (side(a) >= 0) {
                above.push_back(a);
            }
            if (side(a) * side(b) < 0) {
                const std::int32_t vertex = vertex_on_edge(a, b);
                below.push_back(vertex);
                above.push_back(vertex);
            }
        }
        if (is_below) {
            add_face(pieces.below, std::move(below), f);
        }
        if (is_above) {
            add_face(pieces.above, std::move(above), f);
        }
    }

    void add_face(Polyhedron& piece, Loop loop, std::size_t from) const {
        piece.faces.push_back(std::move(loop));
        if (!input_.is_internal.empty()) {
            piece.is_internal.push_back(input_.is_internal[from]);
        }
    }

    /// Adds the cut, whose edges are those that no second face uses, and keeps the vertices in use only.
    bool close(Polyhedron& piece) {
        std::vector<std::array<std::int32_t, 2>> edges;  // on the plane, in the direction the cut will use them
        for (const Loop& loop : piece.faces) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::int32_t a = loop[k], b = loop[(k + 1) % loop.size()];
                if (is_on_plane(a) && is_on_plane(b)) {
                    edges.push_back({b, a});
                }
            }
        }
        const auto has_twin = [&](const std::array<std::int32_t, 2>& edge) {
            return std::find(edges.begin(), edges.end(), std::array{edge[1], edge[0]}) != edges.end();
        };
        std::vector<std::array<std::int32_t, 2>> outline;
        std::copy_if(edges.begin(), edges.end(), std::back_inserter(outline),
                     [&](const auto& edge) { return !has_twin(edge); });
        if (outline.size() < 3) {
            return false;
        }
        Loop cap;
        for (std::int32_t at = outline.front()[0]; cap.size() < outline.size();) {
            cap.push_back(at);
            const auto next = std::find_if(outline.begin(), outline.end(), [&](const auto& e) { return e[0] == at; });
            if (next == outline.end()) {
                return false;
            }
            at = (*next)[1];
            if (at == cap.front()) {
                break;
            }
        }
        if (cap.size() != outline.size()) {
            return false;
        }
        // Both pieces begin their fan at the same vertex, so that the two fans are the same triangles.
        std::rotate(cap.begin(), std::min_element(cap.begin(), cap.end()), cap.end());
        piece.faces.push_back(std::move(cap));
        if (!piece.is_internal.empty()) {
            piece.is_internal.push_back(0);
        }
        keep_used_vertices(piece);
        return true;
    }

    bool is_on_plane(std::int32_t v) const { return static_cast<std::size_t>(v) >= side_.size() || side(v) == 0; }

    void keep_used_vertices(Polyhedron& piece) const {
        std::vector<std::int32_t> number(pool_.size(), -1);
        for (const Loop& loop : piece.faces) {
            for (const std::int32_t v : loop) {
                number[static_cast<std::size_t>(v)] = 0;
            }
        }
        for (std::size_t v = 0; v < pool_.size(); ++v) {
            if (number[v] == 0) {
                number[v] = static_cast<std::int32_t>(piece.vertices.size());
                piece.vertices.push_back(pool_[v]);
            }
        }
        for (Loop& loop : piece.faces) {
            for (std::int32_t& v : loop) {
                v = number[static_cast<std::size_t>(v)];
            }
        }
    }

    const Polyhedron& input_;
    std::vector<Vec3> pool_;
    std::vector<double> height_;
    std::vector<int> side_;
    std::vector<CutEdge> cut_edges_;
};

}  // namespace

CutPieces cut_convex(const Polyhedron& polyhedron, const Plane& plane) {
    // A vertex beside the plane by less than the round-off of its own coordinates can make a face cross the plane
    // twice; a wider band then puts it on the plane.
    constexpr int attempts = 6;
    double tolerance = cut_tolerance * length_scale(polyhedron.vertices);
    for (int attempt = 0; attempt < attempts; ++attempt, tolerance *= 10.0) {
        Cutter cutter(polyhedron, plane, tolerance);
        if (!cutter.has_side(1)) {
            return {polyhedron, {}};
        }
        if (!cutter.has_side(-1)) {
            return {{}, polyhedron};
        }
        CutPieces pieces;
        if (cutter.cut(pieces)) {
            return pieces;
        }
    }
    throw InternalError(fmt::format("cut_convex: the polyhedron of {} faces is not convex", polyhedron.faces.size()));
}

Polyhedron clip_convex(const Polyhedron& polyhedron, const Plane& plane) {
    return polyhedron.faces.empty() ? Polyhedron{} : cut_convex(polyhedron, plane).below;
}

Range range_along(const Polyhedron& polyhedron, const Vec3& normal) {
    Range range{dot(normal, polyhedron.vertices[0]), dot(normal, polyhedron.vertices[0])};
    for (const Vec3& x : polyhedron.vertices) {
        range.low = std::min(range.low, dot(normal, x));
        range.high = std::max(range.high, dot(normal, x));
    }
    return range;
}

}  // namespace riprap::geometry
