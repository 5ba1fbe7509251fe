// SPDX-License-Identifier: Apache-2.0
// Water that leaves through the open top of the domain.
#include <fmt/format.h>

#include "riprap/coupling/grid_fluid/grid_fluid.hpp"
#include "riprap/fluid/open/leaving.hpp"

namespace riprap::coupling {

namespace {

using fluid::grid::WaterBooks;

/// Share of all water below which what was let go is round-off of the transport [-].
constexpr double round_off = 1e-9;

std::string mass_of(const GridFluidSettings& settings, double volume) {
    const char* const unit = settings.scene.domain.dimension == 2 ? "kg/m" : "kg";
    return fmt::format("{:.3g} {}", settings.rest_density * volume, unit);
}

/// Names the side that is open for air alone: "top of the domain, the high side of y".
std::string name_of_top(const GridFluidSettings& settings) {
    for (std::size_t side = 0; side < settings.grid.side.size(); ++side) {
        if (settings.grid.side[side].is_for_air) {
            return fmt::format("top of the domain, the {} side of {}", side % 2 == 0 ? "low" : "high", "xyz"[side / 2]);
        }
    }
    return "top of the domain";
}

}  // namespace

Outcome GridFluid::end(const TimeSpan& span, FluidStep& /*report*/) {
    const WaterBooks& books = fields_->water.water;
    if (!(books.let_go > fluid::share_let_go * books.ever)) {
        return {};
    }
    return {fmt::format("{} of water have left through the {}, by t = {:.6g} s; allowed: {}, {:g} % of all",
                        mass_of(*settings_, books.let_go), name_of_top(*settings_), span.end(),
                        mass_of(*settings_, fluid::share_let_go * books.ever), 100 * fluid::share_let_go),
            0, "a higher domain holds it; an [[fluid.outflow]] over the whole top lets it go"};
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
