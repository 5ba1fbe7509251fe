// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace riprap::view {

/// The page without a run, as built from page/ and carried by the program; empty when it was built without Node.
std::string_view page_template();

}  // namespace riprap::view
