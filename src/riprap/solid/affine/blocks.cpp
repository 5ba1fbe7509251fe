// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/blocks.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/geometry/shapes.hpp"

namespace riprap::solid::affine {

Mat3 dipole(const BlockLoads& loads, std::size_t block) {
    Mat3 sum{};
    if (!loads.pull.empty()) {
        sum = loads.pull[block];
    }
    if (!loads.torque.empty()) {
        sum = sum + cross_matrix(0.5 * loads.torque[block]);
    }
    return sum;
}

Mat3 elastic_stress(const Material& material, const Mat3& strain) {
    const double pressure = material.lame() * trace(strain);
    return Mat3::diagonal({pressure, pressure, pressure}) + 2 * material.shear_modulus() * strain;
}

double elastic_energy(const Material& material, const Mat3& strain) {
    double square = 0;
    for (const Vec3& row : strain.row) {
        square += norm_squared(row);
    }
    return 0.5 * material.lame() * trace(strain) * trace(strain) + material.shear_modulus() * square;
}

Vec3 angular_momentum(const Mat3& inertia, const Mat3& velocity_gradient) {
    return 2.0 * spin_of(velocity_gradient * inertia);
}

std::int32_t add_material(BlockSystem& system, const Material& material, const Surface& surface) {
    const std::size_t before = system.materials.size(), now = before + 1;
    std::vector<Surface> surfaces(now * now, surface);
    for (std::size_t i = 0; i < before; ++i) {
        for (std::size_t j = 0; j < before; ++j) {
            surfaces[i * now + j] = system.surfaces[i * before + j];
        }
    }
    system.surfaces = std::move(surfaces);
    system.materials.push_back(material);
    return static_cast<std::int32_t>(before);
}

std::int32_t add_shape(BlockSystem& system, const geometry::Polyhedron& polyhedron) {
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
    system.shapes.push_back(std::move(shape));
    return static_cast<std::int32_t>(system.shapes.size()) - 1;
}

std::int32_t add_half_space(BlockSystem& system, const Vec3& normal, double offset) {
    Shape shape;
    shape.plane_normal = normalized(normal);
    shape.plane_offset = offset / norm(normal);
    system.shapes.push_back(std::move(shape));
    return static_cast<std::int32_t>(system.shapes.size()) - 1;
}

std::int32_t add_block(BlockSystem& system, BlockState& state, const NewBlock& block) {
    const Shape& shape = system.shapes[at(block.shape)];
    const double density = system.materials[at(block.material)].density;
    system.shape.push_back(block.shape);
    system.material.push_back(block.material);
    system.is_fixed.push_back(block.is_fixed || !shape.is_convex() ? 1 : 0);
    system.mass.push_back(density * shape.volume);
    system.inertia.push_back(density * shape.second_moment);
    system.vertex_begin.push_back(system.vertex_begin.back() + static_cast<std::int32_t>(shape.vertices.size()));
    system.face_begin.push_back(system.face_begin.back() + shape.face_count());
    state.position.push_back(block.position);
    state.velocity.push_back(block.velocity);
    const Mat3 spin = cross_matrix(block.spin), zero{};
    state.deformation.insert(state.deformation.end(), block.deformation.row, block.deformation.row + 3);
    state.velocity_gradient.insert(state.velocity_gradient.end(), spin.row, spin.row + 3);
    state.stress.insert(state.stress.end(), zero.row, zero.row + 3);
    return system.size() - 1;
}

std::int32_t add_box(BlockSystem& system, BlockState& state, const Vec3& size, NewBlock block) {
    block.shape = add_shape(system, geometry::box(size));
    return add_block(system, state, block);
}

std::int32_t add_polyhedron(BlockSystem& system, BlockState& state, const geometry::Polyhedron& shape, NewBlock block) {
    block.shape = add_shape(system, shape);
    block.position = geometry::mass_properties(shape).centroid;
    return add_block(system, state, block);
}

namespace {

/// Outward normal of a half-space where its body is; a block that loads do not move is turned, never strained.
Vec3 placed_normal(const Shape& shape, const BlockState& state, std::int32_t block) {
    return normalized(rows_at(state.deformation, at(block)) * shape.plane_normal);
}
/// Offset of { x : normal . x <= offset } there [m].
double placed_offset(const Shape& shape, const BlockState& state, std::int32_t block) {
    return shape.plane_offset + dot(placed_normal(shape, state, block), state.position[at(block)]);
}

}  // namespace

contact::PlacedHull PlacedBlocks::hull(const BlockSystem& system, const BlockState& state, std::int32_t block) const {
    const Shape& shape = system.shape_of(block);
    const auto part = [block](const std::vector<Vec3>& values, const std::vector<std::int32_t>& begin) {
        return std::span(values).subspan(at(begin[at(block)]), at(begin[at(block) + 1] - begin[at(block)]));
    };
    return {&shape.topology, part(vertices, system.vertex_begin), part(normals, system.face_begin),
            state.position[at(block)], shape.is_half_space() ? placed_offset(shape, state, block) : 0};
}

void place_blocks(const BlockSystem& system, const BlockState& state, PlacedBlocks& placed) {
    placed.vertices.resize(at(system.vertex_begin.back()));
    placed.normals.resize(at(system.face_begin.back()));
    parallel::for_each_uneven(system.size(), 64, [&](std::int64_t i) {
        const auto b = at(i);
        const Shape& shape = system.shapes[at(system.shape[b])];
        Vec3* const normals = placed.normals.data() + system.face_begin[b];
        if (shape.is_ground()) {
            return;
        }
        if (shape.is_half_space()) {
            normals[0] = placed_normal(shape, state, static_cast<std::int32_t>(i));
            return;
        }
        const Mat3 f = rows_at(state.deformation, b);
        Vec3* const vertices = placed.vertices.data() + system.vertex_begin[b];
        for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
            vertices[v] = state.position[b] + f * shape.vertices[v];
        }
        contact::place_normals(shape.topology, {vertices, shape.vertices.size()},
                               {normals, at(shape.topology.face_count())});
    });
}

BlockSums measure(const BlockSystem& system, const BlockState& state) {
    const auto one = [&](std::int64_t i) {
        const auto b = at(i);
        BlockSums sums;
        if (system.is_fixed[b] != 0) {
            return sums;
        }
        const double mass = system.mass[b];
        const Mat3 f = rows_at(state.deformation, b), gradient = rows_at(state.velocity_gradient, b);
        const Mat3 inertia = f * system.inertia[b] * transpose(f);
        sums.mass = mass;
        sums.kinetic = 0.5 * (mass * norm_squared(state.velocity[b]) + trace(gradient * inertia * transpose(gradient)));
        sums.potential = -mass * dot(system.gravity, state.position[b]);
        sums.momentum = mass * state.velocity[b];
        sums.angular_momentum =
            mass * cross(state.position[b], state.velocity[b]) + angular_momentum(inertia, gradient);
        return sums;
    };
    const auto fold = [](BlockSums a, const BlockSums& b) {
        a.mass += b.mass;
        a.kinetic += b.kinetic;
        a.potential += b.potential;
        a.momentum += b.momentum;
        a.angular_momentum += b.angular_momentum;
        return a;
    };
    return parallel::reduce(system.size(), BlockSums{}, one, fold);
}

}  // namespace riprap::solid::affine
