// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace riprap::coupling {

/// Particles that went through bodies in a step.
struct WallPassages {
    std::int64_t count{0};
    std::int32_t body{-1};  ///< the one that the last of them went through

    void add(const WallPassages& more) {
        count += more.count;
        body = more.count > 0 ? more.body : body;
    }
};

}  // namespace riprap::coupling
