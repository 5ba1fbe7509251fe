// SPDX-License-Identifier: Apache-2.0
// Scratch is kept for speed only. Every shipped case, dry and wet, is run with all of it dropped before steps chosen at
// random; what is listed in it must not depend on when it was listed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "riprap/core/parallel.hpp"
#include "riprap/geometry/random_bits.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {
namespace {

bool is_full() { return std::getenv("RIPRAP_FULL") != nullptr; }

struct ShippedCase {
    const char* name;
    std::vector<std::string> coarser;  ///< overrides of the short run, so that many steps cost little
    std::int64_t steps;                ///< of the short run; five times as many in the full one
};

std::vector<ShippedCase> shipped_cases() {
    return {{"arch", {}, 1500},
            {"armour_slope", {"fluid.spacing=0.02"}, 60},
            {"armour_unit", {}, 2000},
            {"breakwater", {"fluid.spacing=0.5"}, 6},
            {"breakwater_3d", {}, 3},
            {"dam_break", {}, 60},
            {"dam_break_floes", {"fluid.spacing=0.0125"}, 24},
            {"drum", {}, 1500},
            {"floating_box", {"fluid.spacing=0.02"}, 250},
            {"gravity_dam", {}, 12},
            {"hello_block", {}, 2000},
            {"ice_jam", {"fluid.spacing=0.04"}, 12},
            {"jointed_slope", {}, 800},
            {"overflow", {"fluid.spacing=0.03"}, 400},
            {"rock_slide", {"fluid.spacing=4.0"}, 6},
            {"sliding_block", {}, 200},
            {"slope_section", {}, 60},
            {"stack", {}, 2000},
            {"tilting_slope", {}, 2000},
            {"wave_flume", {"fluid.spacing=0.025"}, 60}};
}

/// Hash of the State after every step.
/// @param is_dropped  asked before every step with its number: whether Scratch is dropped there
template <class IsDropped>
std::vector<std::uint64_t> walk(const ShippedCase& shipped, std::int64_t steps, const IsDropped& is_dropped) {
    const std::vector<std::string> overrides = is_full() ? std::vector<std::string>{} : shipped.coarser;
    scene::LoadedCase loaded = scene::read_case(fmt::format("cases/{}/case.toml", shipped.name), overrides);
    sim::State& state = loaded.state;
    sim::initialise(loaded.model, state);
    sim::Scratch scratch;
    std::vector<std::uint64_t> hashes;
    while (state.step < steps) {
        if (is_dropped(state.step)) {
            scratch.forget();
        }
        const double dt = choose_time_step(loaded.model, state, scratch).dt;
        const sim::StepReport report = advance(loaded.model, state, scratch, dt, sim::Measure::flow);
        EXPECT_TRUE(report.status.ok()) << report.status.text;
        hashes.push_back(state_hash(state));
    }
    return hashes;
}

/// The first step after which hashes differ; -1 where all agree.
std::int64_t first_difference(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (i >= b.size() || a[i] != b[i]) {
            return static_cast<std::int64_t>(i) + 1;
        }
    }
    return -1;
}

class DroppedScratch : public ::testing::TestWithParam<ShippedCase> {
 protected:
    ~DroppedScratch() override { parallel::set_thread_count(1); }
};

TEST_P(DroppedScratch, LeavesEveryBitOfTheStateAsItWas) {
    const ShippedCase& shipped = GetParam();
    const std::int64_t steps = is_full() ? 5 * shipped.steps : shipped.steps;
    parallel::set_thread_count(1);
    const std::vector<std::uint64_t> straight = walk(shipped, steps, [](std::int64_t) { return false; });
    parallel::set_thread_count(2);
    for (const std::uint64_t seed : {3, 11}) {
        // Seldom enough that lists grow old in between, and often enough that some are made anew between two listings.
        const auto is_dropped = [seed](std::int64_t step) {
            return geometry::unit_interval(geometry::mix_bits(seed, static_cast<std::uint64_t>(step))) < 0.25;
        };
        EXPECT_EQ(first_difference(straight, walk(shipped, steps, is_dropped)), -1) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, DroppedScratch, testing::ValuesIn(shipped_cases()),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(ShippedCases, AreAllRunWithDroppedScratch) {
    std::set<std::string> tried, shipped;
    for (const ShippedCase& one : shipped_cases()) {
        tried.insert(one.name);
    }
    for (const auto& entry : std::filesystem::directory_iterator("cases")) {
        if (std::filesystem::exists(entry.path() / "case.toml")) {
            shipped.insert(entry.path().filename());
        }
    }
    EXPECT_EQ(tried, shipped);
}

}  // namespace
}  // namespace riprap::run
