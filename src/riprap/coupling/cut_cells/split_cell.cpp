// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/split_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using geometry::Plane;
using geometry::Polyhedron;

/// Pieces smaller than this share of a cell are left out: their sides are smaller than what counts as open [-].
constexpr double least_piece = 1e-15;
/// Pieces nearer to each other than this touch: a wall thinner than this share of a cell holds nothing [-].
constexpr double near = 1e-6;
/// A component that is larger by less than this is as large [-].
constexpr double as_large = 0.01;

/// Planes in cell coordinates.
struct CellFrame {
    Vec3 centre, size;

    CellFrame(const fluid::grid::Mesh& mesh, const std::array<int, 3>& place)
        : centre(mesh.centre(place[0], place[1], place[2])),
          size{mesh.h(0, place[0]), mesh.h(1, place[1]), mesh.h(2, place[2])} {}
    Plane of(const Plane& plane) const {
        const Vec3 n{plane.normal.x * size.x, plane.normal.y * size.y, plane.normal.z * size.z};
        const double length = norm(n);
        return {n / length, (plane.offset - dot(plane.normal, centre)) / length};
    }
    Vec3 of(const Vec3& x) const {
        return {(x.x - centre.x) / size.x, (x.y - centre.y) / size.y, (x.z - centre.z) / size.z};
    }
};

double volume_of(const Polyhedron& piece) { return piece.faces.empty() ? 0 : geometry::mass_properties(piece).volume; }

std::vector<Plane> planes_of(const Polyhedron& piece) {
    std::vector<Plane> planes;
    planes.reserve(piece.faces.size());
    for (const auto& face : piece.faces) {
        if (norm(geometry::vector_area(piece.vertices, face)) > 0) {
            planes.push_back(geometry::face_plane(piece.vertices, face));
        }
    }
    return planes;
}

/// Takes a part out of pieces; what is left of each are convex pieces again.
std::vector<Polyhedron> take_out(const std::vector<Plane>& part, std::vector<Polyhedron> pieces) {
    std::vector<Polyhedron> left;
    for (Polyhedron& piece : pieces) {
        Polyhedron inside = piece;
        for (const Plane& plane : part) {
            inside = inside.faces.empty() ? inside : geometry::clip_convex(inside, plane);
        }
        if (volume_of(inside) < least_piece) {
            left.push_back(std::move(piece));
            continue;
        }
        for (const Plane& plane : part) {
            geometry::CutPieces cut = geometry::cut_convex(piece, plane);
            if (volume_of(cut.above) >= least_piece) {
                left.push_back(std::move(cut.above));
            }
            if (cut.below.faces.empty()) {
                break;
            }
            piece = std::move(cut.below);
        }
    }
    return left;
}

/// Whether two pieces share an area: one reaches into the other blown up by `near` with as much volume.
bool touch(const Polyhedron& piece, const std::vector<Plane>& other, double passage) {
    Polyhedron common = piece;
    for (const Plane& plane : other) {
        common = geometry::clip_convex(common, {plane.normal, plane.offset + near});
        if (common.faces.empty()) {
            return false;
        }
    }
    return volume_of(common) > near * passage;
}

/// Numbers the components of pieces, in the order of their first piece.
std::vector<std::int32_t> components_of(const std::vector<Polyhedron>& pieces,
                                        const std::vector<std::vector<Plane>>& planes, double passage) {
    constexpr std::int32_t unknown = -1;
    std::vector<std::int32_t> component(pieces.size(), unknown);
    std::int32_t count = 0;
    for (std::size_t start = 0; start < pieces.size(); ++start) {
        if (component[start] != unknown) {
            continue;
        }
        std::vector<std::size_t> reached{start};
        component[start] = count;
        for (std::size_t next = 0; next < reached.size(); ++next) {
            for (std::size_t i = 0; i < pieces.size(); ++i) {
                if (component[i] == unknown && touch(pieces[i], planes[reached[next]], passage)) {
                    component[i] = count;
                    reached.push_back(i);
                }
            }
        }
        ++count;
    }
    return component;
}

/// Volume of a component, and where it lies between the low corner of the cell and the high one.
struct Weight {
    double volume{0}, moment{0};
};

/// The component that stays open.
std::int32_t largest(const std::vector<Polyhedron>& pieces, const std::vector<std::int32_t>& component) {
    std::vector<Weight> weight(at(*std::max_element(component.begin(), component.end())) + 1);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const geometry::MassProperties mass = geometry::mass_properties(pieces[i]);
        Weight& of = weight[at(component[i])];
        of.volume += mass.volume;
        of.moment += mass.volume * dot(mass.centroid, Vec3{1, 1, 1});
    }
    std::size_t best = 0;
    for (std::size_t c = 1; c < weight.size(); ++c) {
        const bool is_lower = weight[c].moment / weight[c].volume < weight[best].moment / weight[best].volume;
        const double margin = is_lower ? 1 / (1 + as_large) : 1 + as_large;
        best = weight[c].volume > margin * weight[best].volume ? c : best;
    }
    return static_cast<std::int32_t>(best);
}

/// Centroid of a face, by the triangles at its first vertex.
Vec3 centroid_of(const Polyhedron& piece, const std::vector<std::int32_t>& face) {
    const Vec3 whole = geometry::vector_area(piece.vertices, face), &p = piece.vertices[at(face[0])];
    Vec3 sum{};
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const Vec3 &q = piece.vertices[at(face[i])], &r = piece.vertices[at(face[i + 1])];
        sum += dot(cross(q - p, r - p), whole) / 6 * (p + q + r);
    }
    const double size = dot(whole, whole);
    return size > 0 ? sum / size : p;
}

/// Adds what a piece has of the sides of its cell.
void add_sides(const Polyhedron& piece, std::int32_t component, int axes, std::vector<OpenPart>& sides) {
    for (const auto& face : piece.faces) {
        const Vec3 middle = centroid_of(piece, face);
        for (int a = 0; a < axes; ++a) {
            const double area = std::abs(geometry::vector_area(piece.vertices, face)[a]);
            const bool is_on_side = std::all_of(face.begin(), face.end(), [&](std::int32_t v) {
                return std::abs(std::abs(piece.vertices[at(v)][a]) - 0.5) < 1e-9;
            });
            if (!is_on_side || std::abs(std::abs(middle[a]) - 0.5) > 1e-9) {
                continue;
            }
            const bool is_high = middle[a] > 0;
            const auto same = std::find_if(sides.begin(), sides.end(), [&](const OpenPart& side) {
                return side.axis == a && side.is_high == is_high && side.component == component;
            });
            if (same == sides.end()) {
                sides.push_back({static_cast<std::int8_t>(a), is_high, component, area, middle});
            } else {
                same->middle = (same->share * same->middle + area * middle) / (same->share + area);
                same->share += area;
            }
        }
    }
}

}  // namespace

std::int32_t SplitCell::component_at(const fluid::grid::Mesh& mesh, const Vec3& x) const {
    const Vec3 place_in_cell = CellFrame(mesh, place).of(x);
    for (const Piece& piece : pieces) {
        if (std::all_of(piece.planes.begin(), piece.planes.end(), [&](const Plane& plane) {
                return dot(plane.normal, place_in_cell) <= plane.offset + 0.1 * near;
            })) {
            return piece.component;
        }
    }
    return -1;
}

std::optional<SplitCell> split_cell(const fluid::grid::Mesh& mesh, const std::array<int, 3>& place,
                                    std::span<const std::span<const Plane>> parts, double passage) {
    const CellFrame frame(mesh, place);
    std::vector<Polyhedron> pieces{geometry::box({1, 1, 1})};
    for (const std::span<const Plane> part : parts) {
        std::vector<Plane> planes;
        for (const Plane& plane : part) {
            planes.push_back(frame.of(plane));
        }
        pieces = take_out(planes, std::move(pieces));
    }
    if (pieces.size() < 2) {
        return std::nullopt;
    }
    std::vector<std::vector<Plane>> planes;
    for (const Polyhedron& piece : pieces) {
        planes.push_back(planes_of(piece));
    }
    std::vector<std::int32_t> component = components_of(pieces, planes, passage);
    if (*std::max_element(component.begin(), component.end()) == 0) {
        return std::nullopt;
    }
    const std::int32_t open = largest(pieces, component);
    const auto count = at(*std::max_element(component.begin(), component.end()) + 1);
    SplitCell split{mesh.box.index(place[0], place[1], place[2]),
                    place,
                    std::vector<double>(count),
                    std::vector<std::uint8_t>(count),
                    {},
                    {}};
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        std::int32_t& number = component[i];
        number = number == open ? 0 : number < open ? number + 1 : number;  // the open one first
        split.volume[at(number)] += volume_of(pieces[i]);
        add_sides(pieces[i], number, mesh.box.axes, split.sides);
        split.pieces.push_back({std::move(planes[i]), number});
    }
    return split;
}

}  // namespace riprap::coupling
