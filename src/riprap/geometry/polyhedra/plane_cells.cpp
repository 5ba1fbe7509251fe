// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/plane_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "riprap/core/parallel.hpp"

namespace riprap::geometry {

void clip(PlanePolygon& polygon, const HalfPlane& side, PlanePolygon& buffer) {
    const auto excess = [&side](const PlanePoint& p) { return side.a * p.u + side.b * p.v - side.c; };
    if (std::all_of(polygon.begin(), polygon.end(), [&](const PlanePoint& p) { return excess(p) <= 0; })) {
        return;
    }
    buffer.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PlanePoint p = polygon[i], q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_p = excess(p), at_q = excess(q);
        if (at_p <= 0) {
            buffer.push_back(p);
        }
        if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
            const double t = at_p / (at_p - at_q);
            buffer.push_back({p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)});
        }
    }
    polygon.swap(buffer);
    if (polygon.size() < 3) {
        polygon.clear();
    }
}

double area(const PlanePolygon& polygon) {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const PlanePoint &o = polygon[0], &p = polygon[i - 1], &q = polygon[i];
        twice += (p.u - o.u) * (q.v - o.v) - (q.u - o.u) * (p.v - o.v);
    }
    return 0.5 * twice;
}

PlanePoint centroid(const PlanePolygon& polygon) {
    const PlanePoint& o = polygon[0];
    double twice = 0, u = 0, v = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const PlanePoint &p = polygon[i - 1], &q = polygon[i];
        const double part = (p.u - o.u) * (q.v - o.v) - (q.u - o.u) * (p.v - o.v);
        twice += part;
        u += part * (p.u - o.u + q.u - o.u);
        v += part * (p.v - o.v + q.v - o.v);
    }
    return {o.u + u / (3 * twice), o.v + v / (3 * twice)};
}

PlanePolygon square(double reach) { return {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}; }

namespace {

/// Points sorted into square boxes.
class Boxes {
 public:
    Boxes(std::span<const PlanePoint> points, const PlaneBox& box, double spacing) : low_(box.low) {
        const double width = box.high.u - box.low.u, height = box.high.v - box.low.v;
        size_ = std::max(spacing, std::max(width, height) / 4096);
        count_u_ = static_cast<std::int64_t>(width / size_) + 1;
        count_v_ = static_cast<std::int64_t>(height / size_) + 1;
        start_.assign(static_cast<std::size_t>(count_u_ * count_v_ + 1), 0);
        const auto box_of = [this](const PlanePoint& p) {
            return static_cast<std::size_t>(row(p) * count_u_ + column(p));
        };
        for (const PlanePoint& p : points) {
            ++start_[box_of(p) + 1];
        }
        for (std::size_t b = 1; b < start_.size(); ++b) {
            start_[b] += start_[b - 1];
        }
        members_.resize(points.size());
        std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
        for (std::size_t i = 0; i < points.size(); ++i) {
            members_[static_cast<std::size_t>(next[box_of(points[i])]++)] = static_cast<std::int32_t>(i);
        }
    }
    std::int64_t column(const PlanePoint& p) const { return index(p.u - low_.u, count_u_); }
    std::int64_t row(const PlanePoint& p) const { return index(p.v - low_.v, count_v_); }
    double size() const { return size_; }
    std::int64_t columns() const { return count_u_; }
    std::int64_t rows() const { return count_v_; }
    std::span<const std::int32_t> members(std::int64_t iu, std::int64_t iv) const {
        const auto box = static_cast<std::size_t>(iv * count_u_ + iu);
        return std::span(members_).subspan(static_cast<std::size_t>(start_[box]),
                                           static_cast<std::size_t>(start_[box + 1] - start_[box]));
    }

 private:
    std::int64_t index(double along, std::int64_t count) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(along / size_), 0, count - 1);
    }
    PlanePoint low_;
    double size_{0};
    std::int64_t count_u_{0}, count_v_{0};
    std::vector<std::int32_t> start_, members_;
};

double farthest_squared(const PlanePolygon& cell, const PlanePoint& from) {
    double most = 0;
    for (const PlanePoint& p : cell) {
        most = std::max(most, (p.u - from.u) * (p.u - from.u) + (p.v - from.v) * (p.v - from.v));
    }
    return most;
}

/// Cuts the cell of point i by the bisectors with the members of one ring of boxes about it.
void cut_by_ring(std::span<const PlanePoint> points, std::size_t i, const Boxes& boxes, std::int64_t ring,
                 PlanePolygon& cell, PlanePolygon& buffer) {
    const PlanePoint p = points[i];
    const std::int64_t iu = boxes.column(p), iv = boxes.row(p), last = boxes.columns() - 1;
    for (std::int64_t jv = std::max<std::int64_t>(0, iv - ring); jv <= std::min(boxes.rows() - 1, iv + ring); ++jv) {
        const bool is_end_row = std::abs(jv - iv) == ring;
        for (std::int64_t ju = iu - ring; ju <= iu + ring; ju += is_end_row || ring == 0 ? 1 : 2 * ring) {
            if (ju < 0 || ju > last) {
                continue;
            }
            for (const std::int32_t j : boxes.members(ju, jv)) {
                if (static_cast<std::size_t>(j) != i) {
                    const PlanePoint q = points[static_cast<std::size_t>(j)];
                    const double a = q.u - p.u, b = q.v - p.v;
                    clip(cell, {a, b, 0.5 * (a * (p.u + q.u) + b * (p.v + q.v))}, buffer);
                }
            }
        }
    }
}

}  // namespace

PlaneBox bounds(std::span<const PlanePolygon> polygons) {
    PlaneBox box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const PlanePolygon& polygon : polygons) {
        for (const PlanePoint& p : polygon) {
            box.low = {std::min(box.low.u, p.u), std::min(box.low.v, p.v)};
            box.high = {std::max(box.high.u, p.u), std::max(box.high.v, p.v)};
        }
    }
    return box;
}

std::vector<PlanePolygon> voronoi_cells(std::span<const PlanePoint> points, const PlaneBox& box, double spacing) {
    const Boxes boxes(points, box, spacing);
    const PlanePolygon whole{box.low, {box.high.u, box.low.v}, box.high, {box.low.u, box.high.v}};
    std::vector<PlanePolygon> cells(points.size());
    parallel::for_ranges(static_cast<std::int64_t>(points.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        PlanePolygon buffer;
        for (std::int64_t index = begin; index < end; ++index) {
            const auto i = static_cast<std::size_t>(index);
            PlanePolygon cell = whole;
            for (std::int64_t ring = 0; ring <= std::max(boxes.columns(), boxes.rows()); ++ring) {
                // A point of this ring lies beyond (ring - 1) boxes (or outside, where the last boxes hold it); its
                // bisector, beyond half of that.
                const double nearest = static_cast<double>(std::max<std::int64_t>(0, ring - 1)) * boxes.size();
                if (0.25 * nearest * nearest > farthest_squared(cell, points[i])) {
                    break;
                }
                cut_by_ring(points, i, boxes, ring, cell, buffer);
            }
            cells[i] = std::move(cell);
        }
    });
    return cells;
}

}  // namespace riprap::geometry
