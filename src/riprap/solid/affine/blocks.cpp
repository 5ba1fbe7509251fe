// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/blocks.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"

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

Mat3 elastic_stress(const Elasticity& material, const Mat3& strain) {
    const double pressure = material.lame() * trace(strain);
    return Mat3::diagonal({pressure, pressure, pressure}) + 2 * material.shear_modulus() * strain;
}

double elastic_energy(const Elasticity& material, const Mat3& strain) {
    double square = 0;
    for (const Vec3& row : strain.row) {
        square += norm_squared(row);
    }
    return 0.5 * material.lame() * trace(strain) * trace(strain) + material.shear_modulus() * square;
}

Vec3 angular_momentum(const Mat3& inertia, const Mat3& velocity_gradient) {
    return 2.0 * spin_of(velocity_gradient * inertia);
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
        const Shape& shape = system.shapes[b];
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
    return parallel::sum(system.size(), one);
}

}  // namespace riprap::solid::affine
