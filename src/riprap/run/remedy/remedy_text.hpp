// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/core/ids.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::run {

/// "key = value" with two digits, rounded up: what a remedy names can be copied into `--set key=value`.
std::string assignment(std::string_view key, double value);
std::string assignment(std::string_view key, std::string_view word);

/// The same rounded down, for steps and shares that have to be smaller.
std::string assignment_below(std::string_view key, double value);

/// Names the stiffness of the contact of two bodies in the case's method, times a factor.
/// @param is_of_faces  they meet by faces, not by spheres
std::string stiffness_text(const sim::Model& model, BodyId a, BodyId b, bool is_of_faces, double factor);

}  // namespace riprap::run
