// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/half_edge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "riprap/core/index.hpp"

namespace riprap::geometry {

namespace {

/// A list of problems that stops growing but keeps counting.
class ProblemList {
 public:
    void add(std::string message, std::string allowed) {
        if (++count_ <= problem_limit) {
            list_.push_back({std::move(message), std::move(allowed)});
        }
    }
    bool empty() const { return count_ == 0; }
    std::vector<GeometryProblem> take() {
        if (count_ > problem_limit) {
            list_.push_back({fmt::format("and {} more problems of this surface", count_ - problem_limit), ""});
        }
        return std::move(list_);
    }

 private:
    std::vector<GeometryProblem> list_;
    std::size_t count_{0};
};

void check_loops(const Polyhedron& shape, ProblemList& problems) {
    const auto vertex_count = static_cast<std::int32_t>(shape.vertices.size());
    for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
        if (!is_finite(shape.vertices[v])) {
            problems.add(fmt::format("vertex {} is not finite", v), "give finite coordinates");
        }
    }
    std::vector<std::size_t> last_face(shape.vertices.size(), shape.faces.size());
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const auto& loop = shape.faces[f];
        if (loop.size() < 3) {
            problems.add(fmt::format("face {} has {} corners", f, loop.size()), "a face needs at least 3");
        }
        for (const std::int32_t v : loop) {
            if (v < 0 || v >= vertex_count) {
                problems.add(fmt::format("face {} names vertex {}", f, v),
                             fmt::format("vertices are numbered 0 to {}", vertex_count - 1));
            } else if (std::exchange(last_face[at(v)], f) == f) {
                problems.add(fmt::format("face {} uses vertex {} twice", f, v), "a face is one simple loop");
            }
        }
    }
    for (std::size_t v = 0; v < last_face.size(); ++v) {
        if (last_face[v] == shape.faces.size()) {
            problems.add(fmt::format("no face uses vertex {}", v), "remove it");
        }
    }
    if (shape.faces.size() < 4) {
        problems.add(fmt::format("{} faces enclose no volume", shape.faces.size()), "a body needs at least 4 faces");
    }
}

void check_planarity(const Polyhedron& shape, ProblemList& problems) {
    const double scale = length_scale(shape.vertices);
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const Vec3 area = vector_area(shape.vertices, shape.faces[f]);
        if (norm(area) <= planarity_tolerance * planarity_tolerance * scale * scale) {
            problems.add(fmt::format("face {} has no area", f), "remove the face or its repeated vertices");
            continue;
        }
        // Heights above the first vertex, so that a body far from the origin loses no digits.
        const Vec3 normal = normalized(area);
        const Vec3& origin = shape.vertices[at(shape.faces[f][0])];
        double mean = 0;
        for (const std::int32_t v : shape.faces[f]) {
            mean += dot(normal, shape.vertices[at(v)] - origin) / static_cast<double>(shape.faces[f].size());
        }
        double worst = 0;
        std::int32_t worst_vertex = 0;
        for (const std::int32_t v : shape.faces[f]) {
            const double height = std::abs(dot(normal, shape.vertices[at(v)] - origin) - mean);
            if (height > worst) {
                worst = height;
                worst_vertex = v;
            }
        }
        if (worst > planarity_tolerance * scale) {
            problems.add(fmt::format("face {} is not plane: vertex {} is {:.3g} m off", f, worst_vertex, worst),
                         "split the face into triangles");
        }
    }
}

/// Fills everything but the pairs.
HalfEdgeMesh loops_of(const Polyhedron& shape) {
    HalfEdgeMesh mesh;
    mesh.vertex_edge.assign(shape.vertices.size(), -1);
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const auto& loop = shape.faces[f];
        const auto first = static_cast<std::int32_t>(mesh.vertex.size());
        const auto count = static_cast<std::int32_t>(loop.size());
        mesh.face_edge.push_back(first);
        for (std::int32_t k = 0; k < count; ++k) {
            mesh.vertex.push_back(loop[at(k)]);
            mesh.next.push_back(first + (k + 1) % count);
            mesh.face.push_back(static_cast<std::int32_t>(f));
            if (mesh.vertex_edge[at(loop[at(k)])] < 0) {
                mesh.vertex_edge[at(loop[at(k)])] = first + k;
            }
        }
    }
    mesh.face_edge.push_back(static_cast<std::int32_t>(mesh.vertex.size()));
    mesh.pair.assign(mesh.vertex.size(), -1);
    return mesh;
}

/// Finds the pairs: half-edges sorted by their two ends lie beside each other.
void match_pairs(HalfEdgeMesh& mesh, ProblemList& problems) {
    const auto ends = [&](std::int32_t e) { return std::minmax({mesh.vertex[at(e)], mesh.end(e)}); };
    std::vector<std::int32_t> order(mesh.vertex.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::int32_t a, std::int32_t b) { return std::pair(ends(a), a) < std::pair(ends(b), b); });
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const auto edge = ends(order[begin]);
        while (end < order.size() && ends(order[end]) == edge) {
            ++end;
        }
        const std::int32_t a = order[begin], b = order[end - 1];
        if (end - begin == 1) {
            problems.add(fmt::format("the surface is open at the edge of face {} between vertices {} and {}",
                                     mesh.face[at(a)], mesh.vertex[at(a)], mesh.end(a)),
                         "close the surface");
        } else if (end - begin > 2) {
            problems.add(
                fmt::format("{} faces share the edge between vertices {} and {}", end - begin, edge.first, edge.second),
                "an edge belongs to two faces");
        } else if (mesh.vertex[at(a)] == mesh.vertex[at(b)]) {
            problems.add(fmt::format("faces {} and {} wind against each other at the edge between vertices {} and {}",
                                     mesh.face[at(a)], mesh.face[at(b)], edge.first, edge.second),
                         "wind all faces counter-clockwise seen from outside");
        } else {
            mesh.pair[at(a)] = b;
            mesh.pair[at(b)] = a;
        }
    }
}

void check_fans(const HalfEdgeMesh& mesh, ProblemList& problems) {
    std::vector<std::int32_t> outgoing(mesh.vertex_edge.size(), 0);
    for (const std::int32_t v : mesh.vertex) {
        ++outgoing[at(v)];
    }
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        std::int32_t reached = 0;
        mesh.for_each_outgoing(v, [&](std::int32_t) { ++reached; });
        if (reached != outgoing[at(v)]) {
            problems.add(fmt::format("two parts of the surface touch at vertex {} only", v),
                         "give each part its own vertex, as a body of its own");
        }
    }
}

void check_pieces(const HalfEdgeMesh& mesh, ProblemList& problems) {
    std::vector<std::uint8_t> is_reached(at(mesh.face_count()), 0);
    std::vector<std::int32_t> front;
    std::int32_t pieces = 0;
    for (std::int32_t seed = 0; seed < mesh.face_count(); ++seed) {
        if (is_reached[at(seed)] != 0) {
            continue;
        }
        ++pieces;
        is_reached[at(seed)] = 1;
        front.push_back(seed);
        while (!front.empty()) {
            const std::int32_t f = front.back();
            front.pop_back();
            for (std::int32_t e = mesh.face_edge[at(f)]; e < mesh.face_edge[at(f) + 1]; ++e) {
                const std::int32_t other = mesh.face[at(mesh.pair[at(e)])];
                if (std::exchange(is_reached[at(other)], std::uint8_t{1}) == 0) {
                    front.push_back(other);
                }
            }
        }
    }
    if (pieces > 1) {
        problems.add(fmt::format("the surface is in {} separate pieces", pieces), "make each piece a body of its own");
    }
    const std::int32_t euler = mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
    if (pieces == 1 && euler != 2) {
        problems.add(fmt::format("the body has {} holes through it (V - E + F = {})", (2 - euler) / 2, euler),
                     "V - E + F = 2; split the body into convex parts");
    }
}

}  // namespace

std::int32_t HalfEdgeMesh::previous(std::int32_t e) const {
    const std::int32_t f = face[index(e)];
    return e == face_edge[index(f)] ? face_edge[index(f) + 1] - 1 : e - 1;
}

Outcome<HalfEdgeMesh> half_edges(const Polyhedron& polyhedron) {
    ProblemList problems;
    check_loops(polyhedron, problems);
    if (!problems.empty()) {
        return problems.take();
    }
    check_planarity(polyhedron, problems);
    HalfEdgeMesh mesh = loops_of(polyhedron);
    match_pairs(mesh, problems);
    if (problems.empty()) {
        check_fans(mesh, problems);
        check_pieces(mesh, problems);
    }
    if (!problems.empty()) {
        return problems.take();
    }
    return mesh;
}

}  // namespace riprap::geometry
