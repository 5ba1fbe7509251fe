// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/place.hpp"

#include <algorithm>

#include "riprap/body/locks.hpp"
#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::solid::sphere_dem {

namespace {

Vec3 centroid(const TriangleSet& triangles, std::size_t t) {
    return (triangles.corners[3 * t] + triangles.corners[3 * t + 1] + triangles.corners[3 * t + 2]) / 3.0;
}

/// Fills what does not change: radii, bodies, mobility, the parts that are giants.
void describe(const SphereModel& model, SphereScratch& scratch) {
    const body::BodySet& bodies = model.bodies;
    Placed& placed = scratch.placed;
    const auto spheres = at(model.spheres.size()), parts = at(bodies.part_count()),
               triangles = at(model.triangles.size());
    const std::size_t count = spheres + parts + triangles;
    placed.center.resize(count);
    placed.radius.resize(count);
    placed.body.resize(count);
    placed.is_mobile.resize(count);
    placed.records.resize(spheres);
    placed.part_frame.resize(parts);
    placed.corner.resize(3 * triangles);
    std::vector<std::uint8_t> has_triangles(at(bodies.size()), 0);
    for (const std::int32_t body : model.triangles.body) {
        has_triangles[at(body)] = 1;
    }
    for (std::size_t k = 0; k < count; ++k) {
        std::int32_t body = 0;
        if (k < spheres) {
            placed.radius[k] = model.spheres.radius[k];
            body = model.spheres.body[k];
        } else if (k < spheres + parts) {
            const body::Part& part = bodies.parts[k - spheres];
            body = part.body.value;
            // A part that its spheres or triangles stand for is met by nothing: a point that no search dwells on.
            const bool is_met = (model.spheres.count_of(body) == 0 || model.spheres.is_sampled[at(body)] != 0) &&
                                has_triangles[at(body)] == 0;
            placed.radius[k] = !is_met ? 0 : model.shapes.view(part.shape).circumradius;
        } else {
            const std::size_t t = k - spheres - parts;
            const Vec3 middle = centroid(model.triangles, t);
            placed.radius[k] = std::max({norm(model.triangles.corners[3 * t] - middle),
                                         norm(model.triangles.corners[3 * t + 1] - middle),
                                         norm(model.triangles.corners[3 * t + 2] - middle)});
            body = model.triangles.body[t];
        }
        placed.body[k] = body;
        placed.is_mobile[k] = may_move(bodies, at(body)) ? 1 : 0;
    }
    // With the radii of sharp samples, 0.005 R, as the measure, pairs would be searched anew in nearly every step.
    placed.median_radius = contact::median_radius(model.spheres.curvature);
    placed.giants.clear();
    for (const std::int32_t part : contact::choose_giants(placed.radius)) {
        if (at(part) >= spheres && at(part) < spheres + parts) {
            placed.giants.push_back({part, model.shapes.view(bodies.parts[at(part) - spheres].shape), {}});
        }
    }
    scratch.is_simple = true;
    for (std::size_t b = 0; b < at(bodies.size()); ++b) {
        const std::size_t first = at(model.spheres.begin[b]);
        const Vec3& moments = bodies.principal_moments[b];
        const bool is_one = model.spheres.count_of(static_cast<std::int32_t>(b)) == 1 &&
                            model.spheres.local[first] == Vec3{} && moments.x == moments.y && moments.y == moments.z &&
                            !locks_of(bodies, b).any();
        scratch.is_simple = scratch.is_simple && (!may_move(bodies, b) || is_one);
    }
    scratch.is_prepared = true;
}

void place_spheres(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch) {
    Placed& placed = scratch.placed;
    parallel::for_each(model.spheres.size(), [&](std::int64_t index) {
        const auto s = at(index), b = at(model.spheres.body[s]);
        const Vec3& local = model.spheres.local[s];
        const Vec3& spin = scratch.kinematics.angular_velocity[b];
        Vec3 x = state.position[b], v = state.velocity[b];
        if (!(local == Vec3{})) {
            const Vec3 arm = rotate(state.orientation[b], local);
            x += arm;
            v += cross(spin, arm);
        }
        placed.center[s] = x;
        placed.records[s] = {x.x,    x.y,    x.z,    model.spheres.radius[s],
                             v.x,    v.y,    v.z,    scratch.kinematics.inverse_mass[b],
                             spin.x, spin.y, spin.z, static_cast<double>(model.bodies.material[b].value)};
    });
}

}  // namespace

void place(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch) {
    Placed& placed = scratch.placed;
    const auto spheres = at(model.spheres.size()), parts = at(model.bodies.part_count());
    if (!scratch.is_prepared || placed.radius.size() != spheres + parts + at(model.triangles.size())) {
        describe(model, scratch);
    }
    place_spheres(model, state, scratch);
    parallel::for_each(model.bodies.part_count(), [&](std::int64_t p) {
        const body::Part& part = model.bodies.parts[at(p)];
        const auto b = at(part.body.value);
        const Pose pose{state.position[b], state.orientation[b]};
        contact::Frame& frame = placed.part_frame[at(p)];
        frame = contact::to_frame({to_world(pose, part.local.position), pose.orientation * part.local.orientation});
        placed.center[spheres + at(p)] = frame.origin;
    });
    for (contact::Giant& giant : placed.giants) {
        giant.frame = placed.part_frame[at(giant.part) - spheres];
    }
    parallel::for_each(model.triangles.size(), [&](std::int64_t index) {
        const auto t = at(index), b = at(model.triangles.body[t]);
        const Pose pose{state.position[b], state.orientation[b]};
        for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
            placed.corner[k] = to_world(pose, model.triangles.corners[k]);
        }
        placed.center[spheres + parts + t] = to_world(pose, centroid(model.triangles, t));
    });
}

}  // namespace riprap::solid::sphere_dem
