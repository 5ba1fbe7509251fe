// SPDX-License-Identifier: Apache-2.0
// riprap.waves: what `riprap waves` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "riprap/view/bad_request.hpp"
#include "riprap/view/wave_report.hpp"
#include "simulation.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

py::object waves(const std::filesystem::path& folder, std::vector<std::string> gauges, std::optional<double> start,
                 std::optional<double> end, std::optional<double> period, std::optional<double> depth) {
    if ((period && !(*period > 0)) || (depth && !(*depth > 0))) {
        throw py::value_error("period and depth are above 0");
    }
    try {
        return from_json(view::wave_json(
            view::analyse_waves(view::read_run(folder), {std::move(gauges), start, end, period, depth})));
    } catch (const view::BadRequest& problem) {
        throw py::value_error(problem.what());
    }
}

constexpr const char* waves_help =
    R"(Waves that the gauges of a run recorded, as `riprap waves --json` gives them (dict).

folder      the run folder
gauges      of kind level or surface; none: all
start, end  stretch of the record [s]; default: its second half
period      of a regular wave to take into incident and reflected one [s]; default: that of the wave maker
depth       of still water [m]; default: that of the wave maker

Raises ValueError for a gauge or a stretch that is not there.)";

}  // namespace

void define_waves(py::module_& module) {
    using namespace py::literals;
    module.def("waves", &waves, waves_help, "folder"_a, "gauges"_a = std::vector<std::string>{}, py::kw_only(),
               "start"_a = py::none(), "end"_a = py::none(), "period"_a = py::none(), "depth"_a = py::none());
}

}  // namespace riprap::python
