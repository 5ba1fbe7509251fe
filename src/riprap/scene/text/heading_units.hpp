// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "riprap/scene/text/units.hpp"

namespace riprap::scene {

/// Parses a unit as headings of tables write it, beyond what parse_unit() takes: "metres", "sec", "M", "m2/Hz", "m² s",
/// "m a.s.l.", and units that cases do not have: ft, in, yd, mi, lbf, kip, kgf, ... Empty where it is none.
std::optional<Unit> parse_heading_unit(std::string_view text);

}  // namespace riprap::scene
