// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/plane_section.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/contact/narrowphase/touching_set.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

using Outline = std::vector<PlanePoint>;  ///< convex, counter-clockwise

/// Cuts a body by the plane at `height` along `normal`.
Outline section(const PlacedHull& hull, const Vec3& normal, double height, const PlaneAxes& axes) {
    Outline outline;
    PlanePoint centre{0, 0};
    for (const HullEdge& edge : hull.topology->edges) {
        const Vec3 &from = hull.vertices[at(edge.from)], &to = hull.vertices[at(edge.to)];
        const double below = dot(normal, from) - height, above = dot(normal, to) - height;
        if ((below > 0) != (above > 0)) {
            outline.push_back(axes.project(from + (below / (below - above)) * (to - from)));
            centre = centre + outline.back();
        }
    }
    if (outline.empty()) {
        return outline;
    }
    centre = (1.0 / static_cast<double>(outline.size())) * centre;
    const auto angle = [&](const PlanePoint& p) { return std::atan2(p.y - centre.y, p.x - centre.x); };
    std::sort(outline.begin(), outline.end(),
              [&](const PlanePoint& p, const PlanePoint& q) { return angle(p) < angle(q); });
    return outline;
}

/// Keeps the part of an outline to the left of the line from p to q [Sutherland1974].
Outline left_of(const Outline& outline, const PlanePoint& p, const PlanePoint& q) {
    Outline kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint &here = outline[i], &next = outline[(i + 1) % outline.size()];
        const double h = cross(q - p, here - p), h_next = cross(q - p, next - p);
        if (h >= 0) {
            kept.push_back(here);
        }
        if ((h > 0 && h_next < 0) || (h < 0 && h_next > 0)) {
            kept.push_back(here + (h / (h - h_next)) * (next - here));
        }
    }
    return kept;
}

double area_of(const Outline& outline) {
    double twice = 0;
    for (std::size_t i = 2; i < outline.size(); ++i) {
        twice += cross(outline[i - 1] - outline[0], outline[i] - outline[0]);
    }
    return 0.5 * twice;
}

}  // namespace

double common_section(const PlacedHull& a, const PlacedHull& b, const Vec3& normal, double depth) {
    const PlaneAxes axes = axes_across(normal, a.is_half_space() ? b.centre : a.centre);
    const auto highest = [&] { return dot(normal, a.vertices[at(support_vertex(a, normal))]); };
    const auto lowest = [&] { return dot(normal, b.vertices[at(support_vertex(b, -normal))]); };
    if (b.is_half_space()) {
        return area_of(section(a, normal, highest() - 0.5 * depth, axes));
    }
    Outline common = section(b, normal, lowest() + 0.5 * depth, axes);
    if (a.is_half_space()) {
        return area_of(common);
    }
    const Outline of_a = section(a, normal, highest() - 0.5 * depth, axes);
    if (of_a.size() < 3) {
        return 0;
    }
    for (std::size_t i = 0; i < of_a.size(); ++i) {
        common = left_of(common, of_a[i], of_a[(i + 1) % of_a.size()]);
    }
    return area_of(common);
}

}  // namespace riprap::contact
