// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/scene/case/case_build.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

/// Reads the expected answers; after probes, gauges and damage, whose columns they may name.
void build_expects(CaseBuild& build, const Value& list);

/// Adds a problem where the case has no such quantity: the methods lack it, or there is no water; tells whether it did.
/// `name` is what the case calls it.
bool refuses_quantity(CaseBuild& build, const sim::QuantityInfo& quantity, const std::string& name,
                      const SourcePlace& place);

}  // namespace riprap::scene
