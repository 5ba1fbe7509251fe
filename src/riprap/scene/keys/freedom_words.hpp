// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

/// Degrees of freedom with the bits of body::Locks that they stand for.
inline const Words<std::uint8_t>& freedoms() {
    static const Words<std::uint8_t> words{{"x", 0x01},          {"y", 0x02},          {"z", 0x04},
                                           {"rotation_x", 0x08}, {"rotation_y", 0x10}, {"rotation_z", 0x20},
                                           {"rotation", 0x38}};
    return words;
}

}  // namespace riprap::scene
