// SPDX-License-Identifier: Apache-2.0
// Cases: from a file, from a text, from a dict; always through the one reader and its checks.
#include "case.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>

#include "riprap/run/check/check_case.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

Case load(const std::filesystem::path& path, const py::object& overrides) {
    std::vector<std::string> assignments = to_overrides(overrides);
    const py::gil_scoped_release unlocked;
    const std::filesystem::path file = run::find_case(path.string());
    scene::LoadedCase loaded = scene::read_case(file.string(), assignments);
    return {std::move(loaded), std::move(assignments), run::short_name(file)};
}

Case loads_utf8(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                const py::object& overrides) {
    std::vector<std::string> assignments = to_overrides(overrides);
    const py::gil_scoped_release unlocked;
    scene::LoadedCase loaded = scene::read_case_text(text, name, folder.string(), assignments);
    return {std::move(loaded), std::move(assignments), "case"};
}

Case loads(const py::str& text, const py::str& name, const std::filesystem::path& folder, const py::object& overrides) {
    return loads_utf8(utf8_of(text, "the text of the case"), utf8_of(name, "name"), folder, overrides);
}

Case build(const py::dict& keys, const py::str& name, const std::filesystem::path& folder,
           const py::object& overrides) {
    return loads_utf8(scene::write_toml(to_value(keys)), utf8_of(name, "name"), folder, overrides);
}

std::vector<std::string> body_names(const Case& self) {
    std::vector<std::string> names;
    for (std::int32_t i = 0; i < self.loaded.model.bodies.size(); ++i) {
        names.push_back(self.loaded.model.bodies.name(BodyId{i}));
    }
    return names;
}

py::object check(const Case& self) {
    std::string text;
    {
        const py::gil_scoped_release unlocked;
        text = run::check_json(run::check_case(self.loaded));
    }
    return from_json(text);
}

constexpr const char* load_help = R"(Reads and checks a case file.

path       a case file, a folder with a case.toml, or a name from riprap.list()
overrides  {"end": 2.0, "solid.skin": 0.2} or ["end=2.0"]: keys that replace those of the file

Raises CaseError with every problem, each with its file, line and column; FileError where there is no such file.)";

constexpr const char* loads_help = R"(Reads and checks a case from a TOML text; paths in it start at `folder`.)";

constexpr const char* build_help = R"(Reads and checks a case from a dict with the keys of a case file.

Values are numbers in SI or texts with a unit ("2.5 cm"), lists, dicts, NumPy numbers and arrays. The dict is written as
TOML (Case.text) and read by the same reader: problems name lines of that text. Paths in it start at `folder`.)";

}  // namespace

void define_case(py::module_& module) {
    using namespace py::literals;
    py::class_<Case>(module, "Case", "A case that was read and checked, ready to run. Made by load, loads and build.")
        .def_property_readonly(
            "title", [](const Case& self) { return self.loaded.model.title; },
            "One line that says what the case shows.")
        .def_property_readonly(
            "folder", [](const Case& self) { return self.loaded.folder; }, "Where the paths in the case start.")
        .def_property_readonly(
            "text", [](const Case& self) { return self.loaded.source_text; }, "The case file as it was read.")
        .def_property_readonly(
            "overrides", [](const Case& self) { return self.overrides; },
            "What replaced keys of the text (list of str).")
        .def_property_readonly(
            "resolved", [](const Case& self) { return from_json(self.loaded.resolved_json); },
            "Every key with its value in SI, defaults and overrides included (dict).")
        .def_property_readonly(
            "warnings", [](const Case& self) { return self.loaded.warnings; }, "Worth knowing, no reason to stop.")
        .def_property_readonly("body_names", &body_names, "Names of all bodies, in the order of their numbers.")
        .def_property_readonly(
            "end", [](const Case& self) { return self.loaded.model.time.end; }, "When a run of it ends [s].")
        .def("check", &check,
             "What `riprap check --json` says: bodies, masses, time step, steps, memory, output (dict). Tries one step "
             "on a copy; where that is refused, `refusal` says why.")
        .def("__repr__", [](const Case& self) {
            return "<riprap.Case '" + self.loaded.model.title + "', " +
                   std::to_string(self.loaded.model.bodies.size()) + " bodies>";
        });
    module.def(
        "list",
        [] {
            std::vector<std::string> names;
            for (const run::KnownCase& known : run::known_cases("cases")) {
                names.push_back(known.name);
            }
            return names;
        },
        "Names of the cases that load() finds: those of `cases/` in the working folder and the examples that came with "
        "the package.");
    module.def("_add_case_root", &run::add_case_root, "folder"_a);
    module.def("load", &load, load_help, "path"_a, "overrides"_a = py::none());
    module.def("loads", &loads, loads_help, "text"_a, "name"_a = "case.toml", "folder"_a = ".",
               "overrides"_a = py::none());
    module.def("build", &build, build_help, "keys"_a, "name"_a = "case.toml", "folder"_a = ".",
               "overrides"_a = py::none());
}

}  // namespace riprap::python
