// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "riprap/validation/ding/breakwater.hpp"

namespace riprap::validation::ding {

using namespace grid;

void layer_thickness(const CaseSetting& setting, CaseReport& report) {
    const double h = setting.is_full ? 0.4 : 1.0;
    std::array<double, 4> energy{};
    for (std::size_t i = 0; i < 4; ++i) {
        GridTrial trial = make_breakwater({h, h * 0.625, 2, static_cast<double>(i)});
        trial.run(24);
        const Mesh& mesh = trial.settings().mesh;
        energy[i] = reduce_cells(
            mesh.box, 0.0,
            [&](std::int64_t c, int, int, int) {
                return trial.state().turbulent_energy[at(c)] * trial.state().fraction[at(c)] *
                       trial.scratch().room.capacity[at(c)];
            },
            sum_of);
        report.state(
            {fmt::format("turbulent energy of the water at 24 s over its density, layer of {} m", i), "m^4/s^2"},
            energy[i]);
    }
    for (std::size_t i = 0; i + 1 < 4; ++i) {
        report.judge_below({fmt::format("turbulent energy with {} m over that with {} m", i + 1, i), "-", {}, 1.0, {}},
                           energy[i + 1] / energy[i], 1.0);
    }
}

}  // namespace riprap::validation::ding
