// SPDX-License-Identifier: Apache-2.0
// Water that leaves through the open top of the domain.
#include <fmt/format.h>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/fluid/open/leaving.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::GridState;
using fluid::grid::WaterBooks;

/// Share of all water below which what was let go is round-off of the transport [-].
constexpr double round_off = 1e-9;

/// Names the side that is open for air alone: "top of the domain, the high side of y".
std::string name_of_top(const GridFluidSettings& settings) {
    for (std::size_t side = 0; side < settings.grid.side.size(); ++side) {
        if (settings.grid.side[side].is_for_air) {
            return fmt::format("top of the domain, the {} side of {}", side % 2 == 0 ? "low" : "high", "xyz"[side / 2]);
        }
    }
    return "top of the domain";
}

/// Ends a run by the end of which more than a splash has left through the open top.
Outcome splash_outcome(const GridFluidSettings& settings, const WaterBooks& books, double time) {
    if (!(books.let_go > fluid::share_let_go * books.ever)) {
        return {};
    }
    return {fmt::format("{} of water have left through the {}, by t = {:.6g} s; allowed: {}, {:g} % of all",
                        mass_of(settings, books.let_go), name_of_top(settings), time,
                        mass_of(settings, fluid::share_let_go * books.ever), 100 * fluid::share_let_go),
            0, "a higher domain holds it; an [[fluid.outflow]] over the whole top lets it go"};
}

}  // namespace

std::string mass_of(const GridFluidSettings& settings, double volume) {
    const char* const unit = settings.scene.domain.dimension == 2 ? "kg/m" : "kg";
    return fmt::format("{:.3g} {}", settings.rest_density * volume, unit);
}

Outcome GridFluid::end(const TimeSpan& span, FluidStep& /*report*/) {
    const GridState& water = fields_->water;
    Outcome outcome = splash_outcome(*settings_, water.water, span.end());
    if (outcome.ok()) {
        outcome = pocket_outcome(*scene_, *settings_, *scratch_, water, span);
    }
    return outcome.ok() ? mass_outcome(*scene_, *settings_, *scratch_, water, span.end()) : outcome;
}

std::string GridFluid::let_go_text(const Settings& settings, const Fields& fields) {
    const WaterBooks& books = fields.water.water;
    if (!(books.let_go > round_off * books.ever)) {
        return "";
    }
    return fmt::format("{} of water, {:.3g} % of it, left through the {}, and was let go: a higher domain keeps it",
                       mass_of(settings, books.let_go), 100 * books.let_go / books.ever, name_of_top(settings));
}

}  // namespace riprap::coupling
