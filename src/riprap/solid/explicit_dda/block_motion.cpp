// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/block_motion.hpp"

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/plane.hpp"
#include "riprap/solid/affine/step_update.hpp"

namespace riprap::solid::explicit_dda {

using affine::rows_at, affine::set_rows;

namespace {

Mat3 kept_in_plane(const affine::BlockSystem& system, const Mat3& m) {
    return system.is_planar ? affine::in_plane(m) : m;
}

Mat3 green_strain(const Mat3& f) { return 0.5 * (transpose(f) * f - Mat3::identity()); }

}  // namespace

void drift(const affine::BlockSystem& system, Form form, double h, std::int32_t block, affine::BlockState& state) {
    const auto b = at(block);
    state.position[b] += h * state.velocity[b];
    if (system.is_fixed[b] == 0 && form == Form::pseudo_rigid) {
        const Mat3 f = rows_at(state.deformation, b);
        const Mat3 rate = rows_at(state.velocity_gradient, b) * f;
        const Mat3 moved = f + h * rate;
        set_rows(state.deformation, b, kept_in_plane(system, moved));
        set_rows(state.velocity_gradient, b, kept_in_plane(system, rate * inverse(moved)));
    } else if (system.is_fixed[b] == 0 || norm_squared(affine::spin_of(rows_at(state.velocity_gradient, b))) > 0) {
        affine::update_block(system, block, h * rows_at(state.velocity_gradient, b), state);
    }
}

void kick(const affine::BlockSystem& system, Form form, const BlockForce& given, double dt, double mass_damping,
          std::int32_t block, affine::BlockState& state) {
    const auto b = at(block);
    BlockForce load = given;
    load.force.z *= system.is_planar ? 0 : 1;
    load.dipole = kept_in_plane(system, load.dipole);
    const double slow = 1 / (1 + mass_damping * dt);
    state.velocity[b] = slow * (state.velocity[b] + dt * (load.force / system.mass[b] + system.gravity));
    const Mat3 f = rows_at(state.deformation, b), gradient = rows_at(state.velocity_gradient, b);
    const affine::Elasticity& material = system.elasticity;
    const double volume = system.shape_of(block).volume;
    if (form == Form::pseudo_rigid) {
        const Mat3 second = elastic_stress(material, green_strain(f));
        const Mat3 back = inverse(f);
        const Mat3 rate =
            gradient * f + dt * ((load.dipole * transpose(back) - volume * (f * second)) * inverse(system.inertia[b]));
        set_rows(state.velocity_gradient, b, kept_in_plane(system, slow * (rate * back)));
        set_rows(state.stress, b, kept_in_plane(system, (1 / determinant(f)) * (f * second * transpose(f))));
    } else {
        const Mat3 inertia = f * system.inertia[b] * transpose(f);
        const Mat3 stress = rows_at(state.stress, b);
        const Mat3 rate = (load.dipole - (volume * determinant(f)) * stress) * inverse(inertia);
        set_rows(state.velocity_gradient, b, kept_in_plane(system, slow * (gradient + dt * rate)));
    }
}

double strain_energy(const affine::BlockSystem& system, Form form, const affine::BlockState& state,
                     std::int32_t block) {
    const Mat3 f = rows_at(state.deformation, at(block));
    const affine::Elasticity& material = system.elasticity;
    const double volume = system.shape_of(block).volume;
    if (form == Form::pseudo_rigid) {
        return volume * elastic_energy(material, green_strain(f));
    }
    const Mat3 stress = rows_at(state.stress, at(block));
    return volume * determinant(f) * elastic_energy(material, affine::elastic_strain(material, stress));
}

}  // namespace riprap::solid::explicit_dda
