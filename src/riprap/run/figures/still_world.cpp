// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/figures/still_world.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "riprap/sim/advance.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {

namespace {

/// Returns times at which a world in which nothing moves is looked at: the ends of all windows and their middles.
std::set<double> times_of(const sim::Model& model) {
    const double end = model.time.end;
    std::set<double> times{0, end};
    for (const sim::Expect& expect : model.expects) {
        const double from = std::max(0.0, expect.from), to = std::min(end, expect.to);
        for (const double time : {from, 0.5 * (from + to), to, expect.at}) {
            if (time >= 0 && time <= end) {  // false for NaN
                times.insert(time);
            }
        }
    }
    return times;
}

}  // namespace

std::vector<ExpectResult> answers_of_still_world(const sim::Model& model, const sim::State& given) {
    ExpectWatch watch(model);
    sim::State initial = given;
    sim::initialise(model, initial);
    sim::State now = initial;
    for (const double time : times_of(model)) {
        now.time = time;
        watch.look({model, initial, now, nullptr, nullptr});
    }
    return watch.judge(true);
}

}  // namespace riprap::run
