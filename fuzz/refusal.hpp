// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "riprap/core/error.hpp"

namespace riprap {

/// Calls a reader. It may refuse the input with a CaseError that names at least one problem; anything else that it
/// throws ends the program.
template <class Read>
void read_or_refuse(const std::uint8_t* data, std::size_t size, const Read& read) {
    try {
        read(std::string_view(reinterpret_cast<const char*>(data), size));
    } catch (const CaseError& error) {
        if (error.problems().empty() || error.problems().front().message.empty()) {
            std::abort();
        }
    }
}

}  // namespace riprap
