// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/scene_bridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/restitution.hpp"
#include "riprap/solid/planar_dda/outline.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid::planar_dda {

namespace {

double angle_of(const Quat& turn) { return 2 * std::atan2(turn.z, turn.w); }
Quat turn_of(double angle) { return {std::cos(0.5 * angle), 0, 0, std::sin(0.5 * angle)}; }
Vec2 turned(double angle, const Vec2& x) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x.x - s * x.y, s * x.x + c * x.y};
}
bool is_half_space(const SolidScene& scene, std::size_t b) {
    return scene.shapes.is_half_space(scene.bodies.parts[at(scene.bodies.part_begin[b])].shape);
}

Joint joint_of(const material::MaterialSet& materials, MaterialId a, MaterialId b,
               const affine::Elasticity& elasticity) {
    const material::PairProperties& pair = materials.pair(a, b);
    const double shear =
        pair.shear_stiffness > 0 ? pair.shear_stiffness : pair.shear_ratio * elasticity.contact_stiffness;
    return {elasticity.contact_stiffness,
            shear,
            pair.friction,
            pair.cohesion,
            pair.tensile_strength,
            affine::damping_ratio_of(materials, a, b)};
}

void add_materials(const SolidScene& scene, const affine::Elasticity& elasticity, Model& model) {
    for (int m = 0; m < scene.materials.size(); ++m) {
        model.materials.push_back(
            {scene.materials[MaterialId{m}].density, elasticity.youngs_modulus, elasticity.poisson_ratio});
    }
    for (int a = 0; a < scene.materials.size(); ++a) {
        for (int b = a; b < scene.materials.size(); ++b) {
            model.set_joint(a, b, joint_of(scene.materials, MaterialId{a}, MaterialId{b}, elasticity));
        }
    }
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
    const Vec2 about = around.center - Vec2{pose.position.x, pose.position.y};
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

void add_body(const SolidScene& scene, const body::BodyState& bodies, const Disc& around, std::int32_t b,
              SceneBlocks& blocks) {
    const BodyId id{b};
    const double angle = angle_of(bodies.orientation[at(b)]);
    const Vec2 origin{bodies.position[at(b)].x, bodies.position[at(b)].y};
    const geometry::Polygon outline = outline_of_body(scene, bodies, around, b);
    Builder builder(blocks.model, blocks.state);
    const auto made = builder.add_block(outline, scene.bodies.material[at(b)].value, false);
    if (!made) {
        blocks.problems.push_back(
            {id,
             fmt::format("'{}' is no block of planar DDA: {}", scene.bodies.name(id),
                         outline.empty() ? "its parts do not make one polygon" : made.problems().front().message),
             "a simple polygon, or parts that share whole edges"});
        return;
    }
    // add_block has taken the body frame for the world: put the block where the body is.
    const Vec2 offset{blocks.state.x.back(), blocks.state.y.back()};
    const Vec2 place = origin + turned(angle, offset);
    blocks.offset.push_back(offset);
    blocks.state.x.back() = place.x;
    blocks.state.y.back() = place.y;
    blocks.state.angle.back() = angle;
    const Unknowns rates = rates_of_body(scene, bodies, b);
    std::copy(rates.begin(), rates.end(), blocks.state.rates.end() - 6);
    if (scene.bodies.mass[at(b)] > 0) {
        blocks.model.mass.back() = scene.bodies.mass[at(b)];
    }
    blocks.model.names.push_back(scene.bodies.name(id));
    if (!is_half_space(scene, at(b))) {
        blocks.smallest = std::min(blocks.smallest, std::sqrt(blocks.model.area.back()));
    }
}

/// Fixed points and bolts of the scene, whose ends are given in the frames of the bodies.
void add_supports(const SolidScene& scene, double contact_stiffness, SceneBlocks& blocks) {
    const auto local = [&blocks](BodyId body, const Vec3& point) {
        return Vec2{point.x, point.y} - blocks.offset[at(body.value)];
    };
    for (const body::FixedPoint& p : scene.fixed_points) {
        blocks.model.fixed_points.push_back({p.body.value,
                                             local(p.body, p.point),
                                             {p.place.x, p.place.y},
                                             p.stiffness > 0 ? p.stiffness : 100 * contact_stiffness});
    }
    for (const body::Bolt& bolt : scene.bolts) {
        blocks.model.bolts.push_back({bolt.first.value, bolt.second.value, local(bolt.first, bolt.first_point),
                                      local(bolt.second, bolt.second_point), bolt.stiffness, bolt.rest_length});
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

void make_blocks(const SolidScene& scene, const body::BodyState& bodies, const Disc& around,
                 const affine::Elasticity& elasticity, PlaneState plane, SceneBlocks& blocks) {
    blocks = {};
    if (!scene.bodies.is_planar) {
        blocks.problems.push_back(
            {{}, "planar DDA moves polygons in the x-y plane, and this scene has three dimensions", "dimension = 2"});
        return;
    }
    blocks.model.plane = plane;
    add_materials(scene, elasticity, blocks.model);
    blocks.smallest = 2 * around.radius;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        add_body(scene, bodies, around, b, blocks);
    }
    if (blocks.problems.empty()) {
        add_supports(scene, elasticity.contact_stiffness, blocks);
    }
    for (const geometry::GeometryProblem& problem : problems_of(blocks.model)) {
        blocks.problems.push_back({{}, problem.message, problem.allowed});
    }
}

void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, const State& state,
                  SceneBlocks& blocks, std::vector<Unknowns>& driven) {
    driven.assign(at(blocks.model.block_count()), Unknowns{});
    for (std::int32_t b = 0; b < blocks.model.block_count(); ++b) {
        const auto i = at(b);
        const BodyId id{b};
        blocks.model.is_fixed[i] = is_free(scene.bodies, id, span.time) ? 0 : 1;
        if (blocks.model.is_fixed[i] == 0 || scene.bodies.drive[i] != body::Drive::driven) {
            continue;
        }
        const Pose there = driven_state(scene.bodies, id, span.end()).pose;
        const Vec3 corrected = bodies.drive_offset.empty() ? Vec3{} : bodies.drive_offset[i];
        const double angle = angle_of(there.orientation);
        const Vec2 place =
            Vec2{there.position.x + corrected.x, there.position.y + corrected.y} + turned(angle, blocks.offset[i]);
        driven[i] = {place.x - state.x[i], place.y - state.y[i],
                     std::remainder(angle - state.angle[i], 2 * std::numbers::pi)};
    }
}

void read_loads(const body::LoadView& loads, std::vector<Unknowns>& sums) {
    sums.resize(loads.force.size());
    for (std::size_t b = 0; b < sums.size(); ++b) {
        const Sym3 pull = loads.pull.empty() ? Sym3{} : loads.pull[b];
        sums[b] = {loads.force[b].x, loads.force[b].y, loads.torque[b].z, pull.xx, pull.yy, pull.xy};
    }
}

void write_bodies(const SceneBlocks& blocks, const State& state, body::BodyState& bodies) {
    for (std::int32_t b = 0; b < blocks.model.block_count(); ++b) {
        const auto i = at(b);
        const Vec2 origin = place_of(state, b, -1.0 * blocks.offset[i]);
        const Unknowns rates = rates_of(state, b);
        const Vec2 velocity = velocity_of(state, b, -1.0 * blocks.offset[i]);
        bodies.position[i] = {origin.x, origin.y, bodies.position[i].z};
        bodies.velocity[i] = {velocity.x, velocity.y, 0};
        bodies.orientation[i] = turn_of(state.angle[i]);
        bodies.stretch[i] = {state.stretch_xx[i], state.stretch_yy[i], 1, state.stretch_xy[i], 0, 0};
        const Block6 mass = mass_block(blocks.model.mass[i], spread_of(blocks.model, state, b));
        bodies.stretch_rate[i] = {rates[3], rates[4], 0, 0.5 * rates[5], 0, 0};
        bodies.angular_momentum[i] = {0, 0, multiply(mass, rates)[2]};
    }
}

}  // namespace riprap::solid::planar_dda
