// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

using contact::CommonPlane;
using contact::PlacedHull;

namespace {

/// Cosine of the angle up to which two planes are one, 3 degrees.
constexpr double same_plane = 0.99863;
/// Cosine of the angle up to which a face continues another, 60 degrees.
constexpr double same_side = 0.5;

double offset_of(const PlacedHull& hull, std::size_t face) {
    return hull.is_half_space()
               ? hull.offset
               : dot(hull.normals[face], hull.vertices[at(hull.topology->loop(static_cast<std::int32_t>(face))[0])]);
}

/// The part of a line x + t d that lies in a convex body; empty where from > to [m].
struct Inside {
    double from{-std::numeric_limits<double>::infinity()}, to{std::numeric_limits<double>::infinity()};
};
Inside clip(const PlacedHull& hull, const Vec3& x, const Vec3& d) {
    Inside part;
    for (std::size_t f = 0; f < hull.normals.size(); ++f) {
        const double along = dot(hull.normals[f], d), room = offset_of(hull, f) - dot(hull.normals[f], x);
        if (std::abs(along) < 1e-12) {
            part = room < 0 ? Inside{1, 0} : part;
        } else if (along > 0) {
            part.to = std::min(part.to, room / along);
        } else {
            part.from = std::max(part.from, room / along);
        }
    }
    return part;
}

/// Tells whether a point lies outside of a convex body by no more than a distance, as its faces see it.
bool is_near(const PlacedHull& hull, const Vec3& x, double distance) {
    for (std::size_t f = 0; f < hull.normals.size(); ++f) {
        if (dot(hull.normals[f], x) - offset_of(hull, f) > distance) {
            return false;
        }
    }
    return true;
}

/// The least distance between a face and the corner farthest behind it [m].
double breadth_of(const PlacedHull& hull) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < hull.normals.size(); ++f) {
        double farthest = 0;
        for (const Vec3& x : hull.vertices) {
            farthest = std::max(farthest, offset_of(hull, f) - dot(hull.normals[f], x));
        }
        least = std::min(least, farthest);
    }
    return least;
}

/// Twice the distance of the farthest corner from the centre [m].
double length_of(const PlacedHull& hull) {
    double square = 0;
    for (const Vec3& x : hull.vertices) {
        square = std::max(square, norm_squared(x - hull.centre));
    }
    return 2 * std::sqrt(square);
}

/// Contact points of a face on a face spread over it; those at a seam lie along a line.
bool is_spread(const contact::PlaneContacts& points, double breadth) {
    double length = 0;
    for (int k = 1; k < points.count; ++k) {
        length = std::max(length, norm(points.contacts[at(k)].on_a - points.contacts[0].on_a));
    }
    return points.area > 2 * soft_step_share * breadth * length;
}

}  // namespace

Seams::Seams(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed,
             std::span<const contact::PartPair> pairs, double reach)
    : system_(system),
      state_(state),
      placed_(placed),
      reach_(reach),
      begin_(at(system.size() + 1), 0),
      neighbour_(2 * pairs.size()) {
    for (const contact::PartPair& pair : pairs) {
        ++begin_[at(pair.a + 1)];
        ++begin_[at(pair.b + 1)];
    }
    for (std::size_t b = 1; b < begin_.size(); ++b) {
        begin_[b] += begin_[b - 1];
    }
    std::vector<std::int32_t> filled(begin_.begin(), begin_.end() - 1);
    for (const contact::PartPair& pair : pairs) {
        neighbour_[at(filled[at(pair.a)]++)] = pair.b;
        neighbour_[at(filled[at(pair.b)]++)] = pair.a;
    }
}

bool Seams::open_plane(const contact::PartPair& pair, const contact::PlaneContacts& points, CommonPlane& plane) const {
    if (points.count == 0 || !system_.shape_of(pair.a).is_convex() || !system_.shape_of(pair.b).is_convex()) {
        return false;
    }
    const PlacedHull a = placed_.hull(system_, state_, pair.a), b = placed_.hull(system_, state_, pair.b);
    if (a.is_half_space() || b.is_half_space()) {
        return false;  // it has no side, and every block for a neighbour
    }
    const double breadth = std::min(breadth_of(a), breadth_of(b));
    if (is_spread(points, breadth)) {
        return false;
    }
    for (const bool is_first : {true, false}) {
        Meeting meeting{is_first ? pair.a : pair.b,
                        is_first ? pair.b : pair.a,
                        is_first ? a : b,
                        is_first ? b : a,
                        is_first ? -plane.normal : plane.normal,
                        {},
                        breadth,
                        is_first};
        for (int k = 0; k < points.count; ++k) {
            const contact::PlaneContact& point = points.contacts[at(k)];
            meeting.points.emplace_back(is_first ? point.on_b : point.on_a, point.gap);
        }
        const auto s = at(meeting.stander);
        for (std::int32_t k = begin_[s]; k < begin_[s + 1]; ++k) {
            const std::int32_t third = neighbour_[at(k)];
            if (third != meeting.other && !system_.shape_of(third).is_ground() && is_hidden(meeting, third, plane)) {
                return true;
            }
        }
    }
    return false;
}

bool Seams::is_hidden(const Meeting& meeting, std::int32_t third, CommonPlane& plane) const {
    const PlacedHull hull = placed_.hull(system_, state_, third);
    bool is_wide = !is_near(hull, meeting.points[0].first, (joint_share + soft_step_share) * meeting.breadth);
    if (is_wide && !may_bridge(meeting, hull)) {
        return false;
    }
    const CommonPlane under = contact::common_plane(hull, meeting.standing, {}, reach_);
    if (under.gap > reach_ || std::abs(dot(under.normal, meeting.normal)) > same_plane) {
        return false;
    }
    const double overlap = std::max(0.0, -under.gap), least = step_share * meeting.breadth,
                 most = soft_step_share * meeting.breadth;
    const double step = std::max(least, std::min(2 * overlap, most));
    double set_back = 0;
    const auto covers_over = [&](double joint) {
        return covers(meeting, hull, under.normal, overlap, step, joint, set_back);
    };
    is_wide = is_wide || !covers_over(joint_share * meeting.breadth);
    if (is_wide && !(may_bridge(meeting, hull) && covers_over(0.5 * length_of(meeting.standing)) &&
                     !has_dipped(meeting, hull, under, least))) {
        return false;
    }
    CommonPlane turned = plane;
    if (!turn(meeting, under.normal, overlap + most, turned)) {
        return false;
    }
    // Where the other block may slide along the third one as well, it is their motion that tells who passes whom.
    const bool is_held = system_.is_fixed[at(meeting.other)] != 0 && system_.is_fixed[at(third)] != 0;
    if (!is_held && !is_wide && set_back <= step && !slides_along(meeting, turned.normal)) {
        return false;
    }
    plane = turned;
    return true;
}

/// Tells whether a block may stand on a third one with its front over a joint: the point that it meets lies before a
/// face of the third one, in its plane, and no farther than half of the block's length, beyond which the block tips.
bool Seams::may_bridge(const Meeting& meeting, const PlacedHull& third) const {
    const Vec3& x = meeting.points[0].first;
    const double height = 2 * soft_step_share * meeting.breadth;
    for (std::size_t f = 0; f < third.normals.size(); ++f) {
        const Vec3& n = third.normals[f];
        const double level = offset_of(third, f);
        if (std::abs(dot(n, x) - level) <= height && dot(n, meeting.standing.centre) > level &&
            std::abs(dot(n, meeting.normal)) <= same_plane) {
            return is_near(third, x, 0.5 * length_of(meeting.standing));
        }
    }
    return false;
}

/// Tells whether the front of a block over a joint is lower than the springs of both supports let it sink: at most
/// twice the overlap at the end of the face that it stands on.
bool Seams::has_dipped(const Meeting& meeting, const PlacedHull& third, const CommonPlane& under, double least) const {
    contact::PlaneContacts points;
    find_plane_contacts(third, meeting.standing, under, contact_tolerance(third, meeting.standing, under), points);
    double support = 0;
    for (int k = 0; k < points.count; ++k) {
        support = std::max(support, -points.contacts[at(k)].gap);
    }
    return points.count == 0 || -under.gap > std::max(least, 2 * support);
}

/// Tells whether a third body lies before the side of `other` wherever it is touched, up to a step below its edge.
bool Seams::covers(const Meeting& meeting, const PlacedHull& third, const Vec3& up, double overlap, double step,
                   double joint, double& set_back) const {
    const Vec3 climb = up - dot(up, meeting.normal) * meeting.normal;
    const Vec3 away = meeting.normal - dot(up, meeting.normal) * up;
    const double slope = norm(climb);  // of the side against the face stood on: a sine, and that of `away` too
    const Vec3 along = climb / slope, out = away / slope;
    const double apart = contact::plane_gap(meeting.next, meeting.standing, out);
    set_back = std::numeric_limits<double>::infinity();
    for (const auto& [x, gap] : meeting.points) {
        double rise = std::numeric_limits<double>::infinity();
        for (std::size_t f = 0; f < meeting.next.normals.size(); ++f) {
            const Vec3& n = meeting.next.normals[f];
            const double steep = dot(n, along);
            if (dot(n, meeting.normal) < same_plane && steep > 1e-9) {
                rise = std::min(rise, std::max(0.0, (offset_of(meeting.next, f) - dot(n, x)) / steep));
            }
        }
        // The point lies where the gap to `stander` ends: lower than the other end of the gap where the side leans.
        const double lower = std::max(0.0, gap) * std::max(0.0, dot(up, meeting.normal));
        if (!(rise * slope <= overlap + step + lower)) {
            return false;
        }
        const Inside part = clip(third, x + rise * along - step * up, out);
        if (part.from > part.to || part.from > joint || part.to < -joint) {
            return false;
        }
        set_back = std::min(set_back, apart - std::max(part.from, -joint));
    }
    return true;
}

/// Turns a plane to the best face of either block that looks along `up`, unless they overlap too deeply there.
bool Seams::turn(const Meeting& meeting, const Vec3& up, double deepest, CommonPlane& plane) const {
    const PlacedHull &first = meeting.is_stander_first ? meeting.standing : meeting.next,
                     &second = meeting.is_stander_first ? meeting.next : meeting.standing;
    const double sign = meeting.is_stander_first ? -1 : 1;
    const Vec3 before = plane.normal;
    bool is_found = false;
    const auto offer = [&](const Vec3& normal, const contact::PlaneFeature& feature) {
        if (sign * dot(normal, up) < same_side || dot(normal, before) > same_plane) {
            return;
        }
        const double gap = contact::plane_gap(first, second, normal);
        if (gap >= -deepest && (!is_found || gap > plane.gap)) {
            plane = {normal, gap, feature, plane.is_fallback};
            is_found = true;
        }
    };
    for (std::size_t f = 0; f < first.normals.size(); ++f) {
        offer(first.normals[f], {contact::PlaneKind::face_a, static_cast<std::int32_t>(f), -1});
    }
    for (std::size_t f = 0; f < second.normals.size(); ++f) {
        offer(-second.normals[f], {contact::PlaneKind::face_b, -1, static_cast<std::int32_t>(f)});
    }
    return is_found;
}

/// Tells whether both blocks move past each other along the plane with this normal rather than along the present one.
bool Seams::slides_along(const Meeting& meeting, const Vec3& normal) const {
    const auto velocity = [&](std::int32_t block) {
        const auto b = at(block);
        return state_.velocity[b] +
               rows_at(state_.velocity_gradient, b) * (meeting.points[0].first - state_.position[b]);
    };
    const Vec3 relative = velocity(meeting.stander) - velocity(meeting.other);
    return std::abs(dot(relative, normal)) < std::abs(dot(relative, meeting.normal));
}

}  // namespace riprap::solid::affine
