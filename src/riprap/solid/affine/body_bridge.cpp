// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/body_bridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/body/ground.hpp"
#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/ground.hpp"
#include "riprap/solid/affine/restitution.hpp"

namespace riprap::solid::affine {

namespace {

Sym3 to_sym(const Mat3& m) {
    return {m(0, 0), m(1, 1), m(2, 2), 0.5 * (m(0, 1) + m(1, 0)), 0.5 * (m(0, 2) + m(2, 0)), 0.5 * (m(1, 2) + m(2, 1))};
}
Mat3 to_mat(const Sym3& s) { return {{{s.xx, s.xy, s.xz}, {s.xy, s.yy, s.yz}, {s.xz, s.yz, s.zz}}}; }

/// U = sqrt(F^T F) and its inverse.
std::pair<Mat3, Mat3> stretch_of(const Mat3& f) {
    const SymmetricEigen eigen = symmetric_eigen(transpose(f) * f);
    const Vec3 root{std::sqrt(eigen.values.x), std::sqrt(eigen.values.y), std::sqrt(eigen.values.z)};
    const auto back = [&](const Vec3& values) { return eigen.axes * Mat3::diagonal(values) * transpose(eigen.axes); };
    return {back(root), back({1 / root.x, 1 / root.y, 1 / root.z})};
}

Surface surface_of(const material::MaterialSet& materials, MaterialId a, MaterialId b, const Elasticity& elasticity,
                   double least_area) {
    const material::PairProperties& pair = materials.pair(a, b);
    const double normal = elasticity.stiffness_per_area.value_or(elasticity.contact_stiffness);
    const double shear = pair.shear_stiffness > 0 ? pair.shear_stiffness : pair.shear_ratio * normal;
    return {normal,
            shear,
            elasticity.stiffness_per_area.has_value(),
            pair.friction,
            pair.cohesion,
            pair.tensile_strength,
            damping_ratio_of(materials, a, b),
            least_area};
}

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

std::int32_t shape_of_body(const SolidScene& scene, std::int32_t b, BlockSystem& system) {
    if (is_ground(scene.bodies, scene.shapes, BodyId{b})) {
        return add_ground(system, surface_of_ground(scene, BodyId{b}));
    }
    const body::Part& part = scene.bodies.parts[at(scene.bodies.part_begin[at(b)])];
    if (scene.shapes.is_half_space(part.shape)) {
        const geometry::ConvexView view = scene.shapes.view(part.shape);
        const Vec3 normal = rotate(part.local.orientation, view.normal(0));
        return add_half_space(system, normal, view.offset[0] + dot(normal, part.local.position));
    }
    const std::int32_t shape = add_shape(system, geometry::moved(scene.shapes.polyhedron(part.shape), part.local));
    if (scene.bodies.is_planar) {
        // Lengths of the method follow the section, whatever its scale, not the metre by which it is thick.
        Shape& prism = system.shapes.back();
        prism.size = std::sqrt(prism.volume);
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

/// Gives a block the mass of its body, which may have a density of its own.
void take_mass(double mass, BlockSystem& system) {
    if (mass > 0 && system.mass.back() > 0) {
        system.inertia.back() = (mass / system.mass.back()) * system.inertia.back();
        system.mass.back() = mass;
    }
}

}  // namespace

std::string make_blocks(const SolidScene& scene, const Elasticity& elasticity, BlockSystem& system) {
    system = {};
    if (const std::vector<SceneProblem> problems = scene_problems(scene); !problems.empty()) {
        return problems.front().message + "; a deformable block is one convex polyhedron";
    }
    for (int m = 0; m < scene.materials.size(); ++m) {
        system.materials.push_back(
            {scene.materials[MaterialId{m}].density, elasticity.youngs_modulus, elasticity.poisson_ratio});
    }
    const double least_area = least_contact_area(scene);
    for (int a = 0; a < scene.materials.size(); ++a) {
        for (int b = 0; b < scene.materials.size(); ++b) {
            system.surfaces.push_back(
                surface_of(scene.materials, MaterialId{a}, MaterialId{b}, elasticity, least_area));
        }
    }
    const body::BodySet& bodies = scene.bodies;
    system.is_planar = bodies.is_planar;
    BlockState unused;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        NewBlock block;
        block.shape = shape_of_body(scene, b, system);
        block.material = bodies.material[at(b)].value;
        add_block(system, unused, block);
        take_mass(bodies.mass[at(b)], system);
    }
    return {};
}

void start_stretching(body::BodyState& bodies) {
    if (!bodies.deforms()) {
        bodies.stretch.assign(at(bodies.size()), {1, 1, 1, 0, 0, 0});
        bodies.stretch_rate.assign(at(bodies.size()), {});
    }
}

void read_bodies(const body::BodyState& bodies, const body::BodySet& set, BlockState& blocks) {
    blocks = {};
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto i = at(b);
        const Mat3 turn = to_matrix(bodies.orientation[i]);
        const Mat3 f = bodies.deforms() ? turn * to_mat(bodies.stretch[i]) : turn;
        Mat3 gradient =
            set.principal_moments[i].x > 0 ? cross_matrix(body::angular_velocity(set, bodies, BodyId{b})) : Mat3{};
        gradient = bodies.deforms() ? gradient + to_mat(bodies.stretch_rate[i]) : gradient;
        blocks.position.push_back(bodies.position[i]);
        blocks.velocity.push_back(bodies.velocity[i]);
        const Mat3 zero{};
        blocks.deformation.insert(blocks.deformation.end(), f.row, f.row + 3);
        blocks.velocity_gradient.insert(blocks.velocity_gradient.end(), gradient.row, gradient.row + 3);
        blocks.stress.insert(blocks.stress.end(), zero.row, zero.row + 3);
    }
}

void drive_blocks(const SolidScene& scene, const TimeSpan& span, const body::BodyState& bodies, BlockSystem& system,
                  BlockState& blocks) {
    for (std::int32_t b = 0; b < system.size(); ++b) {
        const auto i = at(b);
        const BodyId id{b};
        system.is_fixed[i] = is_free(scene.bodies, id, span.time) ? 0 : 1;
        if (system.is_fixed[i] == 0) {
            continue;
        }
        blocks.velocity[i] = {};
        set_rows(blocks.velocity_gradient, i, Mat3{});
        if (scene.bodies.drive[i] == body::Drive::driven) {
            const Pose here = driven_state(scene.bodies, id, span.time).pose;
            const Pose there = driven_state(scene.bodies, id, span.end()).pose;
            const Vec3 turn = to_rotation_vector(there.orientation * conjugate(here.orientation));
            const Vec3 correction = bodies.drive_rate.empty() ? Vec3{} : bodies.drive_rate[i];
            blocks.velocity[i] = (there.position - here.position) / span.dt + correction;
            set_rows(blocks.velocity_gradient, i, cross_matrix(turn / span.dt));
        }
    }
}

void write_bodies(const BlockSystem& system, const BlockState& blocks, body::BodyState& bodies) {
    const auto count = at(system.size());
    bodies.stretch.resize(count);
    bodies.stretch_rate.resize(count);
    parallel::for_each_uneven(system.size(), 64, [&](std::int64_t b) {
        const auto i = at(b);
        const Mat3 f = rows_at(blocks.deformation, i), gradient = rows_at(blocks.velocity_gradient, i);
        const auto [stretch, shrink] = stretch_of(f);
        bodies.position[i] = blocks.position[i];
        bodies.velocity[i] = blocks.velocity[i];
        bodies.orientation[i] = normalized(from_matrix(f * shrink));
        bodies.stretch[i] = to_sym(stretch);
        bodies.stretch_rate[i] = to_sym(symmetric_part(gradient));
        bodies.angular_momentum[i] = affine::angular_momentum(f * system.inertia[i] * transpose(f), gradient);
    });
}

}  // namespace riprap::solid::affine
