// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "riprap/contact/narrowphase/common_plane.hpp"
#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

/// Cosine of the angle up to which two planes are one, and of the largest between a plane and the mean of several.
constexpr double same = 1 - 1e-9, across = 0.1;
/// Sine of the angle between edges that fix no plane [-].
constexpr double parallel = 1e-6;

/// Directions of planes that are equally good.
class EqualPlanes {
 public:
    EqualPlanes(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance)
        : a_(a), b_(b), least_(plane.gap - tolerance), normals_{plane.normal} {}

    void offer(const Vec3& normal) {
        const auto is_same = [&normal](const Vec3& known) { return dot(known, normal) > same; };
        if (std::ranges::none_of(normals_, is_same) && plane_gap(a_, b_, normal) > least_) {
            normals_.push_back(normal);
        }
    }
    /// The direction halfway between them; zero where there is one, or none that leads out by all of them.
    Vec3 middle() const {
        Vec3 sum{};
        for (const Vec3& n : normals_) {
            sum += n;
        }
        if (normals_.size() == 1 || !(norm(sum) > across * static_cast<double>(normals_.size()))) {
            return {};
        }
        const Vec3 mean = normalized(sum);
        const auto leads_out = [&mean](const Vec3& n) { return dot(n, mean) > across; };
        return std::ranges::all_of(normals_, leads_out) ? mean : Vec3{};
    }

 private:
    const PlacedHull &a_, &b_;
    double least_;
    std::vector<Vec3> normals_;
};

Vec3 along(const PlacedHull& hull, const HullEdge& edge) {
    return normalized(hull.vertices[at(edge.to)] - hull.vertices[at(edge.from)]);
}

}  // namespace

void share_plane_of_tips(const PlacedHull& a, const PlacedHull& b, double tolerance, CommonPlane& plane) {
    EqualPlanes equals(a, b, plane, tolerance);
    for (const Vec3& n : a.normals) {
        equals.offer(n);
    }
    for (const Vec3& n : b.normals) {
        equals.offer(-n);
    }
    for (const HullEdge& edge_a : a.topology->edges) {
        for (const HullEdge& edge_b : b.topology->edges) {
            const Vec3 n = cross(along(a, edge_a), along(b, edge_b));
            if (norm(n) > parallel) {
                equals.offer(normalized(n));
                equals.offer(normalized(-n));
            }
        }
    }
    if (const Vec3 middle = equals.middle(); norm_squared(middle) > 0) {
        plane = {middle, plane_gap(a, b, middle), {PlaneKind::link, -1, -1}, plane.is_fallback};
    }
}

}  // namespace riprap::contact
