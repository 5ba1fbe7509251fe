// SPDX-License-Identifier: Apache-2.0
// Faces of the mesh: what bodies show on them, and the shares that they leave open.
#include <algorithm>
#include <tuple>

#include "riprap/coupling/cut_cells/cell_sides.hpp"
#include "riprap/coupling/cut_cells/cutter.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;
using fluid::grid::CellBox;

}  // namespace

bool Cutter::fills(std::int32_t body, std::int64_t cell) const {
    return filled_[at(cell)] == body ||
           std::binary_search(filled_again_.begin(), filled_again_.end(), std::pair{cell, body});
}

/// Filled cells show their sides where the same body does not fill what lies beyond.
void Cutter::show_filled_cells() {
    const CellBox& box = mesh_->box;
    std::sort(filled_again_.begin(), filled_again_.end());
    for (const FilledCell& filled : filled_cells_) {
        const std::array<int, 3>& place = filled.place;
        const std::int32_t number = filled.body;
        const Vec3 centre = mesh_->centre(place[0], place[1], place[2]);
        for_faces_of(box, place, [&](int a, std::int64_t face, int p, bool is_below) {
            const bool is_on_rim = p == (is_below ? box.cells[at(a)] : 0);
            if (!is_on_rim && fills(number, is_below ? face : face - box.stride[at(a)])) {
                return;
            }
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            Vec3 middle = centre, u{}, v{};
            middle[a] += (is_below ? 0.5 : -0.5) * mesh_->h(a, place[at(a)]);
            u[b] = 0.5 * mesh_->h(b, place[at(b)]);
            v[c] = 0.5 * mesh_->h(c, place[at(c)]);
            const double half = 0.5 * mesh_->face_area(a, place[0], place[1], place[2]);
            const auto axis = static_cast<std::int8_t>(a);
            on_faces_.push_back({face, number, axis, is_below, is_on_rim, half,
                                 middles(middle - u - v, middle + u - v, middle + u + v)});
            on_faces_.push_back({face, number, axis, is_below, is_on_rim, half,
                                 middles(middle - u - v, middle + u + v, middle - u + v)});
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
        const bool is_below = net > 0;
        const int side = 2 * first.axis + (is_below ? 1 : 0);
        const bool is_shown = !first.is_on_rim || (on_sides_[at(first.body)] >> side & 1) != 0;
        if (std::abs(net) > round_off_ * most && is_shown) {
            const std::int64_t stride = mesh_->box.stride[at(first.axis)];
            const std::int64_t cell =
                is_below != first.is_on_rim ? first.face : first.face - stride;  // inside on a rim
            for (std::size_t k = i; k < end; ++k) {
                if (on_faces_[k].is_below == is_below) {
                    Vec3 area{};
                    area[first.axis] = net / most * on_faces_[k].area;
                    (first.is_on_rim ? side_facets_ : out_.facets)
                        .push_back({first.body, cell, area, on_faces_[k].middle, first.is_on_rim ? on_side : -1});
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
            share[f] = open < round_off_ ? 0 : std::min(open, 1.0);
        }
    }
    find_walls();
    close_splits();
    for (double& v : out_.open.volume) {
        v = v < round_off_ ? 0 : v;
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

}  // namespace riprap::coupling
