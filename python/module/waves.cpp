// SPDX-License-Identifier: Apache-2.0
// riprap.waves: what `riprap waves` does.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "riprap/view/bad_request.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/wave_report.hpp"
#include "simulation.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

py::object waves(const std::filesystem::path& folder, std::vector<std::string> gauges, std::optional<double> start,
                 std::optional<double> end, std::optional<double> period, std::optional<double> depth,
                 std::optional<std::vector<double>> direction) {
    view::WaveRequest request{std::move(gauges), start, end, period, depth, {}};
    if (direction && (direction->size() < 2 || direction->size() > 3)) {
        throw py::value_error("direction: two or three numbers");
    }
    if (direction) {
        request.direction = Vec3{direction->at(0), direction->at(1), direction->size() > 2 ? direction->at(2) : 0};
    }
    const view::RecordedRun run = view::read_run(folder);
    for (const std::string& notice : run.notices) {
        if (PyErr_WarnEx(PyExc_RuntimeWarning, notice.c_str(), 1) != 0) {
            throw py::error_already_set();
        }
    }
    try {
        return from_json(view::wave_json(view::analyse_waves(run, request)));
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
direction   of the waves, two or three numbers; default: that of the wave maker, or +x

Raises ValueError for a gauge or a stretch that is not there. What could not be read is a RuntimeWarning.)";

}  // namespace

void define_waves(py::module_& module) {
    using namespace py::literals;
    module.def("waves", &waves, waves_help, "folder"_a, "gauges"_a = std::vector<std::string>{}, py::kw_only(),
               "start"_a = py::none(), "end"_a = py::none(), "period"_a = py::none(), "depth"_a = py::none(),
               "direction"_a = py::none());
}

}  // namespace riprap::python
