// SPDX-License-Identifier: Apache-2.0
#pragma once

// An exact answer may depend neither on the step nor on the stiffness of a solid method, within reason.

#include <string>
#include <vector>

#include "riprap/scene/assemble/variations.hpp"
#include "riprap/sim/settings.hpp"

namespace riprap::run {

/// Returns the runs with the step and the contact stiffness of a solid method times 1/4 and 4. The step is the method's
/// own key `step`, or time_step_factor; the stiffness its key `contact_stiffness`, else `youngs_modulus`, and the
/// normal_stiffness of materials where it reads that.
/// @param resolved_toml  the case with this method, every key with its value
/// @param settings       of the method in that case: the step and the stiffness that the case leaves to its blocks
std::vector<scene::Variation> method_scales(const std::string& resolved_toml, const std::string& solid,
                                            const sim::SolidSettings& settings);

}  // namespace riprap::run
