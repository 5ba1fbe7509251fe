// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/face_gauge.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "riprap/fluid/gauge/interpolate.hpp"
#include "riprap/fluid/particle/periodic_images.hpp"
#include "riprap/geometry/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double spline_end = 2;  ///< of the spline's width

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

Pose pose_of(const body::Part& part, const Pose& body) {
    return {to_world(body, part.local.position), body.orientation * part.local.orientation};
}

/// The face of a part that is nearest to a place in its frame, of those that carry a field.
struct NearFace {
    double distance{infinity};
    Vec3 point{}, normal{};
};
NearFace nearest_face(const geometry::ConvexView& shape, const Vec3& x) {
    NearFace nearest;
    for (std::int32_t j = 0; j < shape.face_count; ++j) {
        if (shape.is_internal[j] != 0) {
            continue;
        }
        const Vec3 n = shape.normal(j);
        const Vec3 point =
            shape.vertex_count == 0 ? x + (shape.offset[j] - dot(n, x)) * n : nearest_on_face(shape, j, x);
        if (norm(x - point) < nearest.distance) {
            nearest = {norm(x - point), point, n};
        }
    }
    return nearest;
}

/// Convex parts near a place, with their poses.
class Solids {
 public:
    Solids(const LoadedFaces& loaded, const Vec3& place, double reach) {
        for (const body::Part& part : loaded.bodies.parts) {
            const geometry::ConvexView view = loaded.shapes.view(part.shape);
            const Pose pose = pose_of(part, loaded.motion.pose[at(part.body.value)]);
            if (!(norm(pose.position - place) > view.circumradius + reach)) {
                parts_.push_back({view, pose, part.body});
            }
        }
    }
    /// Whether some body, or this one alone where it is valid, contains x or lies within `margin` of it [m].
    bool contain(const Vec3& x, double margin, BodyId body = {}) const {
        for (const auto& [view, pose, owner] : parts_) {
            if ((!body.is_valid() || owner == body) && geometry::contains(view, to_body(pose, x), margin)) {
                return true;
            }
        }
        return false;
    }

 private:
    struct Placed {
        geometry::ConvexView view;
        Pose pose;
        BodyId body;
    };
    std::vector<Placed> parts_;
};

/// A face about the point x with the outward normal n, looked at from just above and below.
struct OpenFace {
    const Solids& solids;
    Vec3 x, n;
    double spacing;

    double height() const { return 0.05 * spacing; }
    double slack() const { return 1e-6 * spacing; }
    /// Whether water can be at x + d, d along the face: some body below it, flush with this one, and none above. At an
    /// edge or in a corner itself it can.
    bool is_open(const Vec3& d) const {
        return !solids.contain(x + d + height() * n, -slack()) && solids.contain(x + d - height() * n, slack());
    }
    /// Whether x + d lies behind that part of the open face which belongs to this body.
    bool is_behind(const Vec3& d, BodyId body) const {
        const Vec3 foot = d - dot(d, n) * n;
        return is_open(foot) && solids.contain(x + foot - height() * n, slack(), body);
    }
    /// How far the face stays open from x along the unit vector t; infinity where farther than `far` [m].
    double length(const Vec3& t, double far) const {
        const double step = 0.125 * spacing;
        for (double s = step; s <= far; s += step) {
            if (is_open(s * t)) {
                continue;
            }
            double low = s - step, high = s;
            for (int halving = 0; halving < 20; ++halving) {
                const double middle = 0.5 * (low + high);
                (is_open(middle * t) ? low : high) = middle;
            }
            return high;
        }
        return infinity;
    }
};

/// The open face along one axis through the gauge, from -low to high: positive, infinite where it does not end nearby
/// [m].
struct Extent {
    double low, high;

    /// Weight of a place at distance s: what falls beyond an end is folded back.
    double weight(double s, double width) const {
        double sum = fluid::spline_weight(s, width);
        if (std::isfinite(low) && std::isfinite(high)) {
            const double period = 2 * (low + high);
            const int turns = static_cast<int>(std::ceil(4 * spline_end * width / period)) + 1;
            sum = 0;
            for (int k = -turns; k <= turns; ++k) {
                sum += fluid::spline_weight(s + k * period, width) +
                       fluid::spline_weight(2 * high - s + k * period, width);
            }
        } else if (std::isfinite(low)) {
            sum += fluid::spline_weight(-2 * low - s, width);
        } else if (std::isfinite(high)) {
            sum += fluid::spline_weight(2 * high - s, width);
        }
        return sum;
    }
};

}  // namespace

std::optional<FaceGauge> find_face(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                                   const body::BodyState& initial, std::span<const std::uint8_t> is_dry,
                                   const Vec3& place, double reach) {
    std::optional<FaceGauge> found;
    double least = reach;
    for (const body::Part& part : bodies.parts) {
        const std::size_t b = at(part.body.value);
        if (!is_dry.empty() && is_dry[b] != 0) {
            continue;
        }
        const Pose body{initial.position[b], initial.orientation[b]};
        const Pose pose = pose_of(part, body);
        const NearFace face = nearest_face(shapes.view(part.shape), to_body(pose, place));
        if (face.distance < least || (face.distance == least && !found)) {
            least = face.distance;
            found = {part.body, to_world(part.local, face.point), rotate(part.local.orientation, face.normal)};
        }
    }
    return found;
}

double read_face(const FaceGauge& gauge, const LoadedFaces& loaded) {
    const bool is_planar = loaded.domain.dimension == 2;
    const Pose& pose = loaded.motion.pose[at(gauge.body.value)];
    const Vec3 x = to_world(pose, gauge.anchor), n = rotate(pose.orientation, gauge.normal);
    // In two dimensions z is across, so that the other direction is in the plane; in three any two will do.
    const Vec3 first = normalized(cross(n, is_planar || std::abs(n.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const std::array<Vec3, 2> along{first, cross(n, first)};
    const int axes = is_planar ? 1 : 2;
    const double far = spline_end * loaded.spacing + loaded.reach;  // a particle moves forces by its reach at most
    const Solids solids(loaded, x, 2 * far);
    const OpenFace open{solids, x, n, loaded.spacing};
    if (!open.is_open({})) {
        return 0;  // something lies on the gauge
    }
    std::array<Extent, 2> face{};
    for (int a = 0; a < axes; ++a) {
        face[at(a)] = {open.length(-along[at(a)], far), open.length(along[at(a)], far)};
    }
    const fluid::PeriodicImages images(loaded.domain);
    const auto weight_at = [&](const Vec3& d) {
        double weight = 1;
        for (int a = 0; a < axes; ++a) {
            weight *= face[at(a)].weight(dot(d, along[at(a)]), loaded.spacing);
        }
        return weight;
    };
    double pressure = 0;
    for (std::size_t i = 0; i < loaded.samples.body.size() && i < loaded.particles.pressure_force.size(); ++i) {
        const BodyId body = loaded.samples.body[i];
        const Vec3 d = images.nearest(loaded.particles.position[i], x) - x;
        const double depth = -dot(d, n);
        if (depth < 0 || depth > loaded.reach + loaded.spacing || norm_squared(d) > 4 * far * far ||
            dot(rotate(loaded.motion.pose[at(body.value)].orientation, loaded.samples.normal[i]), n) < -0.5 ||
            (body != gauge.body && open.is_behind(d, gauge.body))) {
            continue;
        }
        pressure -= dot(loaded.particles.pressure_force[i], n) * weight_at(d);
    }
    for (const std::vector<PenaltyWalls::Push>& block : loaded.pushes) {
        for (const PenaltyWalls::Push& push : block) {
            const Vec3 d = images.nearest(push.place, x) - x;
            const double along_normal = dot(push.force, n);
            if (std::abs(dot(d, n)) < loaded.spacing && along_normal > 0.99 * norm(push.force)) {
                pressure += along_normal * weight_at(d);
            }
        }
    }
    return pressure;
}

}  // namespace riprap::coupling
