// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/mikola/water_run.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/validation/side_view.hpp"

namespace riprap::validation::mikola {

namespace {

/// Pair forces are summed in float: each sum over neighbours is off by up to 2^-24 of its terms, which are as much
/// larger than the weight of a particle as the water has spacings of depth: 25 here [-].
constexpr double float_sums = 25.0 / (1 << 24);

/// Residual of the momentum ledgers, over what gravity and walls have passed through the water so far: its
/// weight times the time.
double momentum_share(const Trial& trial, const sim::Ledger& ledger) {
    const double passed = ledger.fluid.mass * norm(trial.model().gravity.value) * trial.time();
    return (norm(ledger.momentum_residual) + norm(ledger.fluid.momentum_residual)) / passed;
}

void take_row(const Trial& trial, WaterRecords& records) {
    const sim::Model& model = trial.model();
    const auto& gauges = model.output.gauges;
    records.gauge.resize(gauges.size());
    records.time.push_back(trial.time());
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        records.gauge[i].push_back(fluid::read_gauge(gauges[i], model.particles()->settings(), trial.state().fluid)[0]);
    }
    const sim::Ledger& ledger = trial.report().ledger;
    if (ledger.has_energy) {
        records.energy_residual = std::max(records.energy_residual, std::abs(ledger.residual));
        records.energy_turnover = ledger.turnover;
    }
    records.momentum_residual = std::max(records.momentum_residual, momentum_share(trial, ledger));
}

}  // namespace

void run_water(Trial& trial, WaterRecords& records, double time, double interval,
               const std::function<void(const Trial&)>& look) {
    double next = trial.time();
    while (trial.time() < time - 0.5 * trial.dt()) {
        const bool is_row = trial.time() + trial.dt() >= next;
        trial.follow_energy(is_row);
        trial.step();
        if (is_row) {
            next += interval;
            take_row(trial, records);
            if (look) {
                look(trial);
            }
        }
    }
}

int count_inside_solids(const Trial& trial, double depth) {
    const sim::Model& model = trial.model();
    const auto is_inside = [&](const body::Part& part, const Vec3& x) {
        const auto b = static_cast<std::size_t>(part.body.value);
        if (b < model.particles()->is_dry.size() && model.particles()->is_dry[b] != 0) {
            return false;  // water passes through it
        }
        const Vec3 in_body = to_body({trial.state().bodies.position[b], trial.state().bodies.orientation[b]}, x);
        const Vec3 in_part = to_body(part.local, in_body);
        const geometry::ConvexView shape = model.shapes.view(part.shape);
        for (std::int32_t f = 0; f < shape.face_count; ++f) {
            const bool is_end_of_slab = std::abs(shape.normal(f).z) > 0.5;  // the scene is planar
            const auto face = static_cast<std::size_t>(f);
            if (!is_end_of_slab && dot(shape.normal(f), in_part) - shape.offset[face] > -depth) {
                return false;
            }
        }
        return true;
    };
    int count = 0;
    for (const Vec3& x : trial.state().fluid.position) {
        count += std::any_of(model.bodies.parts.begin(), model.bodies.parts.end(),
                             [&](const body::Part& part) { return is_inside(part, x); })
                     ? 1
                     : 0;
    }
    return count;
}

void judge_ledgers(CaseReport& report, const std::string& run, const WaterRecords& records) {
    report.judge_below(
        {run + ": most energy at a time that the ledger cannot account for, over all that was turned over",
         "-",
         {},
         {},
         {},
         Kind::bookkeeping},
        records.energy_residual / records.energy_turnover, 0.01);
    report.judge_below({run + ": momentum that the ledgers cannot account for, over weight of water times time",
                        "-",
                        {},
                        {},
                        {},
                        Kind::bookkeeping},
                       records.momentum_residual, float_sums);
}

Plot water_view(const Trial& trial, const std::string& title, int count) {
    Plot plot = side_view_plot(trial.model(), trial.state(), {{1, 0, 0}, {0, 1, 0}}, title);
    const auto& position = trial.state().fluid.position;
    const std::size_t stride = 1 + position.size() / static_cast<std::size_t>(count);
    Curve water{"water", {}, {}, CurveStyle::points, 1};
    for (std::size_t i = 0; i < position.size(); i += stride) {
        water.x.push_back(position[i].x);
        water.y.push_back(position[i].y);
    }
    plot.curves.push_back(std::move(water));
    return plot;
}

}  // namespace riprap::validation::mikola
