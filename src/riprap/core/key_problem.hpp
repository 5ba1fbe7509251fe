// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap {

/// A combination of values that a method refuses. Its place in the case is that of the key.
struct KeyProblem {
    std::string_view key;
    std::string message;
    std::string allowed;
};

}  // namespace riprap
