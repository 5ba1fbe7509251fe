// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/blocks.hpp"

namespace riprap::solid::affine {

/// Brings a block to the end of a step whose displacement function is u = G r about its centroid (translation apart):
/// exact rotation after the linear solve [Ding2021, section 2.3.1], three-dimensional,
///
///     w = axial(G), e = sym(G), R = exp [w]x:   F <- (R + e) F,   s <- R s R^T + C e,   e' <- R e' R^T.
///
/// The spin of the velocity gradient is set so that the angular momentum about the centroid stays what it was with the
/// old second moments: the term w x I w, which the linear displacement function leaves out, comes back in. At zero
/// strain the volume stays to round-off, where the linear map would grow it by w^2 a step.
void update_block(const BlockSystem& system, std::int32_t block, const Mat3& gradient, BlockState& state);

/// Velocity gradient with given strain rate and angular momentum about the centroid: spin = I^-1 (h - 2 axial(e' S)),
/// I = tr(S) 1 - S.
Mat3 gradient_with_momentum(const Mat3& inertia, const Mat3& strain_rate, const Vec3& momentum);

/// Strain of a stress: the inverse of elastic_stress.
Mat3 elastic_strain(const Elasticity& material, const Mat3& stress);

}  // namespace riprap::solid::affine
