// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::python {

/// A text of Python. @throws ValueError that names `path` where it has a lone surrogate, as names of files may
std::string utf8_of(const pybind11::handle& text, const std::string& path);

/// A Python dict as a table of a case: bool, int, float, str, lists and tuples, dicts with text keys, NumPy scalars and
/// arrays. @throws TypeError naming the key for anything else
scene::Value to_value(const pybind11::dict& keys);

/// {"solid.skin": 0.2, "time_step": "1 ms"} or ["solid.skin=0.2", ...] as the command line's --set takes them.
std::vector<std::string> to_overrides(const pybind11::object& overrides);

/// Returns a JSON text as dicts, lists and numbers.
pybind11::object from_json(const std::string& text);

}  // namespace riprap::python
