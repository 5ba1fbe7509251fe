// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace riprap::view {

/// What was asked of a run cannot be answered from it: a bad command line.
class BadRequest : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace riprap::view
