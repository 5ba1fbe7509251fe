// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/affine/make_blocks.hpp"

namespace riprap::solid::affine {

/// Tells of a stiffness of contact points below the weight of a block over its radius: nothing would keep blocks from
/// sinking through each other.
std::vector<SceneProblem> softness_problems(const SolidScene& scene, const Elasticity& elasticity);

/// Tells of that, and of a stiffness of contact points above 1e6 times Young's modulus times the radius of the smallest
/// free body: the sum of both springs would then keep less than ten digits of the body's own.
std::vector<SceneProblem> stiffness_problems(const SolidScene& scene, const Elasticity& elasticity);

}  // namespace riprap::solid::affine
