// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/damage/survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::view {

namespace {

constexpr double lowest = -std::numeric_limits<double>::infinity();

/// A corner in the frame of the survey: along, across, up.
struct Corner {
    double s, w, h;
};

/// Numbers of the stations between two places, as far as there are such.
struct Stations {
    std::int64_t begin, end;
};
Stations between(double low, double high, double from, double step, std::size_t count) {
    const auto begin = static_cast<std::int64_t>(std::ceil((low - from) / step - 1e-9));
    const auto end = static_cast<std::int64_t>(std::floor((high - from) / step + 1e-9)) + 1;
    const auto last = static_cast<std::int64_t>(count);
    return {std::clamp<std::int64_t>(begin, 0, last), std::clamp<std::int64_t>(end, 0, last)};
}

class Heights {
 public:
    explicit Heights(const SurveyGrid& grid)
        : grid_(grid), values_(grid.count * std::max<std::size_t>(1, grid.rows), lowest) {}

    /// Raises the stations below an edge of a planar body.
    void add_edge(const Corner& a, const Corner& b) {
        const Stations stations = between(std::min(a.s, b.s), std::max(a.s, b.s), grid_.from, grid_.step, grid_.count);
        for (std::int64_t i = stations.begin; i < stations.end; ++i) {
            const double share =
                b.s == a.s ? 0 : (grid_.from + static_cast<double>(i) * grid_.step - a.s) / (b.s - a.s);
            raise(at(i), b.s == a.s ? std::max(a.h, b.h) : a.h + share * (b.h - a.h));
        }
    }

    /// Raises the stations below a triangle.
    void add_triangle(const Corner& a, const Corner& b, const Corner& c) {
        const double twice = (b.s - a.s) * (c.w - a.w) - (c.s - a.s) * (b.w - a.w);
        if (twice == 0) {
            return;  // upright
        }
        const Stations along =
            between(std::min({a.s, b.s, c.s}), std::max({a.s, b.s, c.s}), grid_.from, grid_.step, grid_.count);
        const Stations across = between(std::min({a.w, b.w, c.w}), std::max({a.w, b.w, c.w}), grid_.across_from,
                                        grid_.across_step, grid_.rows);
        for (std::int64_t i = along.begin; i < along.end; ++i) {
            for (std::int64_t j = across.begin; j < across.end; ++j) {
                const double s = grid_.from + static_cast<double>(i) * grid_.step;
                const double w = grid_.across_from + static_cast<double>(j) * grid_.across_step;
                const double u = ((s - a.s) * (c.w - a.w) - (c.s - a.s) * (w - a.w)) / twice;
                const double v = ((b.s - a.s) * (w - a.w) - (s - a.s) * (b.w - a.w)) / twice;
                if (u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 1e-9) {
                    raise(at(j) * grid_.count + at(i), a.h + u * (b.h - a.h) + v * (c.h - a.h));
                }
            }
        }
    }

    /// Heights that a round foot feels, averaged over the rows.
    std::vector<double> felt(double radius) const {
        std::vector<double> sum(grid_.count, 0), rows(grid_.count, 0);
        const auto reach = static_cast<std::int64_t>(radius / grid_.step);
        for (std::size_t begin = 0; begin < values_.size(); begin += grid_.count) {
            for (std::size_t i = 0; i < grid_.count; ++i) {
                double height = lowest;
                for (std::int64_t k = -reach; k <= reach; ++k) {
                    const std::int64_t other = static_cast<std::int64_t>(i) + k;
                    if (other >= 0 && other < static_cast<std::int64_t>(grid_.count)) {
                        const double off = static_cast<double>(k) * grid_.step;
                        const double foot = std::sqrt(std::max(0.0, radius * radius - off * off)) - radius;
                        height = std::max(height, values_[begin + at(other)] + foot);
                    }
                }
                if (height > lowest) {
                    sum[i] += height;
                    rows[i] += 1;
                }
            }
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] /= rows[i];  // of no row: not a number
        }
        return sum;
    }

 private:
    void raise(std::size_t station, double height) { values_[station] = std::max(values_[station], height); }

    const SurveyGrid& grid_;
    std::vector<double> values_;
};

}  // namespace

std::vector<double> survey(const DrawnBodies& bodies, const BodyFrame& frame, const SurveyGrid& grid, double foot) {
    Heights heights(grid);
    for (std::size_t body = 0; body < bodies.body_count(); ++body) {
        const double* pose = &frame.pose[pose_values * body];
        const Vec3 x{pose[0], pose[1], pose[2]};
        const Quat q{pose[3], pose[4], pose[5], pose[6]};
        const DrawnShape& shape = bodies.shapes[static_cast<std::size_t>(bodies.shape[body])];
        std::vector<Corner> corners;
        for (const Vec3& corner : shape.corners) {
            const Vec3 place = x + rotate(q, corner);
            corners.push_back({dot(place, grid.along), dot(place, grid.across), dot(place, grid.up)});
        }
        for (const std::vector<std::int32_t>& face : shape.faces) {
            for (std::size_t k = 0; k < face.size(); ++k) {
                const Corner &a = corners[at(face[0])], &b = corners[at(face[k])],
                             &c = corners[at(face[(k + 1) % face.size()])];
                if (grid.rows == 0) {
                    heights.add_edge(b, c);
                } else if (k > 0 && k + 1 < face.size()) {
                    heights.add_triangle(a, b, c);
                }
            }
        }
    }
    return heights.felt(0.5 * foot);
}

double volume_of(const DrawnShape& shape, bool is_planar) {
    double volume = 0, front = 0, back = 0;  // a planar body may be drawn with one face or with two
    for (const std::vector<std::int32_t>& face : shape.faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            const Vec3 &a = shape.corners[at(face[0])], &b = shape.corners[at(face[k])],
                       &c = shape.corners[at(face[k + 1])];
            volume += dot(a, cross(b, c)) / 6;
            const double twice = cross(b - a, c - a).z;
            (twice > 0 ? front : back) += 0.5 * std::abs(twice);
        }
    }
    return is_planar ? std::max(front, back) : std::abs(volume);
}

}  // namespace riprap::view
