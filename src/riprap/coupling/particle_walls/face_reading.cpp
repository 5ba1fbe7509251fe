// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/face_reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/coupling/particle_walls/gauge_edges.hpp"
#include "riprap/coupling/particle_walls/side_forces.hpp"
#include "riprap/fluid/gauge/interpolate.hpp"
#include "riprap/fluid/particle/sweep/periodic_images.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double spline_end = 2;     ///< of the spline's width
constexpr double height = 0.05;      ///< of a spacing: "just" above and below a face
constexpr double edge_depth = 0.5;   ///< of a spacing: a face that bends away by less than that has no edge
constexpr double slack = 1e-6;       ///< of a spacing, for what lies on an edge or in a corner itself
constexpr double same_side = -0.5;   ///< cosine: faces that look away from each other more than that are opposite
constexpr double least_slope = 0.3;  ///< sine: a cover flatter than this has no front along the face
constexpr double least_area = 0.1;   ///< of the open face, over that of a plane: less is taken for so much

Pose pose_of(const body::Part& part, const Pose& body) {
    return {to_world(body, part.local.position), body.orientation * part.local.orientation};
}

/// Wet convex parts near a place, with their poses, across periodic sides too.
class Solids {
 public:
    Solids(const LoadedFaces& loaded, const Vec3& place, double reach) {
        const fluid::PeriodicImages images(loaded.domain);
        for (const body::Part& part : loaded.bodies.parts) {
            const std::size_t b = at(part.body.value);
            if (!loaded.is_dry.empty() && loaded.is_dry[b] != 0) {
                continue;
            }
            const geometry::ConvexView view = loaded.shapes.view(part.shape);
            const Pose pose = pose_of(part, loaded.motion.pose[b]);
            if (!std::isfinite(view.circumradius)) {
                parts_.push_back({view, pose, part.body});
                continue;
            }
            const Vec3 nearest = images.nearest(pose.position, place);
            for (const Vec3& shift : images.shifts()) {
                if (norm(nearest + shift - place) < view.circumradius + reach) {
                    parts_.push_back({view, {nearest + shift, pose.orientation}, part.body});
                }
            }
        }
    }
    /// Tells whether a body, or this one alone where it is valid, contains x or lies within `margin` of it [m].
    bool contain(const Vec3& x, double margin, BodyId body = {}) const {
        for (const auto& [view, pose, owner] : parts_) {
            if ((!body.is_valid() || owner == body) && geometry::contains(view, to_body(pose, x), margin)) {
                return true;
            }
        }
        return false;
    }
    /// The shortest way out of the part that contains x along the plane with the normal n; nothing where no part does
    /// or all of its faces are nearly in the plane.
    std::optional<Vec3> way_out(const Vec3& x, const Vec3& n) const {
        for (const auto& [view, pose, owner] : parts_) {
            const Vec3 local = to_body(pose, x), local_normal = rotate_back(pose.orientation, n);
            if (!geometry::contains(view, local)) {
                continue;
            }
            Vec3 way{};
            double least = std::numeric_limits<double>::infinity();
            for (std::int32_t j = 0; j < view.face_count; ++j) {
                const Vec3 out = view.normal(j), along = out - dot(out, local_normal) * local_normal;
                const double length = (view.offset[j] - dot(out, local)) / norm(along);
                if (norm(along) > least_slope && length < least) {
                    least = length;
                    way = length / norm(along) * along;
                }
            }
            return std::isfinite(least) ? std::optional<Vec3>(rotate(pose.orientation, way)) : std::nullopt;
        }
        return std::nullopt;
    }

 private:
    struct Placed {
        geometry::ConvexView view;
        Pose pose;
        BodyId body;
    };
    std::vector<Placed> parts_;
};

/// The plane of a face about the point x with the outward normal n.
struct FacePlane {
    const Solids& solids;
    Vec3 x, n;
    double spacing;

    Vec3 above(const Vec3& d) const { return x + d + height * spacing * n; }
    Vec3 below(const Vec3& d) const { return x + d - height * spacing * n; }
    /// Tells whether x + d, d along the plane, is on the open face of a body: that body just below it and none just
    /// above. On an edge or in a corner itself it is.
    bool is_open(const Vec3& d, BodyId body) const {
        return !solids.contain(above(d), -slack * spacing) && solids.contain(below(d), slack * spacing, body);
    }
    /// Where the force on a buried particle with its foot at x + d belongs: as far in front of the bodies that cover
    /// the foot as that is behind. Nothing where there is no such place.
    std::optional<Vec3> uncovered(Vec3 d) const {
        for (int cover = 0; cover < 3; ++cover) {
            if (!solids.contain(above(d), -slack * spacing)) {
                return d;
            }
            const std::optional<Vec3> out = solids.way_out(above(d), n);
            if (!out) {
                return std::nullopt;
            }
            d += 2.0 * *out;
        }
        return std::nullopt;
    }
};

/// One face with what presses on it.
class FaceReading {
 public:
    FaceReading(const FaceGauge& gauge, const LoadedFaces& loaded, const WaterAtFace* water = nullptr)
        : loaded_(loaded),
          images_(loaded.domain),
          pose_(loaded.motion.pose[at(gauge.body.value)]),
          x_(to_world(pose_, gauge.anchor)),
          n_(rotate(pose_.orientation, gauge.normal)),
          is_planar_(loaded.domain.dimension == 2),
          first_(rotate(pose_.orientation, tangent(gauge.normal, is_planar_))),
          second_(cross(n_, first_)),
          side_(gauge.side),
          far_(spline_end * loaded.spacing + loaded.reach + 0.5 * gauge.side),
          solids_(loaded, x_, 2 * far_),
          plane_{solids_, x_, n_, loaded.spacing},
          is_open_(plane_.is_open({}, gauge.body)) {
        if (water != nullptr && is_open_) {
            sides_.emplace(*water, loaded.particles, x_, n_, far_ + 2 * loaded.reach);
        }
    }

    bool is_open() const { return is_open_; }
    /// Tells whether the face ends in the water within a distance: neither its body nor another goes on below it.
    bool ends_within(double distance) const {
        const auto is_solid = [&](const Vec3& way, double depth) { return solids_.contain(x_ + way - depth * n_, 0); };
        const bool is_thin = !is_solid({}, edge_depth * loaded_.spacing);
        const auto ends = [&](const Vec3& way) {
            return !is_solid(distance * way, (is_thin ? height : edge_depth) * loaded_.spacing);
        };
        return ends(first_) || ends(-first_) || (!is_planar_ && (ends(second_) || ends(-second_)));
    }
    double pressure() {
        for (std::size_t i = 0; i < at(loaded_.samples.size()) && i < loaded_.particles.pressure_force.size(); ++i) {
            add_sample(i);
        }
        for (const std::vector<PenaltyWalls::Push>& block : loaded_.pushes) {
            for (const PenaltyWalls::Push& push : block) {
                add_push(push);
            }
        }
        return area_ > 0 ? force_ / std::max(area_, least_area)
                         : force_;  // walls that push have no particles: w of the whole plane is 1
    }

 private:
    Vec3 offset(const Vec3& place) const { return images_.nearest(place, x_) - x_; }
    double weight(const Vec3& d) const {
        const double along = fluid::sensor_weight(dot(d, first_), loaded_.spacing, side_);
        return is_planar_ ? along : along * fluid::sensor_weight(dot(d, second_), loaded_.spacing, side_);
    }
    void add_sample(std::size_t i) {
        const Vec3 d = offset(loaded_.particles.position[i]);
        const double depth = -dot(d, n_);
        if (norm_squared(d) > 4 * far_ * far_ || depth < 0 || depth > loaded_.reach + loaded_.spacing) {
            return;
        }
        const BodyId body = loaded_.samples.body(i);
        const Vec3 normal = rotate(loaded_.motion.pose[at(body.value)].orientation, loaded_.samples.normal(i));
        const bool is_two_sided = sides_ && sides_->has_water_behind();
        if (dot(normal, n_) < same_side && !is_two_sided) {
            return;  // it serves the other side alone
        }
        const Vec3 force = loaded_.particles.pressure_force[i] + (is_two_sided ? sides_->correction(i) : Vec3{});
        Vec3 foot = d + depth * n_;
        if (plane_.is_open(foot, body)) {
            const double share = weight(foot);
            // The first layer of a face lies half of its thickness deep, at most 2/3 of a spacing.
            const double middle = std::max(depth, loaded_.samples.depth(i));
            area_ += middle < 0.7 * loaded_.spacing ? share * loaded_.particles.volume[i] / (2 * middle) : 0.0;
            force_ -= share * dot(force, n_);
            return;
        }
        const Vec3 surface = x_ + d + (loaded_.samples.depth(i) + height * loaded_.spacing) * normal;
        if (solids_.contain(surface, -slack * loaded_.spacing)) {  // buried
            if (const std::optional<Vec3> place = plane_.uncovered(foot)) {
                force_ -= weight(*place) * dot(force, n_);
            }
        }
    }
    void add_push(const PenaltyWalls::Push& push) {
        const Vec3 d = offset(push.place);
        const double gap = dot(d, n_), force = dot(push.force, n_);
        if (std::abs(gap) < loaded_.spacing && force > 0 && plane_.is_open(d - gap * n_, BodyId{push.body})) {
            force_ += force * weight(d);
        }
    }

    const LoadedFaces& loaded_;
    fluid::PeriodicImages images_;
    Pose pose_;
    Vec3 x_, n_;
    bool is_planar_;
    Vec3 first_, second_;  ///< along the face
    double side_;          ///< of the sensor's square [m]
    double far_;           ///< a particle moves forces by its reach at most [m]
    Solids solids_;
    FacePlane plane_;
    bool is_open_;
    std::optional<SideForces> sides_;
    double force_{0}, area_{0};  ///< weighted sums
};

}  // namespace

double read_face(const FaceGauge& gauge, const LoadedFaces& loaded) {
    FaceReading reading(gauge, loaded);
    return reading.is_open() ? reading.pressure() : 0;
}

double read_face(const FaceGauge& gauge, const LoadedFaces& loaded, const WaterAtFace& water) {
    FaceReading reading(gauge, loaded, &water);
    return reading.is_open() ? reading.pressure() : 0;
}

bool is_near_edge(const FaceGauge& gauge, const LoadedFaces& loaded) {
    return FaceReading(gauge, loaded).ends_within(near_edge * loaded.spacing + 0.5 * gauge.side);
}

bool is_open(const FaceGauge& gauge, const LoadedFaces& loaded) { return FaceReading(gauge, loaded).is_open(); }

}  // namespace riprap::coupling
