// SPDX-License-Identifier: Apache-2.0
// Walls thinner than a cell: cells that they split, of which one side stays open.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "riprap/coupling/cut_cells/cell_sides.hpp"
#include "riprap/coupling/cut_cells/cutter.hpp"
#include "riprap/coupling/cut_cells/side_facets.hpp"
#include "riprap/fluid/grid/pockets.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::at;

/// Splits what hangs together by less of a side of a cell than this, where one body does it [-].
constexpr double least_passage = 1e-5;
/// Two parts of a side are one where their middles and shares differ by less [-].
constexpr double same_part = 1e-3;
/// A side whose closed share is below this is open, and one whose open share is below this is closed [-].
constexpr double untouched = 1e-9;
/// Most closed cells in a row that a facet looks through for water.
constexpr int most_cells_through = 4;

/// A component that one of the two cells of a face closes.
struct ClosedPart {
    int axis;
    std::int64_t face;
    bool is_below;  ///< in the cell below the face
    double share;
    Vec3 middle;  ///< in cell widths along the face
};

/// Returns the component of the cell beyond that a part of a side opens into: the one at its middle, a little past the
/// side.
std::int32_t component_beyond(const fluid::grid::Mesh& mesh, const SplitCell& split, const OpenPart& part,
                              const SplitCell& other) {
    Vec3 x = mesh.centre(split.place[0], split.place[1], split.place[2]);
    for (int a = 0; a < 3; ++a) {
        const double past = a == part.axis ? (part.is_high ? 1e-4 : -1e-4) : 0;
        x[a] += (part.middle[a] + past) * mesh.h(a, split.place[at(a)]);
    }
    return other.component_at(mesh, x);
}

}  // namespace

/// Whether what the parts leave open surely hangs together: one corner of the cell, or all of one side, sees all of it.
bool Cutter::hangs_together(std::span<const PartInCell> parts) const {
    const std::array<int, 3>& place = parts.front().place;
    const Vec3 centre = mesh_->centre(place[0], place[1], place[2]);
    const auto holds_for_all = [&](const auto& condition) {
        return std::all_of(parts.begin(), parts.end(), [&](const PartInCell& part) {
            const auto first = part_planes_.begin() + part.first;
            return std::all_of(first, first + part.count, condition);
        });
    };
    const int axes = mesh_->box.axes;
    for (int corner = 0; corner < 1 << axes; ++corner) {  // beyond all planes: the open rest is a star around it
        Vec3 x = centre;
        for (int a = 0; a < axes; ++a) {
            x[a] += ((corner >> a & 1) != 0 ? 0.5 : -0.5) * mesh_->h(a, place[at(a)]);
        }
        if (holds_for_all([&](const geometry::Plane& plane) { return dot(plane.normal, x) > plane.offset; })) {
            return true;
        }
    }
    const std::int64_t cell = parts.front().cell;
    for (int a = 0; a < axes; ++a) {  // no plane looks away from an open side: all that is open reaches it
        for (const double way : {-1.0, 1.0}) {
            const double closed =
                way > 0 ? below_[at(a)][at(cell + mesh_->box.stride[at(a)])] : above_[at(a)][at(cell)];
            if (closed < round_off_ &&
                holds_for_all([&](const geometry::Plane& plane) { return way * plane.normal[a] > -untouched; })) {
                return true;
            }
        }
    }
    return false;
}

std::span<const Cutter::PartInCell> Cutter::parts_in(std::int64_t cell) const {
    const auto by_cell = [](const PartInCell& a, const PartInCell& b) { return a.cell < b.cell; };
    const auto [first, last] = std::equal_range(parts_.begin(), parts_.end(), PartInCell{cell, {}, 0, 0, 0}, by_cell);
    return {first, last};
}

void Cutter::find_splits() {
    const auto by_cell = [](const PartInCell& a, const PartInCell& b) { return a.cell < b.cell; };
    const auto tail = parts_.begin() + static_cast<std::ptrdiff_t>(seen_);
    std::stable_sort(tail, parts_.end(), by_cell);
    std::vector<std::int64_t> cells;
    for (auto part = tail; part != parts_.end(); ++part) {
        if (cells.empty() || cells.back() != part->cell) {
            cells.push_back(part->cell);
        }
    }
    std::inplace_merge(parts_.begin(), tail, parts_.end(), by_cell);
    seen_ = parts_.size();
    std::erase_if(splits_,
                  [&](const SplitCell& split) { return std::binary_search(cells.begin(), cells.end(), split.cell); });
    std::vector<std::span<const geometry::Plane>> planes;
    for (const std::int64_t cell : cells) {
        const std::span<const PartInCell> parts = parts_in(cell);
        if (!(out_.open.volume[at(cell)] > 0) || hangs_together(parts)) {
            continue;
        }
        planes.clear();
        for (const PartInCell& part : parts) {
            planes.emplace_back(part_planes_.data() + part.first, part.count);
        }
        const double passage = touched_[at(cell)] == -2 ? joint_share : least_passage;
        if (auto split = split_cell(*mesh_, parts.front().place, planes, passage)) {
            splits_.push_back(std::move(*split));
        }
    }
    std::sort(splits_.begin(), splits_.end(), [](const SplitCell& a, const SplitCell& b) { return a.cell < b.cell; });
}

const SplitCell* Cutter::split_at(std::int64_t cell) const {
    const auto found = std::lower_bound(splits_.begin(), splits_.end(), cell,
                                        [](const SplitCell& split, std::int64_t c) { return split.cell < c; });
    return found != splits_.end() && found->cell == cell ? &*found : nullptr;
}

/// Tells whether a component of a split cell leads to the largest one through the cells around, as around the corner of
/// a block or the end of a wall.
bool Cutter::leads_around(const SplitCell& split, std::int32_t component) const {
    struct Node {
        std::int64_t cell;
        std::int32_t component;  ///< 0 in cells that are whole
        bool operator==(const Node&) const = default;
    };
    const fluid::grid::CellBox& box = mesh_->box;
    std::vector<Node> reached{{split.cell, component}};
    const auto reach = [&](const Node& node) {
        if (std::find(reached.begin(), reached.end(), node) == reached.end()) {
            reached.push_back(node);
        }
    };
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const Node now = reached[next];
        const SplitCell* own = split_at(now.cell);
        const std::array<int, 3> place = fluid::grid::place_of(box, now.cell);
        for_faces_of(box, place, [&](int a, std::int64_t face, int, bool is_high) {
            const std::int64_t cell = now.cell + (is_high ? 1 : -1) * box.stride[at(a)];
            std::array<int, 3> there = place;
            there[at(a)] += is_high ? 1 : -1;
            bool is_near = there[at(a)] >= 0 && there[at(a)] < box.cells[at(a)];
            for (int b = 0; b < box.axes; ++b) {
                is_near = is_near && std::abs(there[at(b)] - split.place[at(b)]) <= 1;
            }
            if (!is_near || !(out_.open.area[at(a)][at(face)] > 0) || !(out_.open.volume[at(cell)] > 0)) {
                return;
            }
            const auto is_part = [&](const OpenPart& part, bool high) {
                return part.axis == a && part.is_high == high && part.share > round_off_;
            };
            const SplitCell* other = split_at(cell);
            if (own == nullptr && other == nullptr) {
                reach({cell, 0});
            } else if (own == nullptr) {
                for (const OpenPart& part : other->sides) {
                    if (is_part(part, !is_high)) {
                        reach({cell, part.component});
                    }
                }
            } else {
                for (const OpenPart& part : own->sides) {
                    if (part.component == now.component && is_part(part, is_high)) {
                        reach({cell, other == nullptr ? 0 : component_beyond(*mesh_, *own, part, *other)});
                    }
                }
            }
        });
        if (std::find(reached.begin(), reached.end(), Node{split.cell, 0}) != reached.end()) {
            return true;
        }
    }
    return false;
}

/// One cell holds one fluid: what of a split cell does not lead around to its largest component is beyond a wall, and
/// closed.
void Cutter::find_walls() {
    for (SplitCell& split : splits_) {
        for (std::size_t c = 1; c < split.volume.size(); ++c) {
            const auto number = static_cast<std::int32_t>(c);
            const bool is_sliver = std::none_of(split.sides.begin(), split.sides.end(), [&](const OpenPart& part) {
                return part.component == number && part.share > round_off_;
            });
            split.is_closed[c] = is_sliver || leads_around(split, number) ? 0 : 1;
        }
    }
}

/// Closes what of split cells is beyond a wall, on their sides too. A part of a face that both of its
/// cells close counts once.
void Cutter::close_splits() {
    std::vector<ClosedPart> closed;
    for (const SplitCell& split : splits_) {
        for (std::size_t c = 0; c < split.volume.size(); ++c) {
            out_.open.volume[at(split.cell)] -= split.is_closed[c] != 0 ? split.volume[c] : 0;
        }
        for (const OpenPart& side : split.sides) {
            if (split.is_closed[at(side.component)] == 0) {
                continue;
            }
            Vec3 middle = side.middle;
            middle[side.axis] = 0;
            closed.push_back({side.axis, split.cell + (side.is_high ? mesh_->box.stride[at(side.axis)] : 0),
                              side.is_high, side.share, middle});
        }
    }
    std::stable_sort(closed.begin(), closed.end(), [](const ClosedPart& a, const ClosedPart& b) {
        return std::tie(a.axis, a.face) < std::tie(b.axis, b.face);
    });
    for (std::size_t i = 0; i < closed.size(); ++i) {
        const ClosedPart& part = closed[i];
        bool is_counted = false;
        for (std::size_t k = i; k-- > 0 && closed[k].face == part.face && closed[k].axis == part.axis;) {
            is_counted = is_counted ||
                         (closed[k].is_below != part.is_below && std::abs(closed[k].share - part.share) < same_part &&
                          norm(closed[k].middle - part.middle) < same_part);
        }
        double& open = out_.open.area[at(part.axis)][at(part.face)];
        open = is_counted ? open : open - part.share;
        open = open < round_off_ ? 0 : open;
    }
}

/// Returns the cell that a closed component of a split cell opens into: through the largest of its sides, and through
/// closed components beyond; -1: none.
std::int64_t Cutter::beyond(const SplitCell& split, std::int32_t component) const {
    const SplitCell* now = &split;
    for (int step = 0; step < most_cells_through; ++step) {
        const OpenPart* widest = nullptr;
        for (const OpenPart& side : now->sides) {
            const std::int64_t t = mesh_->box.stride[at(side.axis)], cell = now->cell + (side.is_high ? t : -t);
            const bool is_there = mesh_->box.has_cell(cell) && out_.open.volume[at(cell)] > 0;
            if (side.component == component && is_there && (widest == nullptr || side.share > widest->share)) {
                widest = &side;
            }
        }
        if (widest == nullptr) {
            return -1;
        }
        const std::int64_t t = mesh_->box.stride[at(widest->axis)], cell = now->cell + (widest->is_high ? t : -t);
        const SplitCell* next = split_at(cell);
        if (next == nullptr) {
            return cell;
        }
        component = component_beyond(*mesh_, *now, *widest, *next);
        if (component < 0 || next->is_closed[at(component)] == 0) {
            return cell;
        }
        now = next;
    }
    return -1;
}

/// Lets facets on the closed side of a thin wall look at the cell beyond: they feel its pressure, and what they
/// displace is its water.
void Cutter::turn_facets() {
    bool has_turned = false;
    for (CutFacet& facet : out_.facets) {
        const SplitCell* split = splits_.empty() ? nullptr : split_at(facet.cell);
        if (split == nullptr) {
            continue;
        }
        const Vec3 n = facet.area / norm(facet.area);
        const double out =
            1e-6 * (std::abs(n.x) * mesh_->h(0, split->place[0]) + std::abs(n.y) * mesh_->h(1, split->place[1]) +
                    (mesh_->box.axes == 3 ? std::abs(n.z) * mesh_->h(2, split->place[2]) : 0));
        const std::int32_t component = split->component_at(*mesh_, facet.place() + out * n);
        const bool is_closed = component >= 0 && split->is_closed[at(component)] != 0;
        const std::int64_t cell = is_closed ? beyond(*split, component) : -1;
        if (cell >= 0) {
            facet.cell = cell;
            facet.joint = behind_wall;
            has_turned = true;
        }
    }
    if (has_turned) {
        sort_facets();
    }
}

}  // namespace riprap::coupling
