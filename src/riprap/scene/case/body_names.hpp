// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/body/body_set.hpp"

namespace riprap::scene {

/// Text for a name that no body has.
struct NameAnswer {
    std::string message;  ///< "there is no body 'blok'", "there are many bodies 'stone'"
    std::string allowed;  ///< the nearest name, or the numbers of many
};

/// Says what is wrong with `name`, which no body of the scene has: "stone" and "stone[9]" of three stones are told the
/// numbers that there are, others the nearest name.
NameAnswer answer_to_name(const body::BodySet& bodies, std::string_view name);

}  // namespace riprap::scene
