// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/ground/triangle_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/surface/triangle.hpp"

namespace riprap::geometry {

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

TriangleField::TriangleField(TriangleMesh mesh, const Vec3& up) : mesh_(std::move(mesh)), up_(up) {
    u_ = normalized(cross(std::abs(up.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, up));
    v_ = cross(up, u_);
    double u_high = -infinity, v_high = -infinity;
    u0_ = v0_ = infinity;
    for (const Vec3& x : mesh_.points) {
        places_.push_back(place(x));
        u0_ = std::min(u0_, places_.back().u);
        v0_ = std::min(v0_, places_.back().v);
        u_high = std::max(u_high, places_.back().u);
        v_high = std::max(v_high, places_.back().v);
    }
    struct Span {
        double u_low{infinity}, u_high{-infinity}, v_low{infinity}, v_high{-infinity}, low{infinity}, high{-infinity};
    };
    std::vector<Span> spans(at(mesh_.size()));
    double extent = 0;
    for (std::int32_t t = 0; t < mesh_.size(); ++t) {
        Span& span = spans[at(t)];
        for (const std::int32_t p : mesh_.corners[at(t)]) {
            const Place& here = places_[at(p)];
            span = {std::min(span.u_low, here.u),  std::max(span.u_high, here.u),   std::min(span.v_low, here.v),
                    std::max(span.v_high, here.v), std::min(span.low, here.height), std::max(span.high, here.height)};
        }
        extent += std::max(span.u_high - span.u_low, span.v_high - span.v_low) / mesh_.size();
    }
    if (mesh_.size() == 0) {
        return;
    }
    const double least = std::sqrt((u_high - u0_ + extent) * (v_high - v0_ + extent) / (4.0 * mesh_.size() + 16));
    cell_ = std::max(extent, least);
    columns_ = static_cast<std::int64_t>((u_high - u0_) / cell_) + 1;
    rows_ = static_cast<std::int64_t>((v_high - v0_) / cell_) + 1;
    begin_.assign(at(columns_ * rows_ + 1), 0);
    const auto visit = [&](const auto& enter) {
        for (std::int32_t t = 0; t < mesh_.size(); ++t) {
            const Span& span = spans[at(t)];
            for (std::int64_t j = row(span.v_low); j <= row(span.v_high); ++j) {
                for (std::int64_t i = column(span.u_low); i <= column(span.u_high); ++i) {
                    enter(at(j * columns_ + i), t);
                }
            }
        }
    };
    visit([this](std::size_t cell, std::int32_t) { ++begin_[cell + 1]; });
    for (std::size_t c = 1; c < begin_.size(); ++c) {
        begin_[c] += begin_[c - 1];
    }
    triangles_.resize(at(begin_.back()));
    std::vector<std::int32_t> next = begin_;
    low_.assign(at(columns_ * rows_), infinity);
    high_.assign(at(columns_ * rows_), -infinity);
    visit([&](std::size_t cell, std::int32_t t) {
        triangles_[at(next[cell]++)] = t;
        low_[cell] = std::min(low_[cell], spans[at(t)].low);
        high_[cell] = std::max(high_[cell], spans[at(t)].high);
    });
}

std::int64_t TriangleField::column(double u) const {
    return std::clamp(static_cast<std::int64_t>(std::floor((u - u0_) / cell_)), std::int64_t{0}, columns_ - 1);
}
std::int64_t TriangleField::row(double v) const {
    return std::clamp(static_cast<std::int64_t>(std::floor((v - v0_) / cell_)), std::int64_t{0}, rows_ - 1);
}

std::optional<double> TriangleField::height_at(std::int32_t triangle, double u, double v) const {
    const auto& corners = mesh_.corners[at(triangle)];
    double area[3];
    for (std::size_t k = 0; k < 3; ++k) {
        // From the lower number to the higher, so that both triangles of an edge find the same sign.
        const std::int32_t p = corners[(k + 1) % 3], q = corners[(k + 2) % 3];
        const Place &a = places_[at(std::min(p, q))], &b = places_[at(std::max(p, q))];
        const double side = (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
        area[k] = p < q ? side : -side;
    }
    const bool is_left = area[0] >= 0 && area[1] >= 0 && area[2] >= 0;
    const bool is_right = area[0] <= 0 && area[1] <= 0 && area[2] <= 0;
    const double sum = area[0] + area[1] + area[2];
    if (!(is_left || is_right) || sum == 0) {
        return std::nullopt;
    }
    return (area[0] * places_[at(corners[0])].height + area[1] * places_[at(corners[1])].height +
            area[2] * places_[at(corners[2])].height) /
           sum;
}

bool TriangleField::is_inside(const Vec3& x) const {
    const Place here = place(x);
    if (mesh_.size() == 0 || here.u < u0_ || here.v < v0_ || here.u > u0_ + cell_ * static_cast<double>(columns_) ||
        here.v > v0_ + cell_ * static_cast<double>(rows_)) {
        return false;
    }
    const std::size_t cell = at(row(here.v) * columns_ + column(here.u));
    if (here.height > high_[cell]) {
        return false;
    }
    double lowest = infinity;
    bool is_behind = false;
    for (std::int32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
        const std::int32_t t = triangles_[at(k)];
        const auto height = height_at(t, here.u, here.v);
        if (height && *height > here.height && *height < lowest) {
            lowest = *height;
            is_behind = dot(mesh_.area_normal(t), up_) > 0;
        }
    }
    return is_behind;
}

template <class Look>
void TriangleField::visit_columns(const Place& here, double radius, const Look& look) const {
    if (mesh_.size() == 0) {
        return;
    }
    const double u_end = u0_ + cell_ * static_cast<double>(columns_), v_end = v0_ + cell_ * static_cast<double>(rows_);
    if (here.u + radius < u0_ || here.v + radius < v0_ || here.u - radius > u_end || here.v - radius > v_end) {
        return;
    }
    for (std::int64_t j = row(here.v - radius); j <= row(here.v + radius); ++j) {
        for (std::int64_t i = column(here.u - radius); i <= column(here.u + radius); ++i) {
            const std::size_t cell = at(j * columns_ + i);
            if (here.height - radius <= high_[cell] && here.height + radius >= low_[cell]) {
                for (std::int32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
                    look(triangles_[at(k)]);
                }
            }
        }
    }
}

void TriangleField::near(const Vec3& x, double radius, std::vector<std::int32_t>& found) const {
    visit_columns(place(x), radius, [&](std::int32_t t) {
        const TrianglePoint on = nearest_on_triangle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), x);
        if (norm_squared(x - on.point) <= radius * radius) {
            found.push_back(t);
        }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

std::optional<SurfaceDistance> TriangleField::nearest(const Vec3& x, double reach) const {
    double least = reach * reach;
    SurfaceDistance found{0, {}, -1};
    Vec3 point{};
    visit_columns(place(x), reach, [&](std::int32_t t) {
        const TrianglePoint on = nearest_on_triangle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), x);
        const double squared = norm_squared(x - on.point);
        if (squared < least || (squared == least && found.triangle >= 0 && t < found.triangle)) {
            least = squared;
            found.triangle = t;
            point = on.point;
        }
    });
    if (found.triangle < 0) {
        return std::nullopt;
    }
    const double distance = std::sqrt(least);
    const bool is_in = is_inside(x);
    const Vec3 face = normalized(mesh_.area_normal(found.triangle));
    constexpr double on_surface = 1e-9;  // of the reach: the way to the surface has lost its direction
    const Vec3 away = distance > on_surface * reach ? (x - point) / distance : is_in ? -face : face;
    found.distance = is_in ? -distance : distance;
    found.normal = is_in ? -away : away;
    return found;
}

std::size_t TriangleField::bytes() const {
    return bytes_of(mesh_.points, mesh_.corners, places_, begin_, triangles_, low_, high_);
}

}  // namespace riprap::geometry
