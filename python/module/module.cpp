// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>

#include "case.hpp"
#include "errors.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/run/provenance.hpp"
#include "riprap/run/run_case.hpp"
#include "simulation.hpp"
#include "values.hpp"

namespace py = pybind11;

namespace {

void set_threads(int count) {
    constexpr int most = 1024;
    if (count < 1 || count > most) {
        throw py::value_error("threads: 1 to 1024");
    }
    riprap::parallel::set_thread_count(count);
}

}  // namespace

PYBIND11_MODULE(_riprap, module) {
    using namespace py::literals;
    riprap::python::register_errors();
    riprap::python::define_case(module);
    riprap::python::define_simulation(module);
    riprap::python::define_run(module);
    riprap::python::define_waves(module);
    module.def("set_threads", &set_threads, "Threads that steps use from now on. No result depends on it.", "count"_a);
    module.def("threads", &riprap::parallel::thread_count, "Threads that steps use; at first all of the machine.");
    module.def(
        "build_info", [] { return riprap::python::from_json(riprap::run::build_json()); },
        "How the library was built (dict).");
    module.attr("__version__") = riprap::run::build_info().version;
    riprap::run::use_threads(0);
}
