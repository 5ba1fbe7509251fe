// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/make_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/make_blocks.hpp"
#include "riprap/solid/planar_dda/outline.hpp"
#include "riprap/solid/planar_dda/plane.hpp"

namespace riprap::solid::planar_dda {

namespace {

bool is_half_space(const SolidScene& scene, std::size_t b) {
    return scene.shapes.is_half_space(scene.bodies.parts[at(scene.bodies.part_begin[b])].shape);
}

/// Pose of a body at the start, which places the outline of a half-space: half-spaces do not fall.
Pose pose_of_half_space(const SolidScene& scene, const body::BodyState& bodies, std::int32_t b) {
    return scene.bodies.drive[at(b)] == body::Drive::driven ? driven_state(scene.bodies, BodyId{b}, 0).pose
                                                            : Pose{bodies.position[at(b)], bodies.orientation[at(b)]};
}

geometry::Polygon outline_of_body(const SolidScene& scene, const body::BodyState& bodies, const Disc& around,
                                  std::int32_t b) {
    if (!is_half_space(scene, at(b))) {
        return outline_of(scene, BodyId{b});
    }
    const Pose pose = pose_of_half_space(scene, bodies, b);
    const Vec2 about = around.center - flat(pose.position);
    return outline_of_half_space(scene, BodyId{b}, turned(-angle_of(pose.orientation), about), 100 * around.radius);
}

/// Rates (v, omega, D) of a body.
Unknowns rates_of_body(const SolidScene& scene, const body::BodyState& bodies, std::int32_t b) {
    if (!(scene.bodies.principal_moments[at(b)].x > 0)) {
        return {};
    }
    const Vec3& v = bodies.velocity[at(b)];
    return {v.x, v.y, angular_velocity(scene.bodies, bodies, BodyId{b}).z, 0, 0, 0};
}

/// Adds the corners of a block, about its centroid. @returns their perimeter [m]
double add_corners(const geometry::Polygon& polygon, const Vec2& centroid, Model& model) {
    const auto block = model.block_count();
    const auto first = static_cast<std::int32_t>(model.corner.size());
    const auto count = static_cast<std::int32_t>(polygon.size());
    double perimeter = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t next = (k + 1) % count, before = (k + count - 1) % count;
        model.corner.push_back(polygon[at(k)] - centroid);
        model.corner_block.push_back(block);
        model.corner_next.push_back(first + next);
        model.corner_before.push_back(first + before);
        const double turn = cross(polygon[at(k)] - polygon[at(before)], polygon[at(next)] - polygon[at(k)]);
        model.is_convex.push_back(turn > 0 ? 1 : 0);
        perimeter += norm(polygon[at(next)] - polygon[at(k)]);
    }
    model.corner_begin.push_back(first + count);
    return perimeter;
}

/// A body of several parts is the polygon of its outline.
double round_radius_of(const SolidScene& scene, std::int32_t b) {
    const std::int32_t first = scene.bodies.part_begin[at(b)];
    return scene.bodies.part_begin[at(b + 1)] == first + 1
               ? scene.shapes.view(scene.bodies.parts[at(first)].shape).round_radius
               : 0;
}

void add_to_model(const SolidScene& scene, std::int32_t b, const geometry::Polygon& polygon, Model& model) {
    const geometry::PolygonMoments moments = geometry::moments_of(polygon);
    const MaterialId material = scene.bodies.material[at(b)];
    const double perimeter = add_corners(polygon, moments.centroid, model), given = scene.bodies.mass[at(b)];
    model.material.push_back(material.value);
    model.is_fixed.push_back(is_free(scene.bodies, BodyId{b}, 0) ? 0 : 1);
    model.area.push_back(moments.area);
    model.mass.push_back(given > 0 ? given : scene.materials[material].density * moments.area);
    model.moment_xx.push_back(moments.xx / moments.area);
    model.moment_yy.push_back(moments.yy / moments.area);
    model.moment_xy.push_back(moments.xy / moments.area);
    model.width.push_back(2 * moments.area / perimeter);
    model.round_radius.push_back(round_radius_of(scene, b));
    model.offset.push_back(moments.centroid);
    model.names.push_back(scene.bodies.name(BodyId{b}));
}

/// Places the last block of the model where its body is.
void add_to_state(const SolidScene& scene, const body::BodyState& bodies, std::int32_t b, const Model& model,
                  State& state) {
    const double angle = angle_of(bodies.orientation[at(b)]);
    const Vec2 place = flat(bodies.position[at(b)]) + turned(angle, model.offset.back());
    state.x.push_back(place.x);
    state.y.push_back(place.y);
    state.angle.push_back(angle);
    state.stretch_xx.push_back(1);
    state.stretch_yy.push_back(1);
    state.stretch_xy.push_back(0);
    const Unknowns rates = rates_of_body(scene, bodies, b);
    state.rates.insert(state.rates.end(), rates.begin(), rates.end());
    for (auto* stress : {&state.stress_x, &state.stress_y, &state.stress_xy}) {
        stress->push_back(0);
    }
}

void add_body(const SolidScene& scene, const body::BodyState& bodies, const Disc& around, std::int32_t b,
              SceneBlocks& blocks) {
    const geometry::Polygon outline = outline_of_body(scene, bodies, around, b);
    const geometry::Outcome<geometry::Polygon> polygon = geometry::make_polygon(outline);
    if (!polygon) {
        const BodyId id{b};
        blocks.problems.push_back(
            {id,
             fmt::format("'{}' is no block of planar DDA: {}", scene.bodies.name(id),
                         outline.empty() ? "its parts do not make one polygon" : polygon.problems().front().message),
             "a simple polygon, or parts that share whole edges"});
        return;
    }
    add_to_model(scene, b, polygon.value(), blocks.model);
    add_to_state(scene, bodies, b, blocks.model, blocks.state);
    if (!is_half_space(scene, at(b))) {
        blocks.smallest = std::min(blocks.smallest, std::sqrt(blocks.model.area.back()));
    }
}

/// Takes fixed points and bolts of the scene, whose ends are given in the frames of the bodies.
void add_supports(const SolidScene& scene, Model& model) {
    const auto count_from_centroid = [&model](BodyId body, Vec3& point) {
        const Vec2 local = flat(point) - model.offset[at(body.value)];
        point = {local.x, local.y, 0};
    };
    model.fixed_points.assign(scene.fixed_points.begin(), scene.fixed_points.end());
    for (body::FixedPoint& p : model.fixed_points) {
        count_from_centroid(p.body, p.point);
        p.stiffness = affine::stiffness_of(p, model.elasticity.contact_stiffness);
    }
    model.bolts.assign(scene.bolts.begin(), scene.bolts.end());
    for (body::Bolt& bolt : model.bolts) {
        count_from_centroid(bolt.first, bolt.first_point);
        count_from_centroid(bolt.second, bolt.second_point);
    }
}

/// Tells of stiffnesses that are not positive or exceed 1e6 times Young's modulus.
void add_stiffness_problems(const Model& model, std::vector<SceneProblem>& problems) {
    const double limit = 1e6 * model.elasticity.youngs_modulus;
    std::vector<double> told;  // pairs of materials mostly have the same stiffness
    for (const affine::Surface& joint : model.surfaces.pairs) {
        for (const auto& [name, stiffness] : {std::pair{"contact_stiffness", joint.normal_stiffness},
                                              std::pair{"shear stiffness", joint.shear_stiffness}}) {
            if (!(stiffness > 0 && stiffness <= limit) &&
                std::find(told.begin(), told.end(), stiffness) == told.end()) {
                told.push_back(stiffness);
                problems.push_back({{},
                                    fmt::format("{} is {:.3g} N/m", name, stiffness),
                                    fmt::format("above 0, at most {:.3g} N/m (1e6 E times the thickness)", limit)});
            }
        }
    }
}

}  // namespace

Disc disc_around(const SolidScene& scene, const body::BodyState& bodies) {
    Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (std::size_t b = 0; b < at(scene.bodies.size()); ++b) {
        for (std::int32_t p = scene.bodies.part_begin[b]; p < scene.bodies.part_begin[b + 1]; ++p) {
            const body::Part& part = scene.bodies.parts[at(p)];
            if (!scene.shapes.is_half_space(part.shape)) {
                const Vec3 x = bodies.position[b] + rotate(bodies.orientation[b], part.local.position);
                const double r = scene.shapes.view(part.shape).circumradius;
                low = {std::min(low.x, x.x - r), std::min(low.y, x.y - r)};
                high = {std::max(high.x, x.x + r), std::max(high.y, x.y + r)};
            }
        }
    }
    return low.x > high.x ? Disc{} : Disc{0.5 * (low + high), 0.5 * norm(high - low)};
}

SceneBlocks make_blocks(const SolidScene& scene, const body::BodyState& bodies, const Disc& around,
                        const affine::Elasticity& elasticity, PlaneState plane) {
    SceneBlocks blocks;
    if (!scene.bodies.is_planar) {
        blocks.problems.push_back(
            {{}, "planar DDA moves polygons in the x-y plane, and this scene has three dimensions", "dimension = 2"});
        return blocks;
    }
    blocks.model.elasticity = elasticity;
    blocks.model.surfaces = affine::make_surfaces(scene.materials, elasticity, 0);
    blocks.model.surfaces.divisor = scene.strength_divisor;
    blocks.model.plane = plane;
    blocks.smallest = 2 * around.radius;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        add_body(scene, bodies, around, b, blocks);
    }
    if (blocks.problems.empty()) {
        add_supports(scene, blocks.model);
    }
    add_stiffness_problems(blocks.model, blocks.problems);
    return blocks;
}

}  // namespace riprap::solid::planar_dda
