// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/scene/case/case_build.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

/// Reads the expected answers; after probes, gauges and damage, whose columns they may name.
void build_expects(CaseBuild& build, const Value& list);

/// Lists the quantities that the methods of the case have, of bodies, of the scene or of accounts as `quantity` is.
std::string other_names(const sim::Model& model, const sim::QuantityInfo& quantity);

}  // namespace riprap::scene
