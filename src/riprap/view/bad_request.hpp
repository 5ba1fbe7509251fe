// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace riprap::view {

/// A request that cannot be answered from the run: a bad command line.
class BadRequest : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace riprap::view
