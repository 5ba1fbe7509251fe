// SPDX-License-Identifier: Apache-2.0
#pragma once

// Keys of a study: for the sources that read its words and lists.

#include <string>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::run {

/// @throws CaseError
[[noreturn]] void refuse_study(const SourcePlace& place, std::string message, std::string allowed);

/// The one of `keys` that gives the value of `key`, in the same or another unit ("end", "end_ms"); empty where none
/// does.
std::string same_of(const std::string& key, const std::vector<std::string>& keys);

/// Says that two columns or words of a study give one value.
std::string stands_twice(const std::string& key, const std::string& other);

}  // namespace riprap::run
