// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/penalty_walls.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/periodic_images.hpp"
#include "riprap/geometry/convex_query.hpp"

namespace riprap::coupling {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

constexpr std::int64_t block_size = 1024;  ///< particles whose pushes are kept together; decides no bit

/// A part that may push, where it is.
struct PlacedPart {
    geometry::ConvexView shape;
    Pose pose;
    std::int32_t body;
    double reach;  ///< beyond this distance from its centre nothing is pushed [m]
};

std::vector<PlacedPart> place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies,
                                    const BodyMotion& motion, std::span<const std::uint8_t> is_dry, double reach) {
    std::vector<PlacedPart> parts;
    for (const body::Part& part : bodies.parts) {
        const auto b = at(part.body.value);
        if (!is_dry.empty() && is_dry[b] != 0) {
            continue;
        }
        const geometry::ConvexView view = shapes.view(part.shape);
        parts.push_back(
            {view,
             {to_world(motion.pose[b], part.local.position), motion.pose[b].orientation * part.local.orientation},
             part.body.value,
             view.circumradius + reach});
    }
    return parts;
}

/// How a part touches a particle.
struct Touch {
    Vec3 place;         ///< of the particle's image [m]
    Vec3 normal;        ///< n
    double overlap{0};  ///< d; 0 = none [m]
};

/// The touch of a part with a particle at one place.
Touch touch_at(const PlacedPart& part, const Vec3& x, double reach) {
    if (norm_squared(x - part.pose.position) > part.reach * part.reach) {
        return {};
    }
    const Vec3 local = to_body(part.pose, x);
    if (geometry::depth_below_faces(part.shape, local) <= -reach) {
        return {};
    }
    const geometry::SurfacePoint near = geometry::closest_surface_point(part.shape, local);
    return {x, rotate(part.pose.orientation, near.normal), std::max(0.0, reach - near.distance)};
}

/// The deepest touch of a part with the images of a particle.
Touch deepest_touch(const PlacedPart& part, const Vec3& x, double reach, const fluid::PeriodicImages& images) {
    const Vec3 nearest = std::isfinite(part.reach) ? images.nearest(x, part.pose.position) : x;
    Touch deepest;
    for (const Vec3& shift : images.shifts()) {
        const Touch touch = touch_at(part, nearest + shift, reach);
        if (touch.overlap > deepest.overlap) {
            deepest = touch;
        }
    }
    return deepest;
}

/// Settings from the reach over the spacing and the stiffness over rho_0 c_0^2 dp^(dim-2).
PenaltySettings scaled_settings(const fluid::SphSettings& settings, double reach, double strength) {
    constexpr double damping_ratio = 0.5;
    const double stiffness = strength * settings.rest_density * settings.sound_speed * settings.sound_speed *
                             std::pow(settings.spacing, settings.domain.dimension - 2);
    return {reach * settings.spacing, stiffness, 2 * damping_ratio * std::sqrt(stiffness * settings.particle_mass),
            settings.domain};
}

}  // namespace

PenaltySettings penalty_settings(const fluid::SphSettings& settings) { return scaled_settings(settings, 0.5, 0.1); }

PenaltySettings guard_settings(const fluid::SphSettings& settings) { return scaled_settings(settings, 0.2, 0.5); }

void PenaltyWalls::push(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const BodyMotion& motion,
                        std::span<const std::uint8_t> is_dry, const PenaltySettings& settings,
                        std::span<const double> share, const fluid::ParticleState& particles, std::vector<Vec3>& force,
                        FluidLoads& loads) {
    const std::vector<PlacedPart> parts = place_parts(shapes, bodies, motion, is_dry, settings.reach);
    force.assign(at(particles.size()), {});
    blocks_.resize(at((particles.size() + block_size - 1) / block_size));
    count_.assign(at(particles.size()), 0);
    const fluid::PeriodicImages images(settings.domain);
    const auto velocity_at = [&motion](std::int32_t body, const Vec3& x) {
        const auto b = at(body);
        return motion.velocity[b] + cross(motion.angular_velocity[b], x - motion.pose[b].position);
    };
    parallel::for_ranges(particles.size(), block_size, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Push>& pushes = blocks_[at(begin / block_size)];
        pushes.clear();
        for (std::int64_t i = begin; i < end; ++i) {
            for (const PlacedPart& part : parts) {
                const Touch touch = deepest_touch(part, particles.position[at(i)], settings.reach, images);
                if (touch.overlap <= 0) {
                    continue;
                }
                const double closing =
                    dot(particles.velocity[at(i)] - velocity_at(part.body, touch.place), touch.normal);
                const double factor = share.empty() ? 1 : share[at(part.body)];
                const double size = settings.stiffness * touch.overlap - settings.damping * std::min(0.0, closing);
                const Vec3 push = factor * size * touch.normal;
                force[at(i)] += push;
                count_[at(i)] += 1;
                pushes.push_back({part.body, push, touch.place});
            }
        }
    });
    gather(bodies, motion, particles.size(), loads);
}

/// On one thread, in the order of the particles.
void PenaltyWalls::gather(const body::BodySet& bodies, const BodyMotion& motion, std::int64_t particles,
                          FluidLoads& loads) const {
    const auto count = at(bodies.size());
    loads.pressure_force.assign(count, {});
    loads.pressure_torque.assign(count, {});
    loads.viscous_force.assign(count, {});
    loads.viscous_torque.assign(count, {});
    std::int64_t i = 0;
    for (const std::vector<Push>& pushes : blocks_) {
        const std::int64_t end = std::min(i + block_size, particles);
        for (std::size_t k = 0; i < end; ++i) {
            for (std::int32_t n = 0; n < count_[at(i)]; ++n, ++k) {
                const auto b = at(pushes[k].body);
                loads.pressure_force[b] -= pushes[k].force;
                loads.pressure_torque[b] -= cross(pushes[k].place - motion.pose[b].position, pushes[k].force);
            }
        }
    }
}

}  // namespace riprap::coupling
