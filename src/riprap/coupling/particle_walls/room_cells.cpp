// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/room_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/particle_walls/passage.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double cell_size = 0.5;  ///< of a spacing
constexpr double margin = 2.5;     ///< spacings of cells about the water: a wall within two of it is seen
constexpr double far = 2;          ///< spacings from which on the distance of a solid does not matter
constexpr double core_gap = 0.45;  ///< of a cell: nearer to a face no room goes on, round-off apart
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The share of a cell below a plane: `depth` of its middle below the plane, the cell as wide along the normal as its
/// sides are.
double share_below(double depth, const Vec3& normal, const Vec3& size, int dimension) {
    double width = 0;
    for (int axis = 0; axis < dimension; ++axis) {
        width += std::abs(normal[axis]) * size[axis];
    }
    return width > 0 ? std::clamp(0.5 + depth / width, 0.0, 1.0) : (depth > 0 ? 1.0 : 0.0);
}

}  // namespace

RoomCells::RoomCells(const RoomWalls& walls, std::span<const Vec3> water, const fluid::Domain& domain, double spacing)
    : walls_(walls), dimension_(domain.dimension), spacing_(spacing) {
    if (!lay_out(water, domain)) {
        return;
    }
    place_parts(domain);
    cells_.assign(at(count_[0] * count_[1] * count_[2]), {static_cast<float>(far * spacing_), 0, -1});
    const int slow = dimension_ - 1;
    parallel::for_each_uneven(count_[at(slow)], 1, [this](std::int64_t slab) { fill_slab(slab); });
    find_rooms();
}

/// Lays cells over the water and its surroundings; false where there is no water or there would be too many.
bool RoomCells::lay_out(std::span<const Vec3> water, const fluid::Domain& domain) {
    Vec3 low{infinity, infinity, infinity}, high = -1.0 * low;
    for (const Vec3& x : water) {
        if (is_finite(x)) {
            low = min(low, x);
            high = max(high, x);
        }
    }
    const double most = 1e6 + 32 * static_cast<double>(water.size());
    for (double side = cell_size * spacing_; side <= spacing_ && low.x <= high.x; side *= 1.25) {
        double all = 1;
        for (int axis = 0; axis < dimension_; ++axis) {
            wraps_[at(axis)] = domain.is_periodic[at(axis)];
            const double begin = wraps_[at(axis)] ? domain.low[axis] : low[axis] - margin * spacing_;
            const double end = wraps_[at(axis)] ? domain.high[axis] : high[axis] + margin * spacing_;
            const double count = std::max(1.0, std::round((end - begin) / side));
            low_[axis] = begin;
            size_[axis] = (end - begin) / count;
            all *= count;
            count_[at(axis)] = static_cast<std::int64_t>(std::min(count, 1e9));
        }
        if (all <= most) {
            return true;
        }
    }
    return false;
}

/// Places all wet parts and their images, each with the box of the cells that it may matter to.
void RoomCells::place_parts(const fluid::Domain& domain) {
    const fluid::PeriodicImages images(domain);
    const Vec3 reach = far * spacing_ * Vec3{1, 1, 1};
    Vec3 end = low_;
    for (int axis = 0; axis < 3; ++axis) {
        end[axis] += static_cast<double>(count_[at(axis)]) * size_[axis];
    }
    for (const body::Part& part : walls_.bodies.parts) {
        const auto b = at(part.body.value);
        if (!walls_.is_dry.empty() && walls_.is_dry[b] != 0) {
            continue;
        }
        const Pose& body = walls_.motion.pose[b];
        const geometry::ConvexView view = walls_.shapes.view(part.shape);
        const Pose pose{to_world(body, part.local.position), body.orientation * part.local.orientation};
        const bool is_half_space = view.vertex_count == 0;
        Vec3 low{infinity, infinity, infinity}, high = -1.0 * low;
        for (int v = 0; v < view.vertex_count; ++v) {
            low = min(low, to_world(pose, view.vertex(v)));
            high = max(high, to_world(pose, view.vertex(v)));
        }
        for (const Vec3& shift : is_half_space ? std::vector<Vec3>{{}} : images.shifts()) {
            const BoxedPart boxed{{view, {pose.position + shift, pose.orientation}, part.body.value, 0},
                                  is_half_space ? low_ : max(low + shift - reach, low_),
                                  is_half_space ? end : min(high + shift + reach, end)};
            bool is_near = true;
            for (int axis = 0; axis < dimension_; ++axis) {
                is_near = is_near && boxed.low[axis] < boxed.high[axis];
            }
            if (is_near) {
                parts_.push_back(boxed);
            }
        }
    }
}

/// Finds what is solid of the cells with one number along the last axis. Parts of one body share a cell, as they touch;
/// of several bodies the one counts that has most of it.
void RoomCells::fill_slab(std::int64_t slab) {
    const int slow = dimension_ - 1;
    std::vector<float> own(at(count_[0] * (dimension_ == 3 ? count_[1] : 1)));
    std::vector<std::int64_t> touched;
    const std::int64_t first = dimension_ == 3 ? slab * count_[0] * count_[1] : slab * count_[0];
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const BoxedPart& boxed = parts_[p];
        const PlacedPart& part = boxed.part;
        Cell begin{0, 0, 0}, end{1, 1, 1};
        for (int axis = 0; axis < dimension_; ++axis) {
            const auto number = [&](double x) { return (x - low_[axis]) / size_[axis]; };
            begin[at(axis)] = std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(number(boxed.low[axis]))));
            end[at(axis)] = std::min(count_[at(axis)], static_cast<std::int64_t>(std::ceil(number(boxed.high[axis]))));
        }
        const bool is_met = begin[at(slow)] <= slab && slab < end[at(slow)];
        begin[at(slow)] = slab;
        end[at(slow)] = is_met ? slab + 1 : slab;
        Cell cell{};
        for (cell[2] = begin[2]; cell[2] < end[2]; ++cell[2]) {
            for (cell[1] = begin[1]; cell[1] < end[1]; ++cell[1]) {
                for (cell[0] = begin[0]; cell[0] < end[0]; ++cell[0]) {
                    std::int32_t face = 0;
                    const double depth =
                        geometry::depth_below_faces(part.shape, to_body(part.pose, middle(cell)), &face);
                    const std::int64_t number = entry(cell);
                    WallCell& wall = cells_[at(number)];
                    if (-depth < wall.gap) {
                        wall.gap = static_cast<float>(-depth);
                        wall.part = static_cast<std::int32_t>(p);
                    }
                    const Vec3 normal = rotate(part.pose.orientation, part.shape.normal(face));
                    const double share = share_below(depth, normal, size_, dimension_);
                    if (share > 0) {
                        own[at(number - first)] += static_cast<float>(share);
                        touched.push_back(number);
                    }
                }
            }
        }
        if (p + 1 == parts_.size() || parts_[p + 1].part.body != part.body) {
            for (const std::int64_t number : touched) {
                float& share = own[at(number - first)];
                cells_[at(number)].solid = std::max(cells_[at(number)].solid, std::min(1.0F, share));
            }
            for (const std::int64_t number : touched) {
                own[at(number - first)] = 0;
            }
            touched.clear();
        }
    }
}

bool RoomCells::is_core(std::int64_t cell) const {
    double side = size_.x;
    for (int axis = 1; axis < dimension_; ++axis) {
        side = std::min(side, size_[axis]);
    }
    return cells_[at(cell)].gap > core_gap * side;
}

void RoomCells::find_rooms() {
    room_.assign(cells_.size(), -1);
    std::vector<std::int64_t> front;
    for (std::int64_t cell = 0; at(cell) < cells_.size(); ++cell) {
        if (room_[at(cell)] < 0 && is_core(cell)) {
            flood(cell, front);
        }
    }
    share_cut_cells();
    const double volume = size_.x * size_.y * (dimension_ == 3 ? size_.z : 1);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        if (room_[cell] >= 0) {
            Room& room = rooms_[at(room_[cell])];
            room.volume += (1 - static_cast<double>(cells_[cell].solid)) * volume;
            room.widest_gap = std::max(room.widest_gap, static_cast<double>(cells_[cell].gap));
        }
    }
}

/// Makes a room of all that hangs together with a cell.
void RoomCells::flood(std::int64_t first, std::vector<std::int64_t>& front) {
    const auto number = static_cast<std::int32_t>(rooms_.size());
    Room room;
    room_[at(first)] = number;
    front.assign(1, first);
    while (!front.empty()) {
        const Cell cell = cell_of(front.back());
        front.pop_back();
        for (int axis = 0; axis < dimension_; ++axis) {
            for (const std::int64_t by : {-1, 1}) {
                Cell next = cell;
                if (!step(next, axis, by)) {
                    room.is_closed = false;  // it goes on where no water has come
                    continue;
                }
                const std::int64_t other = entry(next);
                if (room_[at(other)] < 0 && is_core(other)) {
                    room_[at(other)] = number;
                    front.push_back(other);
                }
            }
        }
    }
    rooms_.push_back(room);
}

/// Gives each cell at a face to a room beside it.
void RoomCells::share_cut_cells() {
    for (std::int64_t number = 0; at(number) < cells_.size(); ++number) {
        if (is_core(number) || cells_[at(number)].solid >= 1) {
            continue;
        }
        visit_around(cell_of(number), [&](std::int64_t other) {
            if (room_[at(number)] < 0 && is_core(other)) {
                room_[at(number)] = room_[at(other)];
            }
        });
    }
}

Vec3 RoomCells::middle(const Cell& cell) const {
    Vec3 x{};
    for (int axis = 0; axis < dimension_; ++axis) {
        x[axis] = low_[axis] + (static_cast<double>(cell[at(axis)]) + 0.5) * size_[axis];
    }
    return x;
}

RoomCells::Cell RoomCells::cell_of(std::int64_t entry) const {
    return {entry % count_[0], entry / count_[0] % count_[1], entry / (count_[0] * count_[1])};
}

bool RoomCells::step(Cell& cell, int axis, std::int64_t by) const {
    const std::int64_t count = count_[at(axis)], to = cell[at(axis)] + by;
    if (to >= 0 && to < count) {
        cell[at(axis)] = to;
        return true;
    }
    cell[at(axis)] = (to + count) % count;
    return wraps_[at(axis)];
}

/// Visits the cells about one, those that it shares a side with first.
template <class Visit>
void RoomCells::visit_around(const Cell& cell, const Visit& visit) const {
    const std::int64_t deep = dimension_ == 3 ? 1 : 0;
    for (int sides = 1; sides <= dimension_; ++sides) {
        for (std::int64_t k = -deep; k <= deep; ++k) {
            for (std::int64_t j = -1; j <= 1; ++j) {
                for (std::int64_t i = -1; i <= 1; ++i) {
                    Cell other = cell;
                    if (std::abs(i) + std::abs(j) + std::abs(k) == sides && step(other, 0, i) && step(other, 1, j) &&
                        step(other, 2, k)) {
                        visit(entry(other));
                    }
                }
            }
        }
    }
}

std::int32_t RoomCells::room_at(const Vec3& x) const {
    if (room_.empty() || !is_finite(x)) {
        return -1;
    }
    Cell cell{};
    for (int axis = 0; axis < dimension_; ++axis) {
        const std::int64_t count = count_[at(axis)];
        const auto number = static_cast<std::int64_t>(std::floor((x[axis] - low_[axis]) / size_[axis]));
        cell[at(axis)] =
            wraps_[at(axis)] ? (number % count + count) % count : std::clamp<std::int64_t>(number, 0, count - 1);
    }
    std::int32_t room = room_[at(entry(cell))];
    visit_around(cell, [&](std::int64_t other) { room = room < 0 ? room_[at(other)] : room; });
    return room;
}

std::vector<RoomWall> RoomCells::walls_of(std::int32_t room) const {
    std::vector<RoomWall> found;
    const double volume = size_.x * size_.y * (dimension_ == 3 ? size_.z : 1);
    for (std::size_t number = 0; number < cells_.size(); ++number) {
        const WallCell& wall = cells_[number];
        if (room_[number] != room || wall.part < 0 || wall.gap <= 0 || wall.gap > size_.x) {
            continue;  // one layer of cells stands before every face
        }
        const PlacedPart& part = parts_[at(wall.part)].part;
        const Vec3 x = middle(cell_of(static_cast<std::int64_t>(number)));
        std::int32_t face = 0;
        geometry::depth_below_faces(part.shape, to_body(part.pose, x), &face);
        const Vec3 normal = rotate(part.pose.orientation, part.shape.normal(face));
        const double area = volume / size_.x;
        auto of_body = std::ranges::find(found, part.body, &RoomWall::body);
        if (of_body == found.end()) {
            of_body = found.insert(found.end(), {part.body, 0, 0});
        }
        of_body->area += area;
        of_body->inflow += area * dot(velocity_at(walls_.motion, part.body, x), normal);
    }
    std::ranges::sort(found, {}, &RoomWall::body);
    return found;
}

}  // namespace riprap::coupling
