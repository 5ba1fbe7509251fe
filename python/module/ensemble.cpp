// SPDX-License-Identifier: Apache-2.0
// Gives riprap.ensemble what it needs of the engine: the values that members draw, and their bands.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "case.hpp"
#include "riprap/run/ensemble/bands.hpp"
#include "riprap/run/figures/spreads.hpp"
#include "riprap/view/sweep_page.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

/// Seed of the case, and for each member its values by the keys of the case.
py::tuple draws(const Case& self, std::int64_t members) {
    const std::vector<run::Spread> spreads = run::spreads_of(self.loaded);
    if (spreads.empty()) {
        throw py::value_error("an ensemble needs numbers that differ from member to member: [[spread]] in the case");
    }
    const py::dict resolved = from_json(self.loaded.resolved_json);
    const auto seed = resolved.contains("seed") ? resolved["seed"].cast<std::uint64_t>() : std::uint64_t{1};
    py::list points;
    for (std::int64_t k = 1; k <= members; ++k) {
        py::dict values;
        for (const run::Spread& spread : spreads) {
            values[py::str(spread.key)] = run::draw(spread, seed, k);
        }
        points.append(values);
    }
    return py::make_tuple(seed, points);
}

/// bands.csv and the page of members. @returns why members are left out of the bands
std::vector<std::string> write_ensemble(const std::filesystem::path& out,
                                        const std::vector<std::filesystem::path>& members) {
    const py::gil_scoped_release unlocked;
    const run::Bands bands = run::gather_bands(members);
    run::write_bands(out / "bands.csv", bands);
    view::write_ensemble_page(out);
    return bands.left_out;
}

}  // namespace

void define_ensemble(py::module_& module) {
    using namespace py::literals;
    module.def("_draws", &draws, "case"_a, "members"_a);
    module.def("_write_ensemble", &write_ensemble, "out"_a, "members"_a);
}

}  // namespace riprap::python
