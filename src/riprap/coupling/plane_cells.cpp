// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/plane_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

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

PlanePolygon square(double reach) { return {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}; }

namespace {

/// Points sorted into square boxes.
class Boxes {
 public:
    Boxes(std::span<const PlanePoint> points, double reach, double spacing)
        : low_(-reach), size_(std::max(spacing, reach / 2048)) {
        count_ = static_cast<std::int64_t>(2 * reach / size_) + 1;
        start_.assign(static_cast<std::size_t>(count_ * count_ + 1), 0);
        const auto box_of = [this](const PlanePoint& p) {
            return static_cast<std::size_t>(index(p.v) * count_ + index(p.u));
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
    std::int64_t index(double x) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>((x - low_) / size_), 0, count_ - 1);
    }
    double size() const { return size_; }
    std::int64_t count() const { return count_; }
    std::span<const std::int32_t> members(std::int64_t iu, std::int64_t iv) const {
        const auto box = static_cast<std::size_t>(iv * count_ + iu);
        return std::span(members_).subspan(static_cast<std::size_t>(start_[box]),
                                           static_cast<std::size_t>(start_[box + 1] - start_[box]));
    }

 private:
    double low_, size_;
    std::int64_t count_{0};
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
    const std::int64_t iu = boxes.index(p.u), iv = boxes.index(p.v), last = boxes.count() - 1;
    for (std::int64_t jv = std::max<std::int64_t>(0, iv - ring); jv <= std::min(last, iv + ring); ++jv) {
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

std::vector<PlanePolygon> voronoi_cells(std::span<const PlanePoint> points, double reach, double spacing) {
    const Boxes boxes(points, reach, spacing);
    std::vector<PlanePolygon> cells(points.size());
    parallel::for_ranges(static_cast<std::int64_t>(points.size()), 256, [&](std::int64_t begin, std::int64_t end) {
        PlanePolygon buffer;
        for (std::int64_t index = begin; index < end; ++index) {
            const auto i = static_cast<std::size_t>(index);
            PlanePolygon cell = square(reach);
            for (std::int64_t ring = 0; ring <= boxes.count(); ++ring) {
                // A point of this ring lies beyond (ring - 1) boxes; its bisector, beyond half of that.
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

}  // namespace riprap::coupling
