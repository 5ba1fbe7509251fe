// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/run/figures/expects.hpp"

namespace riprap::run {

/// Judges the expected answers of a case in a world in which nothing moves: bodies and water stay where the case puts
/// them, nothing settles, and no force is known. An answer that passes there says nothing by itself about a method.
/// @param given  State that the case begins with, as scene::LoadedCase holds it
std::vector<ExpectResult> answers_of_still_world(const sim::Model& model, const sim::State& given);

}  // namespace riprap::run
