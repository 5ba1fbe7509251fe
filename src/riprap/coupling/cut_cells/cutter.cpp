// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cutter.hpp"

#include <algorithm>
#include <tuple>

#include "riprap/geometry/clip.hpp"
#include "riprap/geometry/shapes.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;
using fluid::grid::Mesh;
using geometry::Polyhedron;

/// A closed share above 1 less this is 1: slivers of a face that no flow comes through [-].
constexpr double closed_tolerance = 1e-9;
/// A gap between two bodies that leaves less than this of a cell or of a face is a joint [-].
constexpr double joint_share = 0.05;
/// Cells around a body in which faces know their distance from it.
constexpr int margin = 2;

/// Calls f(a, face, place, is_below) for the faces of a cell; is_below: the cell is below the face.
template <class F>
void for_faces_of(const CellBox& box, const std::array<int, 3>& place, const F& f) {
    const std::int64_t cell = box.index(place[0], place[1], place[2]);
    for (int a = 0; a < box.axes; ++a) {
        f(a, cell, place[at(a)], false);
        f(a, cell + box.stride[at(a)], place[at(a)] + 1, true);
    }
}

std::array<Vec3, 3> middles(const Vec3& p, const Vec3& q, const Vec3& r) {
    return {(p + q) * 0.5, (q + r) * 0.5, (r + p) * 0.5};
}

}  // namespace

Cutter::Cutter(const Mesh& mesh) : mesh_(&mesh) {
    const auto size = at(mesh.box.size);
    out_.open.has_bodies = true;
    out_.open.volume.assign(size, 1.0);
    filled_.assign(size, -1);
    touched_.assign(size, -1);
    for (int a = 0; a < 3; ++a) {
        out_.open.area[at(a)].assign(size, 1.0);
        out_.open.body_velocity[at(a)].assign(size, 0.0F);
        out_.open.wall_distance[at(a)].assign(size, 1e30F);
        out_.nearest[at(a)].assign(size, -1);
        below_[at(a)].assign(size, 0.0);
        above_[at(a)].assign(size, 0.0);
    }
}

void Cutter::cut(const GridBody& body, std::int32_t number) {
    for (const PartPlanes& part : parts_of(body)) {
        std::array<int, 3> first{}, last{};
        for (int a = 0; a < 3; ++a) {
            first[at(a)] = a < mesh_->box.axes ? mesh_->cell_at(a, part.low[a]) : 0;
            last[at(a)] = a < mesh_->box.axes ? mesh_->cell_at(a, part.high[a]) : 0;
        }
        for (int k = first[2]; k <= last[2]; ++k) {
            for (int j = first[1]; j <= last[1]; ++j) {
                for (int i = first[0]; i <= last[0]; ++i) {
                    cut_cell(part, number, {i, j, k});
                }
            }
        }
        find_distances(part, body, number, first, last);
    }
}

void Cutter::close_cell(std::int32_t number, const std::array<int, 3>& place) {
    const std::int64_t cell = mesh_->box.index(place[0], place[1], place[2]);
    out_.open.volume[at(cell)] = 0;
    if (filled_[at(cell)] == -1) {
        filled_[at(cell)] = number;
        filled_cells_.push_back(place);
    }
    for_faces_of(mesh_->box, place, [&](int a, std::int64_t face, int, bool is_below) {
        (is_below ? below_ : above_)[at(a)][at(face)] = 1;
    });
}

void Cutter::cut_cell(const PartPlanes& part, std::int32_t number, const std::array<int, 3>& place) {
    const Vec3 centre = mesh_->centre(place[0], place[1], place[2]);
    const Vec3 size{mesh_->h(0, place[0]), mesh_->h(1, place[1]), mesh_->h(2, place[2])};
    if (!part.planes_across(centre, size * 0.5, across_)) {
        return;
    }
    const std::int64_t cell = mesh_->box.index(place[0], place[1], place[2]);
    std::int32_t& touched = touched_[at(cell)];
    if (across_.empty()) {
        touched = touched == -1 || touched == number ? number : -2;
        close_cell(number, place);
        return;
    }
    Polyhedron piece = geometry::moved(geometry::box(size), Pose{centre, Quat{}});
    for (const geometry::Plane& plane : across_) {
        piece = geometry::clip_convex(piece, plane);
        if (piece.faces.empty()) {
            return;
        }
    }
    touched = touched == -1 || touched == number ? number : -2;
    out_.open.volume[at(cell)] -= geometry::mass_properties(piece).volume / (size.x * size.y * size.z);
    for (const auto& face : piece.faces) {
        add_face(piece, face, number, place);
    }
}

void Cutter::add_face(const Polyhedron& piece, const std::vector<std::int32_t>& face, std::int32_t number,
                      const std::array<int, 3>& place) {
    const CellBox& box = mesh_->box;
    const std::int64_t cell = box.index(place[0], place[1], place[2]);
    const Vec3 centre = mesh_->centre(place[0], place[1], place[2]);
    const Vec3 area = geometry::vector_area(piece.vertices, face);
    Vec3 mean{};
    for (const std::int32_t v : face) {
        mean += piece.vertices[at(v)] * (1.0 / static_cast<double>(face.size()));
    }
    const auto triangles = [&](const auto& use) {
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const Vec3 &p = piece.vertices[at(face[0])], &q = piece.vertices[at(face[i])],
                       &r = piece.vertices[at(face[i + 1])];
            use(cross(q - p, r - p) * 0.5, middles(p, q, r));
        }
    };
    for (int a = 0; a < 3; ++a) {
        const double away = (mean[a] - centre[a]) / mesh_->h(a, place[at(a)]);
        if (std::abs(std::abs(away) - 0.5) >= 1e-9 || std::abs(area[a]) <= (1 - 1e-9) * norm(area)) {
            continue;
        }
        if (a < box.axes) {  // on a side of the cell
            const bool is_below = away > 0;
            const std::int64_t f = is_below ? cell + box.stride[at(a)] : cell;
            const int p = place[at(a)] + (is_below ? 1 : 0);
            (is_below ? below_ : above_)[at(a)][at(f)] +=
                std::abs(area[a]) / mesh_->face_area(a, place[0], place[1], place[2]);
            triangles([&](const Vec3& part, const std::array<Vec3, 3>& middle) {
                on_faces_.push_back({f, number, static_cast<std::int8_t>(a), is_below,
                                     p == (is_below ? box.cells[at(a)] : 0), std::abs(part[a]), middle});
            });
        }
        return;
    }
    triangles([&](const Vec3& part, const std::array<Vec3, 3>& middle) {
        out_.facets.push_back({number, cell, part, middle, -1});
    });
}

void Cutter::find_distances(const PartPlanes& part, const GridBody& body, std::int32_t number, std::array<int, 3> first,
                            std::array<int, 3> last) {
    for (int a = 0; a < mesh_->box.axes; ++a) {
        first[at(a)] = std::max(first[at(a)] - margin, -mesh_->box.pad[at(a)]);
        last[at(a)] = std::min(last[at(a)] + margin + 1, mesh_->box.cells[at(a)] + mesh_->box.pad[at(a)] - 1);
    }
    for (int a = 0; a < mesh_->box.axes; ++a) {
        for (int k = first[2]; k <= last[2]; ++k) {
            for (int j = first[1]; j <= last[1]; ++j) {
                for (int i = first[0]; i <= last[0]; ++i) {
                    Vec3 x = mesh_->centre(i, j, k);
                    const int p = std::array{i, j, k}[at(a)];
                    x[a] -= 0.5 * mesh_->h(a, p);
                    const auto f = at(mesh_->box.index(i, j, k));
                    const auto distance = static_cast<float>(part.distance(x));
                    if (distance < out_.open.wall_distance[at(a)][f]) {
                        out_.open.wall_distance[at(a)][f] = distance;
                        out_.open.body_velocity[at(a)][f] = static_cast<float>(body.velocity_at(x)[a]);
                        out_.nearest[at(a)][f] = number;
                    }
                }
            }
        }
    }
}

/// Filled cells show their sides where the same body does not fill what lies beyond.
void Cutter::show_filled_cells() {
    const CellBox& box = mesh_->box;
    for (const std::array<int, 3>& place : filled_cells_) {
        const std::int64_t cell = box.index(place[0], place[1], place[2]);
        const std::int32_t number = filled_[at(cell)];
        const Vec3 centre = mesh_->centre(place[0], place[1], place[2]);
        for_faces_of(box, place, [&](int a, std::int64_t face, int p, bool is_below) {
            const bool is_on_rim = p == (is_below ? box.cells[at(a)] : 0);
            if (is_on_rim || filled_[at(is_below ? face : face - box.stride[at(a)])] == number) {
                return;
            }
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            Vec3 middle = centre, u{}, v{};
            middle[a] += (is_below ? 0.5 : -0.5) * mesh_->h(a, place[at(a)]);
            u[b] = 0.5 * mesh_->h(b, place[at(b)]);
            v[c] = 0.5 * mesh_->h(c, place[at(c)]);
            const double half = 0.5 * mesh_->face_area(a, place[0], place[1], place[2]);
            const auto axis = static_cast<std::int8_t>(a);
            on_faces_.push_back(
                {face, number, axis, is_below, false, half, middles(middle - u - v, middle + u - v, middle + u + v)});
            on_faces_.push_back(
                {face, number, axis, is_below, false, half, middles(middle - u - v, middle + u + v, middle - u + v)});
        });
    }
}

/// A body's surface lies on a face by as much as the body is on one side more than on the other: sections through it
/// cancel.
void Cutter::show_faces() {
    std::stable_sort(on_faces_.begin(), on_faces_.end(), [](const OnFace& a, const OnFace& b) {
        return std::tie(a.axis, a.face, a.body) < std::tie(b.axis, b.face, b.body);
    });
    for (std::size_t i = 0; i < on_faces_.size();) {
        std::size_t end = i;
        double below = 0, above = 0;
        const OnFace& first = on_faces_[i];
        for (; end < on_faces_.size() && on_faces_[end].face == first.face && on_faces_[end].axis == first.axis &&
               on_faces_[end].body == first.body;
             ++end) {
            (on_faces_[end].is_below ? below : above) += on_faces_[end].area;
        }
        const double net = below - above, most = std::max(below, above);
        if (std::abs(net) > closed_tolerance * most && !first.is_on_rim) {
            const bool is_below = net > 0;
            const std::int64_t stride = mesh_->box.stride[at(first.axis)];
            for (std::size_t k = i; k < end; ++k) {
                if (on_faces_[k].is_below == is_below) {
                    Vec3 area{};
                    area[first.axis] = net / most * on_faces_[k].area;
                    out_.facets.push_back(
                        {first.body, is_below ? first.face : first.face - stride, area, on_faces_[k].middle, -1});
                }
            }
        }
        i = end;
    }
}

void Cutter::close_shares() {
    for (int a = 0; a < mesh_->box.axes; ++a) {
        auto& share = out_.open.area[at(a)];
        for (std::size_t f = 0; f < share.size(); ++f) {
            const double open = 1 - std::max(below_[at(a)][f], above_[at(a)][f]);
            share[f] = open < closed_tolerance ? 0 : std::min(open, 1.0);
        }
    }
    for (double& v : out_.open.volume) {
        v = v < closed_tolerance ? 0 : v;
    }
    // a cell without room has no equation that would balance what drives a flow through a face of it: bodies pressed
    // on each other fill a cell by more than its volume and leave some of a face open
    for (int a = 0; a < mesh_->box.axes; ++a) {
        const std::int64_t stride = mesh_->box.stride[at(a)];
        fluid::grid::for_faces(mesh_->box, a, [&](std::int64_t f, int, int, int) {
            if (out_.open.volume[at(f)] == 0 || out_.open.volume[at(f - stride)] == 0) {
                out_.open.area[at(a)][at(f)] = 0;
            }
        });
    }
}

/// A narrow rest of a cell with bodies on two sides of it.
bool Cutter::is_joint(std::int64_t cell) const {
    const double open = out_.open.volume[at(cell)];
    if (open <= 0 || open >= joint_share) {
        return false;
    }
    const std::int32_t own = touched_[at(cell)];
    if (own == -2) {
        return true;
    }
    for (int a = 0; a < mesh_->box.axes; ++a) {
        const std::int64_t t = mesh_->box.stride[at(a)];
        const auto other = [&](std::int64_t beyond) {
            return touched_[at(beyond)] != -1 && touched_[at(beyond)] != own;
        };
        if ((below_[at(a)][at(cell)] > 0.5 && other(cell - t)) ||
            (above_[at(a)][at(cell + t)] > 0.5 && other(cell + t))) {
            return true;
        }
    }
    return false;
}

/// A narrow rest of the face below a cell with two bodies in the cells on its sides. All that bodies displace on one
/// side of it might have to come through, at any speed.
bool Cutter::is_narrow(int a, std::int64_t cell) const {
    const double open = out_.open.area[at(a)][at(cell)];
    if (open <= 0 || open >= joint_share) {
        return false;
    }
    const std::int32_t below = touched_[at(cell - mesh_->box.stride[at(a)])], above = touched_[at(cell)];
    return below == -2 || above == -2 || (below != -1 && above != -1 && below != above);
}

void Cutter::close_joints() {
    std::vector<std::int64_t> joints;
    std::vector<std::pair<int, std::int64_t>> narrow;
    for (const CutFacet& facet : out_.facets) {
        if (is_joint(facet.cell)) {
            joints.push_back(facet.cell);
        }
        for (int a = 0; a < mesh_->box.axes; ++a) {
            for (const std::int64_t face : {facet.cell, facet.cell + mesh_->box.stride[at(a)]}) {
                if (is_narrow(a, face)) {
                    narrow.emplace_back(a, face);
                }
            }
        }
    }
    for (const auto& [a, face] : narrow) {
        out_.open.area[at(a)][at(face)] = 0;
    }
    for (const std::int64_t cell : joints) {
        out_.open.volume[at(cell)] = 0;
        for (int a = 0; a < mesh_->box.axes; ++a) {
            out_.open.area[at(a)][at(cell)] = out_.open.area[at(a)][at(cell + mesh_->box.stride[at(a)])] = 0;
        }
    }
}

/// Closed cells that facets look into get their water from the nearest open cells, through closed cells beside them.
void Cutter::find_joints() {
    const CellBox& box = mesh_->box;
    const auto for_neighbours = [&](std::int64_t cell, const auto& f) {
        for (int a = 0; a < box.axes; ++a) {
            f(cell - box.stride[at(a)]);
            f(cell + box.stride[at(a)]);
        }
    };
    std::vector<std::int64_t> cells;
    for (const CutFacet& facet : out_.facets) {
        if (out_.open.volume[at(facet.cell)] == 0) {
            cells.push_back(facet.cell);
            for_neighbours(facet.cell, [&](std::int64_t beside) {
                if (out_.open.volume[at(beside)] == 0) {
                    cells.push_back(beside);
                }
            });
        }
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    constexpr std::int32_t unknown = -1;
    std::vector<std::int32_t> number(cells.size(), unknown);
    const auto place_of = [&](std::int64_t cell) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
        return found != cells.end() && *found == cell ? found - cells.begin() : std::ptrdiff_t{-1};
    };
    for (bool is_first = true;; is_first = false) {
        const std::size_t before = out_.joints.size();
        std::vector<std::size_t> reached;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (number[i] != unknown) {
                continue;
            }
            JointCell joint{cells[i], {}};
            for_neighbours(cells[i], [&](std::int64_t beside) {
                const std::ptrdiff_t known = place_of(beside);
                if (is_first && out_.open.volume[at(beside)] > 0 && box.has_cell(beside)) {
                    joint.sources.push_back(beside);
                } else if (!is_first && known >= 0 && number[at(known)] != unknown) {
                    joint.sources.push_back(-1 - number[at(known)]);
                }
            });
            if (!joint.sources.empty()) {
                out_.joints.push_back(std::move(joint));
                reached.push_back(i);
            }
        }
        for (std::size_t k = 0; k < reached.size(); ++k) {
            number[reached[k]] = static_cast<std::int32_t>(before + k);
        }
        if (reached.empty()) {
            break;
        }
    }
    for (CutFacet& facet : out_.facets) {
        if (out_.open.volume[at(facet.cell)] == 0) {
            facet.joint = number[at(place_of(facet.cell))];
        }
    }
}

void Cutter::list_near_faces() {
    const CellBox& box = mesh_->box;
    for (int a = 0; a < box.axes; ++a) {
        std::array<int, 3> last = box.cells;
        last[at(a)] += 1;
        for (int k = 0; k < last[2]; ++k) {
            for (int j = 0; j < last[1]; ++j) {
                for (int i = 0; i < last[0]; ++i) {
                    const std::int64_t f = box.index(i, j, k);
                    if (out_.nearest[at(a)][at(f)] >= 0) {
                        out_.near_faces.push_back({a, f, {i, j, k}});
                    }
                }
            }
        }
    }
}

CutBodies Cutter::finish(const std::vector<GridBody>& bodies) && {
    show_filled_cells();
    show_faces();
    std::stable_sort(out_.facets.begin(), out_.facets.end(), [](const CutFacet& a, const CutFacet& b) {
        return std::tie(a.body, a.cell) < std::tie(b.body, b.cell);
    });
    close_shares();
    close_joints();
    find_displacement(out_.facets, bodies, out_.open);
    find_joints();
    list_near_faces();
    return std::move(out_);
}

}  // namespace riprap::coupling
