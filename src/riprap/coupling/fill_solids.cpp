// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/fill_solids.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

/// Tells whether the way from a to b goes through a triangle: its plane is between them, and the way is on the same
/// side of all three edges.
bool is_crossed(const geometry::TriangleMesh& mesh, std::int32_t triangle, const Vec3& a, const Vec3& b) {
    const Vec3 &p = mesh.corner(triangle, 0), &q = mesh.corner(triangle, 1), &r = mesh.corner(triangle, 2);
    const Vec3 normal = cross(q - p, r - p), way = b - a;
    const double before = dot(normal, a - p), behind = dot(normal, b - p);
    if ((before > 0) == (behind > 0)) {
        return false;
    }
    const double u = dot(way, cross(p - a, q - a)), v = dot(way, cross(q - a, r - a)),
                 w = dot(way, cross(r - a, p - a));
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

}  // namespace

FillSolids::FillSolids(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                       const fluid::Domain& domain, double farthest)
    : farthest_(farthest), grounds_(body::find_grounds(bodies, shapes)) {
    const auto at = [](BodyId body) { return static_cast<std::size_t>(body.value); };
    std::vector<std::uint8_t> is_ground(static_cast<std::size_t>(bodies.size()), 0);
    for (const body::Ground& ground : grounds_) {
        const std::size_t b = at(ground.body);
        is_ground[b] = 1;
        poses_.push_back({state.position[b], state.orientation[b]});
    }
    for (const body::Part& part : bodies.parts) {
        const std::size_t b = at(part.body);
        if (is_ground[b] != 0) {
            continue;
        }
        const Pose pose{state.position[b], state.orientation[b]};
        parts_.push_back({shapes.view(part.shape),
                          {to_world(pose, part.local.position), pose.orientation * part.local.orientation}});
    }
    add_images(domain);
    sort_into_cells();
}

/// Adds the images of parts that reach into the domain across its periodic sides: water that starts in one of them
/// would burst out of the body. Half-spaces have no image of their own: they repeat, or stand across the period.
void FillSolids::add_images(const fluid::Domain& domain) {
    const fluid::PeriodicImages images(domain);
    const Vec3 middle = 0.5 * (domain.low + domain.high);
    const std::size_t count = images.shifts().size() > 1 ? parts_.size() : 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double reach = parts_[k].shape.circumradius + farthest_;
        if (!std::isfinite(reach)) {
            continue;
        }
        const Vec3 nearest = images.nearest(parts_[k].pose.position, middle);
        parts_[k].pose.position = nearest;
        for (const Vec3& shift : images.shifts()) {
            const Vec3 x = nearest + shift;
            const auto meets = [&](int axis) {
                return shift[axis] == 0 || (x[axis] + reach > domain.low[axis] && x[axis] - reach < domain.high[axis]);
            };
            if (shift != Vec3{} && meets(0) && meets(1) && meets(2)) {
                parts_.push_back({parts_[k].shape, {x, parts_[k].pose.orientation}});
            }
        }
    }
}

/// Parts much larger than most would make every cell as large as they are: they are asked one by one.
void FillSolids::sort_into_cells() {
    constexpr double large = 4;  // times the radius of the part in the middle of all
    std::vector<double> radii;
    for (const Placed& part : parts_) {
        radii.push_back(part.shape.circumradius);
    }
    if (radii.empty()) {
        return;
    }
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    const double limit = large * *middle;
    const auto is_small = [limit](const Placed& part) {
        return std::isfinite(part.shape.circumradius) && part.shape.circumradius <= limit;
    };
    small_ = static_cast<std::size_t>(std::stable_partition(parts_.begin(), parts_.end(), is_small) - parts_.begin());
    std::vector<Vec3> centres;
    double reach = 0;
    for (std::size_t k = 0; k < small_; ++k) {
        centres.push_back(parts_[k].pose.position);
        reach = std::max(reach, parts_[k].shape.circumradius + farthest_);
    }
    if (small_ > 0) {
        cells_.build(centres, fluid::Domain{}, reach);
    }
}

/// Tells whether is(part) holds for any part that x may be in or near.
template <class Is>
bool FillSolids::is_any(const Vec3& x, const Is& is) const {
    return std::any_of(parts_.begin() + static_cast<std::ptrdiff_t>(small_), parts_.end(), is) ||
           (small_ > 0 &&
            cells_.view().any_near(x, [&](std::int64_t k) { return is(parts_[static_cast<std::size_t>(k)]); }));
}

bool FillSolids::contain(const Vec3& x) const {
    for (std::size_t g = 0; g < grounds_.size(); ++g) {
        if (grounds_[g].field.is_inside(to_body(poses_[g], x))) {
            return true;
        }
    }
    return is_any(x, [&](const Placed& part) {
        return norm_squared(x - part.pose.position) <= part.shape.circumradius * part.shape.circumradius &&
               geometry::contains(part.shape, to_body(part.pose, x));
    });
}

bool FillSolids::are_near(const Vec3& x, double distance) const {
    RIPRAP_ASSERT(distance <= farthest_, "a solid farther away than filling looks");
    for (std::size_t g = 0; g < grounds_.size(); ++g) {
        const Vec3 local = to_body(poses_[g], x);
        if (grounds_[g].field.is_inside(local) || grounds_[g].field.nearest(local, distance)) {
            return true;
        }
    }
    return is_any(x, [&](const Placed& part) { return is_near(part, x, distance); });
}

bool FillSolids::thin_are_near(const Vec3& x, double distance, double thickness) const {
    return is_any(x, [&](const Placed& part) {
        return 2 * part.shape.inscribed_radius < thickness && is_near(part, x, distance);
    });
}

bool FillSolids::is_near(const Placed& part, const Vec3& x, double distance) {
    const double reach = part.shape.circumradius + distance;
    if (norm_squared(x - part.pose.position) > reach * reach) {
        return false;
    }
    const Vec3 local = to_body(part.pose, x);
    return geometry::depth_below_faces(part.shape, local) > -distance &&
           geometry::closest_surface_point(part.shape, local).distance < distance;
}

Vec3 FillSolids::push_out(const Vec3& x, double distance) const {
    double least = distance;
    Vec3 place = x;
    for (std::size_t g = 0; g < grounds_.size(); ++g) {
        const Vec3 local = to_body(poses_[g], x);
        const auto surface = grounds_[g].field.nearest(local, farthest_);
        if (surface && surface->distance < least) {
            least = surface->distance;
            place = x + (distance - surface->distance) * rotate(poses_[g].orientation, surface->normal);
        }
    }
    is_any(x, [&](const Placed& part) {
        const double reach = part.shape.circumradius + distance;
        if (norm_squared(x - part.pose.position) > reach * reach) {
            return false;
        }
        const Vec3 local = to_body(part.pose, x);
        if (geometry::depth_below_faces(part.shape, local) <= -distance) {
            return false;
        }
        const geometry::SurfacePoint surface = geometry::closest_surface_point(part.shape, local);
        if (surface.distance < least) {
            least = surface.distance;
            place = to_world(part.pose, surface.point + distance * surface.normal);
        }
        return false;
    });
    return place;
}

bool FillSolids::is_cut(const Placed& part, const Vec3& a, const Vec3& b) {
    const Vec3 from = to_body(part.pose, a), to = to_body(part.pose, b);
    double enters = 0, leaves = 1;  // shares of the way
    for (std::int32_t j = 0; j < part.shape.face_count; ++j) {
        const double above = dot(part.shape.normal(j), from) - part.shape.offset[j];
        const double rise = dot(part.shape.normal(j), to - from);
        if (above + std::min(rise, 0.0) >= 0) {
            return false;
        }
        if (rise < 0) {
            enters = std::max(enters, -above / rise);
        } else if (rise > 0) {
            leaves = std::min(leaves, -above / rise);
        }
    }
    return enters < leaves;
}

bool FillSolids::lie_between(const Vec3& a, const Vec3& b) const {
    const int pieces = static_cast<int>(std::ceil(norm(b - a) / farthest_));  // cells know no farther ones
    std::vector<std::int32_t> triangles;
    for (int n = 0; n < pieces; ++n) {
        const Vec3 middle = a + ((n + 0.5) / pieces) * (b - a);
        for (std::size_t g = 0; g < grounds_.size(); ++g) {
            const Vec3 from = to_body(poses_[g], a), to = to_body(poses_[g], b);
            triangles.clear();
            grounds_[g].field.near(to_body(poses_[g], middle), farthest_, triangles);
            if (std::ranges::any_of(
                    triangles, [&](std::int32_t t) { return is_crossed(grounds_[g].field.mesh(), t, from, to); })) {
                return true;
            }
        }
        if (is_any(middle, [&](const Placed& part) { return is_cut(part, a, b); })) {
            return true;
        }
    }
    return false;
}

}  // namespace riprap::coupling
