// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace riprap {

/// One number per body that a solid method has beyond poses and velocities: a quantity of probes and expected answers,
/// an array of frames, a colour on the page.
struct ShownField {
    std::string_view name;  ///< "stress_xx"
    std::string_view unit;  ///< "Pa"
    std::string_view help;  ///< follows the name in the manual: "of the Cauchy stress, tension positive"
};

}  // namespace riprap
