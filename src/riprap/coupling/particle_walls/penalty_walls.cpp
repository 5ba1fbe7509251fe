// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/penalty_walls.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ranges>

#include "riprap/core/parallel.hpp"
#include "riprap/coupling/particle_walls/near_parts.hpp"
#include "riprap/fluid/particle/periodic_images.hpp"
#include "riprap/geometry/convex_query.hpp"

namespace riprap::coupling {

namespace {

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

constexpr std::int64_t block_size = 1024;  ///< particles whose pushes are kept together; decides no bit
static_assert(block_size % fluid::SparseVectors::block_size == 0);

/// Places all parts; those of dry bodies, and of a ground, which is met as one surface, reach nowhere.
void place_parts(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::Motion& motion,
                 std::span<const std::uint8_t> is_dry, std::span<const body::Ground> grounds, double reach,
                 std::vector<PlacedPart>& parts) {
    parts.resize(bodies.parts.size());
    parallel::for_each(static_cast<std::int64_t>(parts.size()), [&](std::int64_t p) {
        const body::Part& part = bodies.parts[at(p)];
        const auto b = at(part.body.value);
        const bool is_ground = std::ranges::find(grounds, part.body, &body::Ground::body) != grounds.end();
        const geometry::ConvexView view = shapes.view(part.shape);
        const bool is_wet = !is_ground && (is_dry.empty() || is_dry[b] == 0);
        parts[at(p)] = {
            view,
            {to_world(motion.pose[b], part.local.position), motion.pose[b].orientation * part.local.orientation},
            part.body.value,
            is_wet ? view.circumradius + reach : -1};
    });
}

/// Position of a part relative to a particle.
struct Touch {
    Vec3 place;       ///< of the particle's image [m]
    Vec3 normal;      ///< n
    double distance;  ///< of the nearest face, negative inside [m]
    double reach;     ///< of the push [m]
    std::int32_t body;
};

/// The part's, if it is nearer to a particle at one place than `within`.
std::optional<Touch> touch_at(const PlacedPart& part, const Vec3& x, double within) {
    if (norm_squared(x - part.pose.position) > part.reach * part.reach) {
        return std::nullopt;
    }
    const Vec3 local = to_body(part.pose, x);
    if (geometry::depth_below_faces(part.shape, local) <= -within) {
        return std::nullopt;
    }
    const geometry::SurfacePoint near = geometry::closest_surface_point(part.shape, local);
    if (near.distance >= within) {
        return std::nullopt;
    }
    return Touch{x, rotate(part.pose.orientation, near.normal), near.distance, 0.5 * within, part.body};
}

/// Returns the deepest of the images of a particle.
std::optional<Touch> deepest_touch(const PlacedPart& part, const Vec3& x, double within,
                                   const fluid::PeriodicImages& images) {
    const Vec3 nearest = std::isfinite(part.reach) ? images.nearest(x, part.pose.position) : x;
    std::optional<Touch> deepest;
    for (const Vec3& shift : images.shifts()) {
        const std::optional<Touch> touch = touch_at(part, nearest + shift, within);
        if (touch && (!deepest || touch->distance < deepest->distance)) {
            deepest = touch;
        }
    }
    return deepest;
}

/// Does the way from one place to another meet a convex part? In its frame.
bool meets(const geometry::ConvexView& shape, const Vec3& from, const Vec3& to) {
    double enter = 0, leave = 1;
    for (int j = 0; j < shape.face_count; ++j) {
        const double begin = dot(shape.normal(j), from) - shape.offset[j],
                     end = dot(shape.normal(j), to) - shape.offset[j];
        if (begin > 0 && end > 0) {
            return false;
        }
        if (begin > 0) {
            enter = std::max(enter, begin / (begin - end));
        } else if (end > 0) {
            leave = std::min(leave, begin / (begin - end));
        }
    }
    return enter <= leave;
}

/// Distance from a place in a part to the tip at which two of its faces meet; infinite where they are parallel [m].
double distance_to_tip(const geometry::ConvexView& shape, const Vec3& place, const Vec3& normal, const Vec3& other) {
    constexpr double parallel = 1e-9;
    const Vec3 towards = normal + other;
    double distance = std::numeric_limits<double>::infinity();
    if (norm_squared(towards) < parallel) {
        return distance;
    }
    for (int j = 0; j < shape.face_count; ++j) {
        const double rate = dot(shape.normal(j), towards);
        if (rate > parallel) {
            distance = std::min(distance, std::max(0.0, shape.offset[j] - dot(shape.normal(j), place)) / rate);
        }
    }
    return distance * norm(towards);
}

/// Did a particle go through a part on its way [m] to the place of a touch? Not where it may have gone around a tip.
bool went_through(const PlacedPart& part, const Touch& touch, const Vec3& way) {
    constexpr double away = -0.5;
    if (touch.distance * std::abs(touch.distance) >= norm_squared(way)) {
        return false;  // it is farther out than it came
    }
    const Vec3 to = to_body(part.pose, touch.place), from = to_body(part.pose, touch.place - way);
    if (!meets(part.shape, from, to)) {
        return false;
    }
    const Vec3 before = geometry::closest_surface_point(part.shape, from).normal;
    const Vec3 after = geometry::closest_surface_point(part.shape, to).normal;
    return dot(before, after) < away && distance_to_tip(part.shape, 0.5 * (from + to), before, after) > 2 * norm(way);
}

/// The push of ground: of its surface as one, so that no edge between two triangles is felt.
std::optional<Touch> touch_ground(const body::Ground& ground, const Pose& pose, const Vec3& x, double within,
                                  const fluid::PeriodicImages& images) {
    std::optional<Touch> deepest;
    for (const Vec3& shift : images.shifts()) {
        const auto near = ground.field.nearest(to_body(pose, x + shift), within);
        if (near && near->distance < within && (!deepest || near->distance < deepest->distance)) {
            deepest = Touch{x + shift, rotate(pose.orientation, near->normal), near->distance, 0.5 * within,
                            ground.body.value};
        }
    }
    return deepest;
}

/// Between opposite faces neither pushes beyond the middle.
void meet_in_the_middle(std::vector<Touch>& touches) {
    constexpr double looking = -0.5;
    for (Touch& one : touches) {
        for (const Touch& other : touches) {
            if (dot(one.normal, other.normal) < looking) {
                one.reach = std::min(one.reach, 0.5 * (one.distance + other.distance));
            }
        }
    }
}

/// Settings from the reach over the spacing and the stiffness over rho_0 c_0^2 dp^(dim-2).
PenaltySettings scaled_settings(const fluid::ParticleSettings& settings, double reach, double strength) {
    constexpr double damping_ratio = 0.5;
    const double stiffness = strength * settings.rest_density * settings.sound_speed * settings.sound_speed *
                             std::pow(settings.spacing, settings.domain.dimension - 2);
    return {reach * settings.spacing, stiffness, 2 * damping_ratio * std::sqrt(stiffness * settings.particle_mass),
            settings.domain};
}

}  // namespace

PenaltySettings penalty_settings(const fluid::ParticleSettings& settings, double dt) {
    PenaltySettings penalty = scaled_settings(settings, 0.5, 0.1);
    penalty.dt = dt;
    return penalty;
}

PenaltySettings guard_settings(const fluid::ParticleSettings& settings, double dt) {
    PenaltySettings guard = scaled_settings(settings, 0.2, 0.5);
    guard.fastest_return = 0.05 * settings.sound_speed;
    guard.hardest = settings.particle_mass / dt;
    guard.dt = dt;
    return guard;
}

void PenaltyWalls::push(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::Motion& motion,
                        std::span<const std::uint8_t> is_dry, const PenaltySettings& settings,
                        std::span<const double> share, const fluid::ParticleState& particles,
                        fluid::SparseVectors& force, FluidLoads& loads) {
    const double within = 2 * settings.reach;  // where a face on the other side may limit the push
    find_grounds(shapes, bodies);
    std::vector<PlacedPart> parts;
    place_parts(shapes, bodies, motion, is_dry, grounds_, within, parts);
    NearParts near_parts;
    near_parts.find(parts, particles.position, settings.domain, within);
    force.reset(at(particles.size()));
    blocks_.resize(at((particles.size() + block_size - 1) / block_size));
    passed_.assign(blocks_.size(), {});
    const fluid::PeriodicImages images(settings.domain);
    const auto velocity_at = [&motion](std::int32_t body, const Vec3& x) {
        const auto b = at(body);
        return motion.velocity[b] + cross(motion.angular_velocity[b], x - motion.pose[b].position);
    };
    parallel::for_ranges(particles.size(), block_size, [&](std::int64_t begin, std::int64_t end) {
        std::vector<Push>& pushes = blocks_[at(begin / block_size)];
        pushes.clear();
        std::vector<Touch> touches;
        for (std::int64_t i = begin; i < end; ++i) {
            const std::span<const std::int32_t> near = near_parts.of_block(i / NearParts::block_size);
            if (near.empty() && grounds_.empty()) {
                i = (i / NearParts::block_size + 1) * NearParts::block_size - 1;
                continue;
            }
            touches.clear();
            for (const std::int32_t part : near) {
                if (const auto touch = deepest_touch(parts[at(part)], particles.position[at(i)], within, images)) {
                    touches.push_back(*touch);
                    const Vec3 speed = particles.velocity[at(i)] - velocity_at(touch->body, touch->place);
                    if (went_through(parts[at(part)], *touch, settings.dt * speed)) {
                        passed_[at(begin / block_size)].add({1, touch->body});
                    }
                }
            }
            for (const body::Ground& ground : grounds_) {
                if (!is_dry.empty() && is_dry[at(ground.body.value)] != 0) {
                    continue;
                }
                if (const auto touch = touch_ground(ground, motion.pose[at(ground.body.value)],
                                                    particles.position[at(i)], within, images)) {
                    touches.push_back(*touch);
                }
            }
            meet_in_the_middle(touches);
            for (const Touch& touch : touches) {
                const double overlap = touch.reach - touch.distance;
                if (overlap <= 0) {
                    continue;
                }
                const double closing =
                    dot(particles.velocity[at(i)] - velocity_at(touch.body, touch.place), touch.normal);
                const double factor = share.empty() ? 1 : share[at(touch.body)];
                const double most = settings.hardest * std::max(0.0, settings.fastest_return - closing);
                const double size =
                    std::min(most, settings.stiffness * overlap - settings.damping * std::min(0.0, closing));
                const Vec3 push = factor * size * touch.normal;
                force.add(at(i), push);
                pushes.push_back({touch.body, push, touch.place});
            }
        }
    });
    passages_ = {};
    for (const WallPassages& passed : passed_) {
        passages_.add(passed);
    }
    gather(bodies, motion, loads);
}

void PenaltyWalls::find_grounds(const geometry::ShapeSet& shapes, const body::BodySet& bodies) {
    if (parts_ != bodies.parts.size()) {
        grounds_ = body::find_grounds(bodies, shapes);
        parts_ = bodies.parts.size();
    }
}

/// On one thread, in the order of the particles.
void PenaltyWalls::gather(const body::BodySet& bodies, const body::Motion& motion, FluidLoads& loads) const {
    const auto count = at(bodies.size());
    loads.pressure.clear(count, motion.deforms());
    loads.viscous.clear(count, motion.deforms());
    for (const std::vector<Push>& pushes : blocks_) {
        for (const Push& push : pushes) {
            const auto b = at(push.body);
            loads.pressure.force[b] -= push.force;
            const Vec3 arm = push.place - motion.pose[b].position;
            loads.pressure.torque[b] -= cross(arm, push.force);
            if (motion.deforms()) {
                loads.pressure.pull[b] += -1.0 * symmetric_product(push.force, arm);
            }
        }
    }
}

}  // namespace riprap::coupling
