// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/step_context.hpp"

#include <limits>

#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::sim {

StepContext begin_step(const Model& model, State& state, ScratchData& scratch, BoundMethods& bound, double dt,
                       Measure measure, const body::LoadView& loads) {
    const StepLimit of_solids = bound.solid_limit();
    StepLimit of_fluid;
    if (bound.fluid_leads() && (of_solids.is_wanted || !model.time.is_automatic())) {
        of_fluid = bound.fluid().limit();
    }
    Cycle cycle = make_cycle(model, state, of_solids, of_fluid, bound.fluid_leads(), dt);
    cycle.spans = model.has_fluid() ? cycle.spans : 0;
    StepReport report;
    report.dt = dt;
    report.dt_bound = std::numeric_limits<double>::infinity();
    report.substeps = cycle.pieces;
    if (model.has_fluid() && !model.time.is_automatic()) {
        report.fluid_dt_bound = of_fluid.longest;
    }
    return {model,
            state,
            scratch,
            bound.solid(),
            bound.fluid(),
            bound.fluid_leads(),
            measure,
            accounts_of(model),
            cycle,
            std::move(of_fluid),
            loads,
            {},
            std::move(report)};
}

}  // namespace riprap::sim
