// SPDX-License-Identifier: Apache-2.0
// The scheme of Mueller and others, kept for comparison: its energy does not close, so that `riprap run` ends a case of
// it early, but it carries water and what floats in it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/column_group.hpp"

namespace riprap::run {
namespace {

/// Means of quantities of a published case over its second half, by the scheme.
std::vector<double> means(const std::string& name, const std::vector<std::string>& quantities,
                          const std::vector<std::string>& overrides) {
    std::vector<std::string> all{"fluid.scheme=muller", "fluid.artificial_alpha=0.1"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    const scene::LoadedCase loaded = scene::read_case("validation/water/" + name + "/case.toml", all);
    const sim::Model& model = loaded.model;
    sim::State state = loaded.state;
    sim::initialise(model, state);
    const sim::State initial = state;
    sim::Scratch scratch;
    std::vector<sim::ColumnGroup> columns;
    for (const std::string& quantity : quantities) {
        columns.push_back(sim::find_columns(model, quantity).value());
    }
    std::vector<double> sums(columns.size(), 0);
    double span = 0;
    for (;;) {  // without the watch of a run, which the energy would end
        const sim::TimeStep next = sim::choose_time_step(model, state, scratch);
        if (next.steps_left == 0) {
            break;
        }
        const sim::StepReport report = sim::advance(model, state, scratch, next.dt, sim::Measure::flow);
        EXPECT_TRUE(report.status.ok()) << report.status.text;
        if (state.time > 0.5 * model.time.end) {
            for (std::size_t i = 0; i < columns.size(); ++i) {
                sums[i] += next.dt * evaluate(columns[i], {model, initial, state, &scratch, &report});
            }
            span += next.dt;
        }
    }
    for (double& sum : sums) {
        sum /= span;
    }
    return sums;
}

TEST(MullerScheme, PressesTheBottomOfATankWithTheWeightOfItsWater) {
    constexpr double weight = 1000 * 9.81 * 0.5 * 1.0;  // [N/m]
    EXPECT_NEAR(means("still_tank", {"bottom.fluid_force.y"}, {"end=2"})[0], -weight, 0.02 * weight);
}

TEST(MullerScheme, FloatsABoxAtHalfOfItsHeight) {
    constexpr double weight = 500 * 9.81 * 0.28 * 0.2;  // [N/m]
    constexpr double height = 0.4056;                   // of its centre, half of it in 0.3776 m^2 of water [m]
    const std::vector<double> found = means("floating_box", {"box.fluid_force.y", "box.position.y"}, {"end=3.8"});
    EXPECT_NEAR(found[0], weight, 0.02 * weight);
    EXPECT_NEAR(found[1], height, 0.02 * height);
}

}  // namespace
}  // namespace riprap::run
