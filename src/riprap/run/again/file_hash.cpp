// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/again/file_hash.hpp"

#define XXH_INLINE_ALL
// SSE2: in those of AVX-512 GCC 12 warns of numbers that are not set
#define XXH_VECTOR 1
#include <fmt/format.h>
#include <xxhash.h>

namespace riprap::run {

std::string file_hash(std::string_view bytes) {
    return fmt::format("{:016x}", XXH3_64bits(bytes.data(), bytes.size()));
}

}  // namespace riprap::run
