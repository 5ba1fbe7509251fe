// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cutter.hpp"

#include <algorithm>
#include <tuple>

#include "riprap/coupling/cut_cells/cell_sides.hpp"
#include "riprap/coupling/cut_cells/joint_ways.hpp"
#include "riprap/fluid/grid/datum.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;
using fluid::grid::Mesh;
using geometry::Polyhedron;
/// Cells around a body in which faces know their distance from it.
constexpr int margin = 2;

/// A piece that is so flat has both of its faces on one side of the cell, where they are told apart no more: a body
/// that has moved by rounding beyond cells that it fills would seem to end behind itself.
/// @param round_off  a face of a piece lies on a side of its cell where it is nearer to it than this share of the cell
bool is_flat(const Polyhedron& piece, const Vec3& size, int axes, double round_off) {
    for (int a = 0; a < axes; ++a) {
        const auto [low, high] = std::minmax_element(piece.vertices.begin(), piece.vertices.end(),
                                                     [a](const Vec3& x, const Vec3& y) { return x[a] < y[a]; });
        if ((*high)[a] - (*low)[a] < 2 * round_off * size[a]) {
            return true;
        }
    }
    return false;
}

}  // namespace

Cutter::Cutter(const Mesh& mesh) : mesh_(&mesh), round_off_(fluid::grid::share_of_round_off(mesh)) {
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
    const std::vector<PartPlanes> parts = parts_of(body, mesh_->box.axes);
    note_sides(parts, number);
    for (const PartPlanes& part : parts) {
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

void Cutter::note_sides(const std::vector<PartPlanes>& parts, std::int32_t number) {
    on_sides_.resize(std::max(on_sides_.size(), at(number + 1)), 0);
    std::uint8_t& bits = on_sides_[at(number)];
    bits = 0xff;
    for (const PartPlanes& part : parts) {
        for (int a = 0; a < mesh_->box.axes; ++a) {
            const auto& edge = mesh_->edge[at(a)];
            if (part.low[a] < edge.front() - 0.5 * mesh_->h(a, 0)) {
                bits = static_cast<std::uint8_t>(bits & ~(1U << (2 * a)));
            }
            if (part.high[a] > edge.back() + 0.5 * mesh_->h(a, mesh_->box.cells[at(a)] - 1)) {
                bits = static_cast<std::uint8_t>(bits & ~(1U << (2 * a + 1)));
            }
        }
    }
}

void Cutter::close_cell(std::int32_t number, const std::array<int, 3>& place) {
    const std::int64_t cell = mesh_->box.index(place[0], place[1], place[2]);
    out_.open.volume[at(cell)] = 0;
    std::int32_t& first = filled_[at(cell)];
    if (first == -1) {
        first = number;
        filled_cells_.push_back({place, number});
    } else if (first != number) {
        filled_again_.emplace_back(cell, number);
        filled_cells_.push_back({place, number});
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
    if (is_flat(piece, size, mesh_->box.axes, round_off_)) {
        return;
    }
    touched = touched == -1 || touched == number ? number : -2;
    parts_.push_back({cell, place, number, static_cast<std::uint32_t>(part_planes_.size()),
                      static_cast<std::uint32_t>(across_.size())});
    part_planes_.insert(part_planes_.end(), across_.begin(), across_.end());
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
        if (std::abs(std::abs(away) - 0.5) >= round_off_ || std::abs(area[a]) <= (1 - 1e-9) * norm(area)) {
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

void Cutter::sort_facets() {
    std::stable_sort(out_.facets.begin(), out_.facets.end(), [](const CutFacet& a, const CutFacet& b) {
        return std::tie(a.body, a.cell) < std::tie(b.body, b.cell);
    });
}

/// Adds what bodies show on sides of the domain, after joints have been closed for the others.
void Cutter::show_sides() {
    if (!side_facets_.empty()) {
        out_.facets.insert(out_.facets.end(), side_facets_.begin(), side_facets_.end());
        sort_facets();
    }
}

CutBodies Cutter::finish(const std::vector<GridBody>& bodies) && {
    find_splits();
    show_filled_cells();
    show_faces();
    sort_facets();
    drop_covered_facets();
    close_shares();
    turn_facets();
    close_joints();
    show_sides();
    find_displacement(out_.facets, bodies, out_.open);
    find_joint_ways(*mesh_, {below_, above_}, out_);
    list_near_faces();
    return std::move(out_);
}

}  // namespace riprap::coupling
