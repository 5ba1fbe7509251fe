// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap::run {

/// XXH3 of bytes, 64 bits, as 16 hexadecimal digits.
std::string file_hash(std::string_view bytes);

}  // namespace riprap::run
