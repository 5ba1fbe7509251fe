// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include "case.hpp"
#include "errors.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/sweep_page.hpp"
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

/// The page of a run, as `riprap view` writes it.
void write_page(const std::filesystem::path& folder, const std::filesystem::path& out) {
    const py::gil_scoped_release unlocked;
    namespace view = riprap::view;
    riprap::io::write_file(out, view::page_of(view::pack_run(view::read_run(folder), view::default_budget)));
}

void write_study_page(const std::filesystem::path& folder) {
    const py::gil_scoped_release unlocked;
    riprap::view::write_sweep_page(folder);
}

}  // namespace

PYBIND11_MODULE(_riprap, module) {
    using namespace py::literals;
    riprap::python::register_errors();
    riprap::python::define_case(module);
    riprap::python::define_ensemble(module);
    riprap::python::define_simulation(module);
    riprap::python::define_run(module);
    riprap::python::define_waves(module);
    module.def("set_threads", &set_threads, "Threads that steps use from now on. No result depends on it.", "count"_a);
    module.def("threads", &riprap::parallel::thread_count, "Threads that steps use; at first all of the machine.");
    module.def(
        "build_info", [] { return riprap::python::from_json(riprap::run::build_json()); },
        "How the library was built (dict).");
    module.def("_write_page", &write_page, "folder"_a, "out"_a);
    module.def("_write_study_page", &write_study_page, "folder"_a);
    module.attr("__version__") = riprap::run::build_info().version;
    riprap::run::use_threads(0);
}
