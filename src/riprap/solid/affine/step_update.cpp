// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/step_update.hpp"

#include "riprap/body/free_rotation.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/solid/affine/plane.hpp"

namespace riprap::solid::affine {

namespace {

/// I = tr(S) 1 - S.
Mat3 moments_of(const Mat3& inertia) {
    const double t = trace(inertia);
    return Mat3::diagonal({t, t, t}) - inertia;
}

/// Returns the turn of a block over a step in which it would turn by `turn`, did its axes stand still: it goes on with
/// the angular momentum of that, I turn, and the axes come along. A turn by exp [turn]x alone is of first order where
/// the spin does not lie along an axis: a slab that tumbles then gains energy in every step.
Mat3 turn_with_axes(const Mat3& inertia, const Vec3& turn) {
    constexpr double small = 1e-8;  // rad: the difference is of its square, below round-off
    if (norm_squared(turn) < small * small) {
        return to_matrix(normalized(from_rotation_vector(turn)));
    }
    const SymmetricEigen second = symmetric_eigen(inertia);
    const double t = second.values.x + second.values.y + second.values.z;
    const Vec3 moments = Vec3{t, t, t} - second.values;
    return to_matrix(body::rotate_free({1, 0, 0, 0}, moments_of(inertia) * turn, moments, from_matrix(second.axes), 1));
}

}  // namespace

Mat3 gradient_with_momentum(const Mat3& inertia, const Mat3& strain_rate, const Vec3& momentum) {
    return cross_matrix(inverse(moments_of(inertia)) * (momentum - angular_momentum(inertia, strain_rate))) +
           strain_rate;
}

void update_block(const BlockSystem& system, std::int32_t block, const Mat3& gradient, BlockState& state) {
    const auto b = at(block);
    const Mat3 f = rows_at(state.deformation, b), rate = rows_at(state.velocity_gradient, b);
    if (system.is_fixed[b] != 0) {
        set_rows(state.deformation, b, to_matrix(normalized(from_rotation_vector(spin_of(gradient)))) * f);
        return;
    }
    const Mat3 inertia = f * system.inertia[b] * transpose(f);
    const auto kept = [&system](const Mat3& m) { return system.is_planar ? in_plane(m) : m; };
    const Mat3 turn = kept(turn_with_axes(inertia, spin_of(gradient))), back = transpose(turn);
    const Mat3 strain = symmetric_part(gradient);
    const Mat3 moved = (turn + strain) * f;
    const Vec3 momentum = angular_momentum(inertia, rate);
    set_rows(state.deformation, b, moved);
    set_rows(state.stress, b, turn * rows_at(state.stress, b) * back + elastic_stress(system.elasticity, strain));
    set_rows(state.velocity_gradient, b,
             kept(gradient_with_momentum(moved * system.inertia[b] * transpose(moved),
                                         turn * symmetric_part(rate) * back, momentum)));
}

Mat3 elastic_strain(const Elasticity& material, const Mat3& stress) {
    const double shear = 2 * material.shear_modulus(), lame = material.lame();
    const double mean = lame / (shear * (shear + 3 * lame)) * trace(stress);
    return (1 / shear) * stress - Mat3::diagonal({mean, mean, mean});
}

}  // namespace riprap::solid::affine
