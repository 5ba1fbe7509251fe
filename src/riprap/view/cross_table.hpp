// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace riprap::view {

/// Scenes that were run with every method (validation/cross) as tables of a page: methods across, scenes down, each
/// cell with the answer, what it missed and its cause to be seen under the pointer.
/// @param cells  the "cells" of `riprap validate --json`
std::string cross_table(const nlohmann::json& cells);

}  // namespace riprap::view
