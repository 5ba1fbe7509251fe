// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Tells whether a point, in the frame of the body, lies in the body or on its surface.
/// @param tolerance  how far outside it may be, over the circumradius of a part [-]
bool is_in(const sim::Model& model, BodyId body, const Vec3& point, double tolerance = 1e-6);

/// Names the bodies that a point of the world lies in at the start: the blocks of a section have no other way to be
/// told apart. Empty: none.
std::string holders_of(const CaseBuild& build, const Vec3& x);

}  // namespace riprap::scene
