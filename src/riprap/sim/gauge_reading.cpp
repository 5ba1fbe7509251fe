// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/gauge_reading.hpp"

#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/sim/method_scratch.hpp"

namespace riprap::sim {

namespace {

template <class Fields>
const Fields& fields_in(const FluidFields& fields) {
    if constexpr (std::is_same_v<Fields, NoFields>) {
        static const NoFields none;
        return none;
    } else {
        return std::get<Fields>(fields);
    }
}

}  // namespace

fluid::GaugeReading read_now(const Model& model, const State& state, const Scratch* scratch,
                             const fluid::Gauge& fixed) {
    const bool is_carried = fixed.carrier >= 0 && fixed.face < 0;
    const fluid::Gauge gauge = is_carried ? carried(fixed, state.bodies.position, state.bodies.orientation) : fixed;
    const coupling::FaceGauge* const face = gauge.face >= 0 ? &model.output.faces[at(gauge.face)] : nullptr;
    const coupling::FluidScene scene{model.shapes, model.bodies, model.gravity};
    return Fluids::visit(model.fluid, [&]<class Fluid>(const typename Fluid::Settings& settings) {
        if ((gauge.kind->needs & ~Fluid::traits.offers) != 0) {
            return fluid::GaugeReading{std::numeric_limits<double>::quiet_NaN()};
        }
        const auto* const own =
            scratch == nullptr ? nullptr : std::get_if<typename Fluid::Scratch>(&scratch->data().methods->fluid);
        return Fluid::read({gauge, face, scene, settings, state.fluid,
                            fields_in<typename Fluid::Fields>(state.fluid_fields), own, state.time});
    });
}

fluid::GaugeReading read_gauge(const Model& model, const State& state, const Scratch* scratch, std::size_t gauge) {
    const fluid::Gauge& one = model.output.gauges[gauge];
    const std::vector<double>& shown = state.gauges.shown;
    if (one.response == 0 || shown.empty()) {
        return read_now(model, state, scratch, one);
    }
    return {shown[3 * gauge], shown[3 * gauge + 1], shown[3 * gauge + 2]};
}

void follow(const Model& model, State& state, const Scratch& scratch, double dt) {
    const std::vector<fluid::Gauge>& gauges = model.output.gauges;
    std::vector<double>& shown = state.gauges.shown;
    const bool is_first = shown.empty();
    for (std::size_t g = 0; g < gauges.size(); ++g) {
        if (gauges[g].response == 0) {
            continue;
        }
        shown.resize(3 * gauges.size());
        const fluid::GaugeReading now = read_now(model, state, &scratch, gauges[g]);
        for (std::size_t c = 0; c < at(gauges[g].kind->components); ++c) {
            double& y = shown[3 * g + c];
            y = is_first ? now[c] : fluid::lagged(y, now[c], dt, gauges[g].response);
        }
    }
}

}  // namespace riprap::sim
