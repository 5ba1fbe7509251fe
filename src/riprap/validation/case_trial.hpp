// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "riprap/validation/registry.hpp"
#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation {

/// The scene of a case's own case.toml, ready to step: the same file that `riprap run` takes.
/// @param overrides  as for scene::read_case: "path.to.key=value"
Trial trial_of(const CaseSetting& setting, std::span<const std::string> overrides = {});

}  // namespace riprap::validation
