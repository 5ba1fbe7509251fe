// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "made_caster.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::python {

/// A case as Python holds it: read and checked, not changed any more.
struct Case {
    scene::LoadedCase loaded;
    std::vector<std::string> overrides;
    std::string name;  ///< that a run folder is called after
};

void define_case(pybind11::module_& module);
void define_ensemble(pybind11::module_& module);

}  // namespace riprap::python

template <>
struct pybind11::detail::type_caster<riprap::python::Case> : riprap::python::MadeCaster<riprap::python::Case> {};
