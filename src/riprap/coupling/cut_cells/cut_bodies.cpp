// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cut_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/geometry/clip.hpp"
#include "riprap/geometry/shapes.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;
using fluid::grid::Mesh;
using geometry::Plane;
using geometry::Polyhedron;

/// A closed share above 1 less this is 1: slivers of a face that no flow comes through [-].
constexpr double closed_tolerance = 1e-9;
/// Cells around a body in which faces know their distance from it.
constexpr int margin = 2;

/// Part of a body as half-spaces: of a sphere, the one that touches it nearest to the point asked for.
struct PartPlanes {
    std::vector<Plane> planes;
    const GridBody::Sphere* sphere{nullptr};
    Vec3 low, high;

    double distance(const Vec3& x) const {
        if (sphere != nullptr) {
            return norm(x - sphere->centre) - sphere->radius;
        }
        double largest = -std::numeric_limits<double>::infinity();
        for (const Plane& plane : planes) {
            largest = std::max(largest, dot(plane.normal, x) - plane.offset);
        }
        return largest;
    }
    /// Planes that may cut a cell; nothing where the cell lies outside.
    bool planes_across(const Vec3& centre, const Vec3& half, std::vector<Plane>& across) const {
        across.clear();
        const auto reach = [&half](const Vec3& n) {
            return std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
        };
        if (sphere != nullptr) {
            const Vec3 r = centre - sphere->centre;
            const double distance = norm(r);
            const Vec3 n = distance > 0 ? r / distance : Vec3{0, 0, 1};
            if (distance - sphere->radius >= reach(n)) {
                return false;
            }
            if (distance - sphere->radius > -reach(n)) {
                across.push_back({n, dot(n, sphere->centre) + sphere->radius});
            }
            return true;
        }
        for (const Plane& plane : planes) {
            const double gap = dot(plane.normal, centre) - plane.offset, r = reach(plane.normal);
            if (gap >= r) {
                return false;
            }
            if (gap > -r) {
                across.push_back(plane);
            }
        }
        return true;
    }
};

std::vector<PartPlanes> parts_of(const GridBody& body) {
    std::vector<PartPlanes> parts;
    for (const Polyhedron& polyhedron : body.parts) {
        PartPlanes part;
        part.low = part.high = polyhedron.vertices.front();
        for (const Vec3& v : polyhedron.vertices) {
            part.low = min(part.low, v);
            part.high = max(part.high, v);
        }
        for (const auto& face : polyhedron.faces) {
            part.planes.push_back(geometry::face_plane(polyhedron.vertices, face));
        }
        parts.push_back(std::move(part));
    }
    for (const GridBody::Sphere& sphere : body.spheres) {
        const Vec3 r{sphere.radius, sphere.radius, sphere.radius};
        parts.push_back({{}, &sphere, sphere.centre - r, sphere.centre + r});
    }
    return parts;
}

/// Collects what parts close, cell by cell.
class Cutter {
 public:
    Cutter(const Mesh& mesh, CutBodies& out) : mesh_(mesh), out_(out) {
        const auto size = at(mesh.box.size);
        out.open.has_bodies = true;
        out.open.volume.assign(size, 1.0);
        out.open.displacement.assign(size, 0.0);
        for (int a = 0; a < 3; ++a) {
            out.open.area[at(a)].assign(size, 1.0);
            out.open.body_velocity[at(a)].assign(size, 0.0);
            out.open.wall_distance[at(a)].assign(size, 1e30);
            out.nearest[at(a)].assign(size, -1);
            below_[at(a)].assign(size, 0.0);
            above_[at(a)].assign(size, 0.0);
        }
    }
    void cut(const GridBody& body, std::int32_t number) {
        for (const PartPlanes& part : parts_of(body)) {
            std::array<int, 3> first{}, last{};
            for (int a = 0; a < 3; ++a) {
                first[at(a)] = a < mesh_.box.axes ? mesh_.cell_at(a, part.low[a]) : 0;
                last[at(a)] = a < mesh_.box.axes ? mesh_.cell_at(a, part.high[a]) : 0;
            }
            for (int k = first[2]; k <= last[2]; ++k) {
                for (int j = first[1]; j <= last[1]; ++j) {
                    for (int i = first[0]; i <= last[0]; ++i) {
                        cut_cell(part, body, number, {i, j, k});
                    }
                }
            }
            find_distances(part, body, number, first, last);
        }
    }
    /// Turns closed areas of the two sides of each face into open shares.
    void finish() {
        for (int a = 0; a < mesh_.box.axes; ++a) {
            auto& share = out_.open.area[at(a)];
            for (std::size_t f = 0; f < share.size(); ++f) {
                const double open = 1 - std::max(below_[at(a)][f], above_[at(a)][f]);
                share[f] = open < closed_tolerance ? 0 : std::min(open, 1.0);
            }
        }
        for (double& v : out_.open.volume) {
            v = v < closed_tolerance ? 0 : v;
        }
    }

 private:
    void cut_cell(const PartPlanes& part, const GridBody& body, std::int32_t number, const std::array<int, 3>& place) {
        const Vec3 centre = mesh_.centre(place[0], place[1], place[2]);
        const Vec3 size{mesh_.h(0, place[0]), mesh_.h(1, place[1]), mesh_.h(2, place[2])};
        if (!part.planes_across(centre, size * 0.5, across_)) {
            return;
        }
        const std::int64_t cell = mesh_.box.index(place[0], place[1], place[2]);
        if (across_.empty()) {
            out_.open.volume[at(cell)] = 0;
            for (int a = 0; a < mesh_.box.axes; ++a) {
                above_[at(a)][at(cell)] = 1;
                below_[at(a)][at(cell + mesh_.box.stride[at(a)])] = 1;
            }
            return;
        }
        Polyhedron piece = geometry::moved(geometry::box(size), Pose{centre, Quat{}});
        for (const Plane& plane : across_) {
            piece = geometry::clip_convex(piece, plane);
            if (piece.faces.empty()) {
                return;
            }
        }
        const double volume = geometry::mass_properties(piece).volume;
        out_.open.volume[at(cell)] -= volume / (size.x * size.y * size.z);
        for (const auto& face : piece.faces) {
            add_face(piece, face, body, number, cell, centre, size);
        }
    }
    void add_face(const Polyhedron& piece, const std::vector<std::int32_t>& face, const GridBody& body,
                  std::int32_t number, std::int64_t cell, const Vec3& centre, const Vec3& size) {
        const Vec3 area = geometry::vector_area(piece.vertices, face);
        Vec3 mean{};
        for (const std::int32_t v : face) {
            mean += piece.vertices[at(v)] * (1.0 / static_cast<double>(face.size()));
        }
        for (int a = 0; a < 3; ++a) {  // on a side of the cell?
            const double away = (mean[a] - centre[a]) / size[a];
            const double whole = size.x * size.y * size.z / size[a];
            if (std::abs(std::abs(away) - 0.5) < 1e-9 && std::abs(area[a]) > (1 - 1e-9) * norm(area)) {
                if (a < mesh_.box.axes) {
                    const std::int64_t t = mesh_.box.stride[at(a)];
                    (away > 0 ? below_[at(a)][at(cell + t)] : above_[at(a)][at(cell)]) += std::abs(area[a]) / whole;
                }
                return;
            }
        }
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const Vec3 &p = piece.vertices[at(face[0])], &q = piece.vertices[at(face[i])],
                       &r = piece.vertices[at(face[i + 1])];
            const CutFacet facet{
                number, cell, cross(q - p, r - p) * 0.5, {(p + q) * 0.5, (q + r) * 0.5, (r + p) * 0.5}};
            out_.facets.push_back(facet);
            out_.open.displacement[at(cell)] -= dot(body.velocity_at(facet.place()), facet.area);
        }
    }
    void find_distances(const PartPlanes& part, const GridBody& body, std::int32_t number, std::array<int, 3> first,
                        std::array<int, 3> last) {
        for (int a = 0; a < mesh_.box.axes; ++a) {
            first[at(a)] = std::max(first[at(a)] - margin, -mesh_.box.pad[at(a)]);
            last[at(a)] = std::min(last[at(a)] + margin + 1, mesh_.box.cells[at(a)] + mesh_.box.pad[at(a)] - 1);
        }
        for (int a = 0; a < mesh_.box.axes; ++a) {
            for (int k = first[2]; k <= last[2]; ++k) {
                for (int j = first[1]; j <= last[1]; ++j) {
                    for (int i = first[0]; i <= last[0]; ++i) {
                        Vec3 x = mesh_.centre(i, j, k);
                        const int p = std::array{i, j, k}[at(a)];
                        x[a] -= 0.5 * mesh_.h(a, p);
                        const auto f = at(mesh_.box.index(i, j, k));
                        const double distance = part.distance(x);
                        if (distance < out_.open.wall_distance[at(a)][f]) {
                            out_.open.wall_distance[at(a)][f] = distance;
                            out_.open.body_velocity[at(a)][f] = body.velocity_at(x)[a];
                            out_.nearest[at(a)][f] = number;
                        }
                    }
                }
            }
        }
    }

    const Mesh& mesh_;
    CutBodies& out_;
    std::array<std::vector<double>, 3> below_, above_;  ///< closed share of a face, seen from either side
    std::vector<Plane> across_;
};

}  // namespace

CutBodies cut_bodies(const Mesh& mesh, const std::vector<GridBody>& bodies) {
    CutBodies cut;
    Cutter cutter(mesh, cut);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        cutter.cut(bodies[b], static_cast<std::int32_t>(b));
    }
    cutter.finish();
    return cut;
}

}  // namespace riprap::coupling
