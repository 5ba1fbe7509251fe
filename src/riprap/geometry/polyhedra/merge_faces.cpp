// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/merge_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace riprap::geometry {

namespace {

using Loop = std::vector<std::int32_t>;

struct DirectedEdge {
    std::int32_t from, to, face;
    friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) {
        return std::array{a.from, a.to, a.face} < std::array{b.from, b.to, b.face};
    }
};

std::vector<DirectedEdge> directed_edges(const std::vector<Loop>& faces) {
    std::vector<DirectedEdge> edges;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Loop& loop = faces[f];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            edges.push_back({loop[k], loop[(k + 1) % loop.size()], static_cast<std::int32_t>(f)});
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

/// The face on the other side of `edge`, or -1.
std::int32_t neighbour_across(const std::vector<DirectedEdge>& edges, const DirectedEdge& edge) {
    const auto found = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, -1});
    return found != edges.end() && found->from == edge.to && found->to == edge.from ? found->face : -1;
}

/// Groups of faces, each named by its lowest face.
class Groups {
 public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::int32_t find(std::int32_t i) {
        while (parent_[static_cast<std::size_t>(i)] != i) {
            auto& up = parent_[static_cast<std::size_t>(i)];
            up = parent_[static_cast<std::size_t>(up)];
            i = up;
        }
        return i;
    }
    void join(std::int32_t a, std::int32_t b) {
        a = find(a);
        b = find(b);
        parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }

 private:
    std::vector<std::int32_t> parent_;
};

class Merger {
 public:
    explicit Merger(const Polyhedron& input)
        : input_(input), tolerance_(coplanar_tolerance * length_scale(input.vertices)) {
        areas_.reserve(input.faces.size());
        for (const Loop& loop : input.faces) {
            areas_.push_back(vector_area(input.vertices, loop));
        }
    }

    Polyhedron merge() {
        const std::vector<DirectedEdge> edges = directed_edges(input_.faces);
        Groups groups(input_.faces.size());
        for (const DirectedEdge& edge : edges) {
            const std::int32_t other = neighbour_across(edges, edge);
            if (other > edge.face && are_coplanar(edge.face, other)) {
                groups.join(edge.face, other);
            }
        }
        std::vector<std::vector<DirectedEdge>> outline(input_.faces.size());
        for (const DirectedEdge& edge : edges) {
            const std::int32_t other = neighbour_across(edges, edge);
            const std::int32_t group = groups.find(edge.face);
            if (other < 0 || groups.find(other) != group) {
                outline[static_cast<std::size_t>(group)].push_back(edge);
            }
        }
        Polyhedron result;
        for (std::size_t f = 0; f < input_.faces.size(); ++f) {
            const auto face = static_cast<std::int32_t>(f);
            if (groups.find(face) != face) {
                continue;
            }
            Loop loop = single_loop(outline[f]);
            if (!loop.empty()) {
                add_face(result, std::move(loop), f);
                continue;
            }
            for (std::size_t g = f; g < input_.faces.size(); ++g) {
                if (groups.find(static_cast<std::int32_t>(g)) == face) {
                    add_face(result, input_.faces[g], g);
                }
            }
        }
        result.vertices = input_.vertices;
        drop_flat_corners(result);
        drop_unused_vertices(result);
        return result;
    }

 private:
    bool is_internal(std::size_t face) const { return !input_.is_internal.empty() && input_.is_internal[face] != 0; }

    void add_face(Polyhedron& result, Loop loop, std::size_t from) const {
        result.faces.push_back(std::move(loop));
        if (!input_.is_internal.empty()) {
            result.is_internal.push_back(input_.is_internal[from]);
        }
    }

    bool are_coplanar(std::int32_t a, std::int32_t b) const {
        auto large = static_cast<std::size_t>(a), small = static_cast<std::size_t>(b);
        if (is_internal(large) != is_internal(small)) {
            return false;
        }
        if (norm_squared(areas_[large]) < norm_squared(areas_[small])) {
            std::swap(large, small);
        }
        const double area = norm(areas_[large]);
        if (area == 0 || dot(areas_[large], areas_[small]) < 0) {
            return false;
        }
        const Vec3 normal = areas_[large] / area;
        const Vec3& origin = input_.vertices[static_cast<std::size_t>(input_.faces[large][0])];
        const Loop& loop = input_.faces[small];
        return std::all_of(loop.begin(), loop.end(), [&](std::int32_t i) {
            return std::abs(dot(normal, input_.vertices[static_cast<std::size_t>(i)] - origin)) <= tolerance_;
        });
    }

    /// Chains edges (sorted by their start) into one loop; empty if they make several or touch themselves.
    static Loop single_loop(const std::vector<DirectedEdge>& edges) {
        for (std::size_t k = 1; k < edges.size(); ++k) {
            if (edges[k].from == edges[k - 1].from) {
                return {};
            }
        }
        Loop loop;
        if (edges.empty()) {
            return loop;
        }
        std::int32_t at = edges[0].from;
        do {
            const auto next = std::lower_bound(edges.begin(), edges.end(), DirectedEdge{at, -1, -1});
            if (next == edges.end() || next->from != at || loop.size() == edges.size()) {
                return {};
            }
            loop.push_back(at);
            at = next->to;
        } while (at != edges[0].from);
        return loop.size() == edges.size() ? loop : Loop{};
    }

    /// A vertex of two faces only, on the line between its neighbours, is no corner.
    void drop_flat_corners(Polyhedron& shape) const {
        std::vector<std::int32_t> uses(shape.vertices.size(), 0);
        for (const Loop& loop : shape.faces) {
            for (const std::int32_t i : loop) {
                ++uses[static_cast<std::size_t>(i)];
            }
        }
        for (Loop& loop : shape.faces) {
            Loop kept;
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec3& before =
                    shape.vertices[static_cast<std::size_t>(loop[(k + loop.size() - 1) % loop.size()])];
                const Vec3& here = shape.vertices[static_cast<std::size_t>(loop[k])];
                const Vec3& after = shape.vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
                if (uses[static_cast<std::size_t>(loop[k])] > 2 || !is_between(before, here, after)) {
                    kept.push_back(loop[k]);
                }
            }
            loop = std::move(kept);
        }
    }

    bool is_between(const Vec3& a, const Vec3& x, const Vec3& b) const {
        const double length = norm(b - a);
        return norm(cross(b - a, x - a)) <= tolerance_ * length && dot(x - a, b - x) > 0;
    }

    static void drop_unused_vertices(Polyhedron& shape) {
        std::vector<std::int32_t> renumbered(shape.vertices.size(), -1);
        for (const Loop& loop : shape.faces) {
            for (const std::int32_t i : loop) {
                renumbered[static_cast<std::size_t>(i)] = 0;
            }
        }
        std::int32_t count = 0;
        for (std::size_t i = 0; i < renumbered.size(); ++i) {
            if (renumbered[i] == 0) {
                shape.vertices[static_cast<std::size_t>(count)] = shape.vertices[i];
                renumbered[i] = count++;
            }
        }
        shape.vertices.resize(static_cast<std::size_t>(count));
        for (Loop& loop : shape.faces) {
            for (std::int32_t& i : loop) {
                i = renumbered[static_cast<std::size_t>(i)];
            }
        }
    }

    const Polyhedron& input_;
    double tolerance_;
    std::vector<Vec3> areas_;
};

}  // namespace

Polyhedron merge_coplanar_faces(const Polyhedron& polyhedron) { return Merger(polyhedron).merge(); }

}  // namespace riprap::geometry
