// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/passage.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/coupling/particle_walls/solid_around.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

constexpr double shut = 0.1;  ///< widest gap that is none, over the spacing [-]

/// Tells whether two bodies are one solid where they touch.
bool are_joined(const body::BodySet& bodies, std::int32_t a, std::int32_t b) {
    return a == b || !(body::may_move(bodies, at(a)) || body::may_move(bodies, at(b)));
}

/// Adds those images of a part that come within the distance of a particle.
void add_images(const PassageScene& scene, std::int64_t p, const Vec3& x, const Vec3& velocity, double within,
                SolidAround& solid) {
    const PlacedPart& part = scene.parts[at(p)];
    const double reach = part.shape.circumradius + within;
    const Vec3 nearest = std::isfinite(reach) ? scene.images.nearest(x, part.pose.position) : x;
    for (const Vec3& shift : scene.images.shifts()) {
        const Vec3 image = nearest + shift;
        if (norm_squared(image - part.pose.position) <= reach * reach &&
            geometry::depth_below_faces(part.shape, to_body(part.pose, image)) >= -within) {
            solid.add(part.shape, part.pose, image,
                      scene.dt * (velocity - velocity_at(scene.motion, part.body, image)));
        }
    }
}

bool is_wet(const PassageScene& scene, std::size_t body) { return scene.is_dry.empty() || scene.is_dry[body] == 0; }

/// Did the particle go through the solid that a body belongs to?
bool went_through(const PassageScene& scene, std::int32_t body, const Vec3& x, const Vec3& velocity, double depth,
                  PartsAround& around) {
    const body::BodySet& bodies = scene.bodies;
    const double within = 2 * (std::max(0.0, depth) + scene.spacing);
    SolidAround solid(0.5 * shut * scene.spacing, within);
    if (!body::may_move(bodies, at(body))) {
        for (const std::int32_t part : around.within(within)) {
            add_images(scene, part, x, velocity, within, solid);
        }
    } else if (is_wet(scene, at(body))) {
        for (std::int64_t p = bodies.part_begin[at(body)]; p < bodies.part_begin[at(body) + 1]; ++p) {
            add_images(scene, p, x, velocity, within, solid);
        }
    }
    return solid.is_gone_through();
}

/// Returns the least distance of a part from a place, along the axes that do not repeat [m].
double least_distance(const PassageScene& scene, const PlacedPart& part, const Vec3& place) {
    Vec3 apart = place - part.pose.position;
    for (const Vec3& shift : scene.images.shifts()) {
        for (int axis = 0; axis < 3; ++axis) {
            apart[axis] = shift[axis] != 0 ? 0 : apart[axis];
        }
    }
    return norm(apart) - part.shape.circumradius;
}

}  // namespace

std::span<const std::int32_t> PartsAround::within(double distance) {
    if (distance <= distance_ || particles_.empty()) {
        return parts_;
    }
    constexpr double room = 1.5;  // for particles that are deeper
    distance_ = room * distance;
    parts_.clear();
    const Vec3& one = particles_.front();
    double farthest = 0;
    for (const Vec3& x : particles_) {
        farthest = std::max(farthest, norm(x - one));
    }
    for (std::size_t p = 0; p < scene_.parts.size(); ++p) {
        const auto body = at(scene_.parts[p].body);
        if (!body::may_move(scene_.bodies, body) && is_wet(scene_, body) &&
            least_distance(scene_, scene_.parts[p], one) <= distance_ + farthest) {
            parts_.push_back(static_cast<std::int32_t>(p));
        }
    }
    return parts_;
}

WallPassages passage_of(const PassageScene& scene, const Vec3& x, const Vec3& velocity, std::span<const Touch> touches,
                        PartsAround& around) {
    const auto may_have = [&](const Touch& touch) {
        const Vec3 way = scene.dt * (velocity - velocity_at(scene.motion, touch.body, touch.place));
        return touch.distance * std::abs(touch.distance) < norm_squared(way) ||  // else it is farther out than it came
               (touches.size() > 1 && touch.distance < shut * scene.spacing);
    };
    WallPassages passed;
    for (auto touch = touches.begin(); touch != touches.end(); ++touch) {
        const auto is_of_it = [&](const Touch& other) { return are_joined(scene.bodies, other.body, touch->body); };
        if (!may_have(*touch) || std::any_of(touches.begin(), touch,
                                             [&](const Touch& other) { return is_of_it(other) && may_have(other); })) {
            continue;
        }
        double depth = 0;
        bool has_part = false;  // nothing comes through ground alone
        for (const Touch& other : touches) {
            if (is_of_it(other)) {
                depth = std::max(depth, -other.distance);
                has_part = has_part || !other.is_ground;
            }
        }
        if (has_part && went_through(scene, touch->body, x, velocity, depth, around)) {
            passed.add({1, touch->body});
        }
    }
    return passed;
}

}  // namespace riprap::coupling
