// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/make_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/body/ground.hpp"
#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/solid/affine/ground.hpp"

namespace riprap::solid::affine {

namespace {

/// The surface of ground; that of a planar scene reaches beyond the blocks to both sides, which are as thick as it is.
geometry::TriangleField surface_of_ground(const SolidScene& scene, BodyId body) {
    geometry::TriangleField field = ground_field(scene.bodies, scene.shapes, body);
    if (!scene.bodies.is_planar) {
        return field;
    }
    geometry::TriangleMesh mesh = field.mesh();
    for (Vec3& x : mesh.points) {
        x.z *= 2;
    }
    return {std::move(mesh), {0, 1, 0}};
}

std::int32_t part_count(const body::BodySet& bodies, std::int32_t b) {
    return bodies.part_begin[at(b) + 1] - bodies.part_begin[at(b)];
}

Shape half_space_shape(const Vec3& normal, double offset) {
    Shape shape;
    shape.plane_normal = normalized(normal);
    shape.plane_offset = offset / norm(normal);
    return shape;
}

Shape convex_shape(const geometry::Polyhedron& polyhedron) {
    const geometry::MassProperties properties = geometry::mass_properties(polyhedron);
    Shape shape;
    shape.topology = contact::hull_topology(polyhedron);
    shape.volume = properties.volume;
    shape.second_moment = properties.second_moment;
    shape.size = std::cbrt(properties.volume);
    for (const Vec3& x : polyhedron.vertices) {
        shape.vertices.push_back(x - properties.centroid);
        shape.circumradius = std::max(shape.circumradius, norm(shape.vertices.back()));
    }
    return shape;
}

Shape shape_of_body(const SolidScene& scene, std::int32_t b) {
    if (is_ground(scene.bodies, scene.shapes, BodyId{b})) {
        return ground_shape(surface_of_ground(scene, BodyId{b}));
    }
    const body::Part& part = scene.bodies.parts[at(scene.bodies.part_begin[at(b)])];
    if (scene.shapes.is_half_space(part.shape)) {
        const geometry::ConvexView view = scene.shapes.view(part.shape);
        const Vec3 normal = rotate(part.local.orientation, view.normal(0));
        return half_space_shape(normal, view.offset[0] + dot(normal, part.local.position));
    }
    Shape shape = convex_shape(geometry::moved(scene.shapes.polyhedron(part.shape), part.local));
    shape.round_radius = scene.shapes.view(part.shape).round_radius;
    if (scene.bodies.is_planar) {
        // Lengths of the method follow the section, whatever its scale, not the metre by which it is thick.
        shape.size = std::sqrt(shape.volume);
    }
    return shape;
}

}  // namespace

double smallest_radius(const SolidScene& scene) {
    double smallest = 0;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        const body::Part& part = scene.bodies.parts[at(scene.bodies.part_begin[at(b)])];
        if (body::may_move(scene.bodies, at(b)) && !scene.shapes.is_half_space(part.shape)) {
            const double radius = scene.shapes.view(part.shape).circumradius;
            smallest = smallest > 0 ? std::min(smallest, radius) : radius;
        }
    }
    return smallest;
}

double least_contact_area(const SolidScene& scene) {
    const double radius = smallest_radius(scene);
    return 0.01 * radius * radius;
}

double corner_stiffness(const SolidScene& scene, const Elasticity& elasticity) {
    return elasticity.stiffness_per_area ? *elasticity.stiffness_per_area * least_contact_area(scene)
                                         : elasticity.contact_stiffness;
}

std::vector<SceneProblem> scene_problems(const SolidScene& scene) {
    std::vector<SceneProblem> problems;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        if (part_count(scene.bodies, b) != 1 && !is_ground(scene.bodies, scene.shapes, BodyId{b})) {
            problems.push_back({BodyId{b}, fmt::format("'{}' has several parts", scene.bodies.name(BodyId{b})),
                                "one convex polyhedron, as a deformable block is"});
        }
    }
    return problems;
}

namespace {

void add_block(const SolidScene& scene, std::int32_t b, BlockSystem& system) {
    Shape shape = shape_of_body(scene, b);
    const MaterialId material = scene.bodies.material[at(b)];
    const double density = scene.materials[material].density, mass = density * shape.volume;
    // A body may have a density of its own.
    const double given = scene.bodies.mass[at(b)], factor = given > 0 && mass > 0 ? given / mass : 1;
    system.mass.push_back(given > 0 && mass > 0 ? given : mass);
    system.inertia.push_back(factor * (density * shape.second_moment));
    system.material.push_back(material.value);
    system.is_fixed.push_back(shape.is_convex() && body::may_move(scene.bodies, at(b)) ? 0 : 1);
    system.vertex_begin.push_back(system.vertex_begin.back() + static_cast<std::int32_t>(shape.vertices.size()));
    system.face_begin.push_back(system.face_begin.back() + shape.face_count());
    system.shapes.push_back(std::move(shape));
}

}  // namespace

std::string make_blocks(const SolidScene& scene, const Elasticity& elasticity, BlockSystem& system) {
    system = {};
    if (const std::vector<SceneProblem> problems = scene_problems(scene); !problems.empty()) {
        return problems.front().message + "; a deformable block is one convex polyhedron";
    }
    system.elasticity = elasticity;
    system.surfaces = make_surfaces(scene.materials, elasticity, least_contact_area(scene));
    system.surfaces.divisor = scene.strength_divisor;
    system.is_planar = scene.bodies.is_planar;
    for (std::int32_t b = 0; b < scene.bodies.size(); ++b) {
        add_block(scene, b, system);
    }
    system.fixed_points.assign(scene.fixed_points.begin(), scene.fixed_points.end());
    for (body::FixedPoint& point : system.fixed_points) {
        point.stiffness = stiffness_of(point, corner_stiffness(scene, elasticity));
    }
    return {};
}

}  // namespace riprap::solid::affine
