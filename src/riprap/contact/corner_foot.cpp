// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/corner_foot.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/contact/narrowphase/overlap_integrals.hpp"
#include "riprap/contact/narrowphase/spin_arm.hpp"

namespace riprap::contact {

namespace {

/// sin of the angle between two edges below which they do not cross.
constexpr double parallel = 1e-9;

/// h^2 D/W up to which a foot is whole; from h D/W = 1 on it is none.
constexpr double whole_up_to = 0.5;
/// h of a foot as narrow as nothing beside stiff corners.
constexpr double narrowest = 2;

FootPatch& workspace() {
    static thread_local FootPatch patch;
    return patch;
}

/// Bound of the largest eigenvalue of J^-1 C, exact where the two smaller ones are equal [1/s^2].
double largest_rate(const PairSide& side, const Mat3& tilting) {
    if (side.inverse_mass == 0) {
        return 0;
    }
    const Sym3& j = side.inverse_inertia;
    const Mat3 rate{{j * tilting.row[0], j * tilting.row[1], j * tilting.row[2]}};  // transposed: C is symmetric
    const double mean = trace(rate) / 3, mean_square = trace(rate * rate) / 3;
    return mean + std::sqrt(2 * std::max(0.0, mean_square - mean * mean));
}

/// Adds what a function of the patch does by the place of a corner, which goes with its body, or with both edges that
/// cross in it. @param slope  derivative by the place
template <class Wrench>
void push_corner(const FootPatch& patch, const PatchCorner& corner, const PatchEdge& in, const PatchPoint& slope,
                 Wrench& on_a, Wrench& on_b) {
    const PatchEdge& out = patch.edge_from(corner);
    const double sine = in.along.x * out.along.y - in.along.y * out.along.x;
    if (in.is_of_b == out.is_of_b || std::abs(sine) < parallel) {
        const Vec3 force = -patch.in_space(slope);
        out.is_of_b ? on_b.add(force, corner.on_b) : on_a.add(force, corner.on_a);
        return;
    }
    // The shift of one edge across itself moves the corner along the other one.
    const auto push = [&](const PatchEdge& moved, const PatchEdge& kept) {
        const PatchPoint across{-moved.along.y, moved.along.x};
        const double share =
            -(slope.x * kept.along.x + slope.y * kept.along.y) / (across.x * kept.along.x + across.y * kept.along.y);
        const Vec3 force = patch.in_space({share * across.x, share * across.y});
        moved.is_of_b ? on_b.add(force, corner.on_b) : on_a.add(force, corner.on_a);
    };
    push(in, out);
    push(out, in);
}

}  // namespace

/// Derivatives of E by what describes the patch.
struct CornerFoot::Slopes {
    double by_foot;    ///< sigma [-]
    double by_area;    ///< beside that of E_c [J/m^2]
    double by_length;  ///< of the free edges [J/m]
};

CornerFoot::CornerFoot(const PlacedShape& a, const PlacedShape& b, double per_area, Corners corners)
    : a_(a), b_(b), faces_(find_facing_faces(a, b)), patch_(workspace()), per_area_(per_area) {
    if (!(faces_.share > 0) || !find_foot_patch(a, b, faces_, patch_)) {
        return;
    }
    weigh();
    const double width = faces_.rise * patch_.width();
    is_narrow_ = width < faces_.next.depth;
    room_ = is_narrow_ ? width : faces_.next.depth;
    fit_to_width(corners);
}

/// Sets t and its derivatives.
void CornerFoot::fit_to_width(Corners corners) {
    const double ratio = faces_.least.depth / room_;
    if (narrowest * narrowest * ratio <= whole_up_to) {
        fit_ = 1;
        return;
    }
    double h = 1, h_by_room = 0;
    if (corners == Corners::stiff && a_.shape.is_sharp && b_.shape.is_sharp) {
        const double size = std::min(a_.shape.inscribed_radius, b_.shape.inscribed_radius);
        const double q = std::min(room_ / size, 1.0);
        h = narrowest - (narrowest - 1) * q * q * (3 - 2 * q);
        h_by_room = -6 * (narrowest - 1) * q * (1 - q) / size;
    }
    const double none = 1 / h, whole = whole_up_to / (h * h), step = none - whole;
    const double u = std::clamp((none - ratio) / step, 0.0, 1.0), slope = 6 * u * (1 - u) / step;
    fit_ = u * u * (3 - 2 * u);
    fit_by_least_ = -slope / room_;
    fit_by_room_ = slope * (ratio / room_ - h_by_room * (2 * u * whole + (1 - u) * none) / h);
}

/// Sets the weights of the corners and E_c.
void CornerFoot::weigh() {
    constexpr double whole = 2 * std::numbers::pi;
    for (const PatchCorner& corner : patch_.corners) {
        const double share = corner.turn / whole;
        center_ = {center_.x + share * corner.place.x, center_.y + share * corner.place.y};
    }
    double xx = 0, xy = 0, yy = 0;
    PatchPoint first;
    for (const PatchCorner& corner : patch_.corners) {
        const double share = corner.turn / whole, depth = std::max(corner.depth, 0.0);
        const double x = corner.place.x - center_.x, y = corner.place.y - center_.y;
        xx += share * x * x;
        xy += share * x * y;
        yy += share * y * y;
        mean_square_ += share * depth * depth;
        first = {first.x + share * depth * depth * x, first.y + share * depth * depth * y};
    }
    const double determinant = xx * yy - xy * xy;
    const auto solve = [&](double x, double y) {
        return PatchPoint{(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
    };
    lean_ = solve(patch_.centroid.x - center_.x, patch_.centroid.y - center_.y);
    pull_ = solve(first.x, first.y);
    energy_ = 0;
    for (PatchCorner& corner : patch_.corners) {
        const double lean = lean_.x * (corner.place.x - center_.x) + lean_.y * (corner.place.y - center_.y);
        const double depth = std::max(corner.depth, 0.0);
        corner.weight = patch_.area * corner.turn / whole * (1 + lean);
        energy_ += 0.5 * per_area_ * corner.weight * depth * depth;
    }
}

/// Works out minus the gradient of a function of the patch with respect to the motion of A. With n held both bodies get
/// a wrench; n turns by half of the sum of both turns across n, and, where the faces lean by alpha, by tan(alpha/2)/2
/// times the difference of the turns about n.
///
/// With u = max(d, 0)^2, p = theta/(2 pi), y = q - s, g = M^-1 sum p u y and U = sum p u, the derivatives of
/// 2 E_c/(K A) = U + (c - s) . g are g by c, and at a corner p (u a - (a.y) g - (g.y) a - g - U a) by q and
/// (u (1 + a.y) - (a.y)(g.y) - y . (g + U a))/(2 pi) by theta.
CornerFoot::Wrench CornerFoot::push(const Slopes& slopes) const {
    constexpr double whole = 2 * std::numbers::pi;
    Wrench on_a, on_b;
    const Vec3 &n = patch_.n, push_a = faces_.normal_a / dot(faces_.normal_a, n),
               push_b = faces_.normal_b / dot(faces_.normal_b, n);
    const double half = 0.5 * slopes.by_foot * stiffness(),
                 by_area = slopes.by_area + slopes.by_foot * energy_ / patch_.area;
    const double per_depth = slopes.by_foot * per_area_, by_centroid = half / patch_.area;
    const PatchPoint &a = lean_, &g = pull_;
    const PatchPoint all{g.x + mean_square_ * a.x, g.y + mean_square_ * a.y};
    const auto along = [](const PatchPoint& p, const PatchPoint& q) { return p.x * q.x + p.y * q.y; };
    const auto by_angle = [&](const PatchCorner& corner) {
        const PatchPoint y{corner.place.x - center_.x, corner.place.y - center_.y};
        const double depth = std::max(corner.depth, 0.0), ay = along(a, y);
        return half / whole * (depth * depth * (1 + ay) - ay * along(g, y) - along(all, y));
    };
    // Returns what an edge gains by its shift outwards, at one end, over half of its length.
    const auto gain = [&](const PatchCorner& corner, const PatchCorner& other) {
        const auto beside = [&](const PatchCorner& c) {
            return along(g, {c.place.x - patch_.centroid.x, c.place.y - patch_.centroid.y});
        };
        return by_area + by_centroid * (2 * beside(corner) + beside(other)) / 3;
    };
    for (std::size_t i = 0; i < patch_.size(); ++i) {
        const PatchCorner &corner = patch_.corners[i], &next = patch_.next(i), &last = patch_.last(i);
        const double depth = std::max(corner.depth, 0.0);
        const double push = per_depth * corner.weight * depth;
        on_a.add(-push * push_a, corner.on_a);
        on_b.add(push * push_b, corner.on_b);

        const PatchEdge &in = patch_.edge_from(last), &out = patch_.edge_from(corner);
        const double with_in = in.is_free ? slopes.by_length : 0, with_out = out.is_free ? slopes.by_length : 0;
        const PatchPoint y{corner.place.x - center_.x, corner.place.y - center_.y};
        const double share = half * corner.turn / whole, ay = along(a, y), gy = along(g, y), u = depth * depth;
        const double before = 0.5 * gain(corner, last), after = 0.5 * gain(corner, next);
        const PatchPoint slope{
            before * (corner.place.y - last.place.y) + after * (next.place.y - corner.place.y) + with_in * in.along.x -
                with_out * out.along.x + push * (patch_.slope_a.x - patch_.slope_b.x) +
                share * (u * a.x - ay * g.x - gy * a.x - all.x),
            before * (last.place.x - corner.place.x) + after * (corner.place.x - next.place.x) + with_in * in.along.y -
                with_out * out.along.y + push * (patch_.slope_a.y - patch_.slope_b.y) +
                share * (u * a.y - ay * g.y - gy * a.y - all.y)};
        push_corner(patch_, corner, in, slope, on_a, on_b);

        // An edge that turns about n takes angle from its end and gives it to its beginning.
        const Vec3 flat = out.whole - dot(out.whole, n) * n;
        (out.is_of_b ? on_b : on_a).moment -=
            ((by_angle(corner) - by_angle(next)) / norm_squared(flat)) * cross(out.whole, cross(n, flat));
    }
    const Vec3 left = -(on_a.moment + on_b.moment);
    on_a.moment += 0.5 * (left - dot(left, push_a) * n);
    return on_a;
}

/// Point between the two faces.
Vec3 CornerFoot::middle(const PatchPoint& p) const {
    const PatchCorner& corner = patch_.corners[0];
    const double x = p.x - corner.place.x, y = p.y - corner.place.y;
    const double up = 0.5 * ((patch_.slope_a.x + patch_.slope_b.x) * x + (patch_.slope_a.y + patch_.slope_b.y) * y);
    return faces_.origin + 0.5 * (corner.on_a + corner.on_b) + patch_.in_space({x, y}) + up * patch_.n;
}

bool CornerFoot::stand(NormalContact& contact) const {
    if (!(energy_ > 0)) {
        return false;
    }
    const Wrench on_a = push({1, 0, 0});
    const ClosedPatch closed = closed_part(patch_);
    double depth = 0;
    for (const PatchCorner& corner : patch_.corners) {
        depth = std::max(depth, corner.depth);
    }
    const Vec3 point = middle(closed.push);
    contact = {.force = on_a.force,
               .moment = on_a.moment - cross(point - faces_.origin, on_a.force),
               .point = point,
               .area = closed.area,
               .stiffness = stiffness(),
               .energy = energy_,
               .depth = depth,
               .potential = depth / std::min(a_.shape.inscribed_radius, b_.shape.inscribed_radius),
               .spin_moment = disc_spin * norm(on_a.force) * std::sqrt(closed.area)};
    return true;
}

void CornerFoot::join(NormalContact& contact) const {
    const double sigma = share(), rest = 1 - sigma;
    const double more = energy_ - contact.energy;
    const double by_least = more * faces_.share * fit_by_least_, by_room = more * faces_.share * fit_by_room_;
    const double by_width = is_narrow_ && by_least != 0 ? faces_.rise * by_room : 0;
    Slopes slopes{sigma, 0, 0};
    if (by_width != 0) {
        slopes.by_area = 2 * by_width / patch_.free_length;
        slopes.by_length = -by_width * patch_.width() / patch_.free_length;
    }
    Wrench on_a = push(slopes);
    const auto add_depth = [&](const FaceDepth& depth, double slope) {
        const DeepestCorner corner =
            deepest_corner(a_, b_, depth, faces_.origin, middle(patch_.centroid) - faces_.origin);
        on_a.add((depth.is_of_a ? -slope : slope) * corner.normal, corner.place);
    };
    if (by_least != 0) {
        add_depth(faces_.least, by_least);
        if (!is_narrow_) {
            add_depth(faces_.next, by_room);
        }
    }
    on_a.moment += (more * fit_ * faces_.share_by_cosine) * cross(faces_.normal_a, faces_.normal_b);

    const Vec3 old_arm = contact.point - faces_.origin;
    const Vec3 moment = rest * (contact.moment + cross(old_arm, contact.force)) + on_a.moment;
    contact.force = rest * contact.force + on_a.force;
    if (energy_ > 0) {
        contact.point += sigma * (middle(closed_part(patch_).push) - contact.point);
    }
    contact.moment = moment - cross(contact.point - faces_.origin, contact.force);
    contact.stiffness = rest * contact.stiffness + sigma * stiffness();
    contact.energy = rest * contact.energy + sigma * energy_;
    contact.spin_moment = disc_spin * norm(contact.force) * std::sqrt(contact.area);
}

void CornerFoot::resist_spin(NormalContact& contact) const {
    const double arm = energy_ > 0 ? spin_arm(patch_) : 0;
    if (arm > 0) {  // else depths are round-off
        const double sigma = share(), of_disc = contact.area > 0 ? disc_spin * std::sqrt(contact.area) : 0;
        contact.spin_moment = norm(contact.force) * (sigma * arm + (1 - sigma) * of_disc);
    }
}

void CornerFoot::add_tilting(const Candidate& pair, ContactRow& row) const {
    const Vec3& n = patch_.n;
    const Vec3 point = row.point - faces_.origin;
    const double per_area = share() * per_area_;
    Mat3 tilting{};
    for (const PatchCorner& corner : patch_.corners) {
        const Vec3 arm = cross(corner.on_a - point, n);
        tilting = tilting + (per_area * corner.weight) * outer(arm, arm);
    }
    const double a = largest_rate(pair.a, tilting), b = largest_rate(pair.b, tilting), coupling = std::sqrt(a * b);
    row.omega_squared_a += static_cast<float>(a + coupling);
    row.omega_squared_b += static_cast<float>(b + coupling);
    if (!(pair.surfaces.damping_ratio > 0) || !(a + b > 0)) {
        return;
    }
    const double time = 2 * pair.surfaces.damping_ratio / std::sqrt(a + b);
    const Vec3 spin = pair.a.spin - pair.b.spin;
    Vec3 couple{};
    for (const PatchCorner& corner : patch_.corners) {
        if (corner.depth > 0) {
            const Vec3 arm = cross(corner.on_a - point, n);
            couple -= (per_area * corner.weight * std::max(-corner.depth, time * dot(arm, spin))) * arm;
        }
    }
    row.moment += couple;
    row.dashpot_couple += narrow(couple);
    row.dashpot_power += static_cast<float>(dot(couple, spin));
    row.damping_a += static_cast<float>(time * (a + coupling));
    row.damping_b += static_cast<float>(time * (b + coupling));
}

}  // namespace riprap::contact
