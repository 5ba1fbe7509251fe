// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace riprap::python {

/// A step was refused for good; becomes riprap.NumericalError.
class NumericalError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// From here on the exceptions of core/error.hpp and the one above leave the module as those of riprap/errors.py.
void register_errors();

}  // namespace riprap::python
