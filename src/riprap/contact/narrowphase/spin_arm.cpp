// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/spin_arm.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::contact {

namespace {

/// h over the length of an edge below which h^2 asinh(s/h) is nothing beside s R.
constexpr double flat = 1e-12;

/// Sums over the triangles between the centre of pressure and the edges of the closed part.
struct SpinSums {
    PatchPoint centre;
    PatchPoint slope;        ///< g [-]
    double depth_at_centre;  ///< d_c [m]
    double push{0};          ///< int d dA [m^3]
    double moment{0};        ///< int d |r| dA [m^4]
    double farthest{0};      ///< largest R [m]

    void add_triangle(const PatchPoint& from, const PatchPoint& to) {
        const PatchPoint p{from.x - centre.x, from.y - centre.y}, q{to.x - centre.x, to.y - centre.y};
        const PatchPoint edge{q.x - p.x, q.y - p.y};
        const double length = std::hypot(edge.x, edge.y), twice = p.x * q.y - p.y * q.x;
        const double r0 = std::hypot(p.x, p.y), r1 = std::hypot(q.x, q.y);
        farthest = std::max({farthest, r0, r1});
        if (!(twice > flat * length * length)) {
            return;  // an edge through the centre, or none
        }
        const PatchPoint t{edge.x / length, edge.y / length};
        const double h = twice / length, s0 = p.x * t.x + p.y * t.y, s1 = q.x * t.x + q.y * t.y;
        const double both = s1 * r1 - s0 * r0 + h * h * (std::asinh(s1 / h) - std::asinh(s0 / h));
        const double across = slope.x * t.y - slope.y * t.x, along = slope.x * t.x + slope.y * t.y;
        push += twice / 6 * (3 * depth_at_centre + slope.x * (p.x + q.x) + slope.y * (p.y + q.y));
        moment +=
            depth_at_centre * h / 6 * both + across * h * h / 8 * both + along * h / 12 * (r1 * r1 * r1 - r0 * r0 * r0);
    }
};

}  // namespace

double spin_arm(const FootPatch& patch) {
    const PatchPoint slope{patch.slope_a.x - patch.slope_b.x, patch.slope_a.y - patch.slope_b.y};
    const PatchPoint centre = closed_part(patch).push;
    const PatchCorner& base = patch.corners[0];
    SpinSums sums{centre, slope,
                  base.depth + slope.x * (centre.x - base.place.x) + slope.y * (centre.y - base.place.y)};
    PatchPoint first{}, before{};
    int count = 0;
    const auto add = [&](const PatchPoint& p) {
        count++ == 0 ? void(first = p) : sums.add_triangle(before, p);
        before = p;
    };
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const PatchCorner &here = patch.corners[i], &next = patch.next(i);
        if (here.depth > 0) {
            add(here.place);
        }
        if ((here.depth > 0) != (next.depth > 0)) {
            const double t = here.depth / (here.depth - next.depth);
            add({here.place.x + t * (next.place.x - here.place.x), here.place.y + t * (next.place.y - here.place.y)});
        }
    }
    sums.add_triangle(before, first);
    // Depths of round-off have no pressure to speak of: no arm is longer than the way to the farthest point.
    return sums.push > 0 ? std::clamp(sums.moment / sums.push, 0.0, sums.farthest) : 0;
}

}  // namespace riprap::contact
