// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/step_update.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"

namespace riprap::solid::affine {

Mat3 gradient_with_momentum(const Mat3& inertia, const Mat3& strain_rate, const Vec3& momentum) {
    const double t = trace(inertia);
    const Mat3 turning = Mat3::diagonal({t, t, t}) - inertia;
    return cross_matrix(inverse(turning) * (momentum - angular_momentum(inertia, strain_rate))) + strain_rate;
}

void update_block(const BlockSystem& system, std::int32_t block, const Mat3& gradient, BlockState& state) {
    const auto b = at(block);
    const Mat3 f = rows_at(state.deformation, b), rate = rows_at(state.velocity_gradient, b);
    const Mat3 turn = to_matrix(normalized(from_rotation_vector(spin_of(gradient)))), back = transpose(turn);
    if (system.is_fixed[b] != 0) {
        set_rows(state.deformation, b, turn * f);
        return;
    }
    const Mat3 strain = symmetric_part(gradient);
    const Mat3 moved = (turn + strain) * f;
    const Vec3 momentum = angular_momentum(f * system.inertia[b] * transpose(f), rate);
    set_rows(state.deformation, b, moved);
    set_rows(state.stress, b,
             turn * rows_at(state.stress, b) * back + elastic_stress(system.material_of(block), strain));
    set_rows(state.velocity_gradient, b,
             gradient_with_momentum(moved * system.inertia[b] * transpose(moved), turn * symmetric_part(rate) * back,
                                    momentum));
}

Mat3 elastic_strain(const Material& material, const Mat3& stress) {
    const double shear = 2 * material.shear_modulus(), lame = material.lame();
    const double mean = lame / (shear * (shear + 3 * lame)) * trace(stress);
    return (1 / shear) * stress - Mat3::diagonal({mean, mean, mean});
}

}  // namespace riprap::solid::affine
