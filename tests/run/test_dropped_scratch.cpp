// SPDX-License-Identifier: Apache-2.0
// Scratch is kept for speed only. Every shipped case and a case of every method is run with all of it dropped before
// steps chosen at random; what is listed in it must not depend on when it was listed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>

#include "riprap/core/parallel.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
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
void PrintTo(const ShippedCase& shipped, std::ostream* out) { *out << shipped.name; }

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

std::string path_of(const ShippedCase& shipped) { return fmt::format("cases/{}/case.toml", shipped.name); }

/// A case of one method, see test_method_keys.cpp; solids have a body that is let go on the way.
struct MethodCase {
    const char* name;
    std::vector<std::string> overrides;
    std::int64_t steps;
};
void PrintTo(const MethodCase& method, std::ostream* out) { *out << method.name; }

std::vector<MethodCase> method_cases() {
    const std::vector<std::string> release{"body.lone.fixed=true", "body.lone.release_time=0.004",
                                           "body.lone.velocity=[0,0,0]", "body.lone.angular_velocity=[0,0,0]"};
    const std::vector<std::string> planar{"body.lone.fixed=true", "body.lone.release_time=0.004",
                                          "body.lone.angular_velocity=0"};
    return {{"solid-distance_potential_dem", release, 60},
            {"solid-sphere_dem", release, 60},
            {"solid-planar_dda", planar, 30},
            {"solid-implicit_dda", release, 30},
            {"solid-explicit_dda", release, 60},
            {"fluid-sph", {}, 30},
            {"fluid-wcmps", {}, 30},
            {"fluid-mps", {}, 12},
            {"fluid-grid", {}, 12},
            {"fluid-hydrostatic", {}, 30}};
}

std::string path_of(const MethodCase& method) { return fmt::format("tests/run/methods/{}.toml", method.name); }

/// Hash of the State after every step.
/// @param is_dropped  asked before every step with its number: whether Scratch is dropped there
template <class IsDropped>
std::vector<std::uint64_t> walk(const std::string& path, const std::vector<std::string>& overrides, std::int64_t steps,
                                const IsDropped& is_dropped) {
    scene::LoadedCase loaded = scene::read_case(path, overrides);
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

/// Compares a run with others in which Scratch is dropped now and then.
void drop_and_compare(const std::string& path, const std::vector<std::string>& overrides, std::int64_t steps) {
    parallel::set_thread_count(1);
    const std::vector<std::uint64_t> straight = walk(path, overrides, steps, [](std::int64_t) { return false; });
    parallel::set_thread_count(2);
    for (const std::uint64_t seed : {3, 11}) {
        // Seldom enough that lists grow old in between, and often enough that some are made anew between two listings.
        const auto is_dropped = [seed](std::int64_t step) {
            return geometry::unit_interval(geometry::mix_bits(seed, static_cast<std::uint64_t>(step))) < 0.25;
        };
        EXPECT_EQ(first_difference(straight, walk(path, overrides, steps, is_dropped)), -1) << "seed " << seed;
    }
    parallel::set_thread_count(1);
}

class DroppedScratch : public ::testing::TestWithParam<ShippedCase> {
 protected:
    ~DroppedScratch() override { parallel::set_thread_count(1); }
};

TEST_P(DroppedScratch, LeavesEveryBitOfTheStateAsItWas) {
    const ShippedCase& shipped = GetParam();
    const std::int64_t steps = is_full() ? 5 * shipped.steps : shipped.steps;
    drop_and_compare(path_of(shipped), is_full() ? std::vector<std::string>{} : shipped.coarser, steps);
}

INSTANTIATE_TEST_SUITE_P(Cases, DroppedScratch, testing::ValuesIn(shipped_cases()),
                         [](const auto& instance) { return std::string(instance.param.name); });

class DroppedScratchOfMethod : public ::testing::TestWithParam<MethodCase> {
 protected:
    ~DroppedScratchOfMethod() override { parallel::set_thread_count(1); }
};

TEST_P(DroppedScratchOfMethod, leaves_every_bit_of_the_state_as_it_was) {
    drop_and_compare(path_of(GetParam()), GetParam().overrides, GetParam().steps);
}

std::string word_of(const MethodCase& method) {
    std::string word = method.name;
    word[word.find('-')] = '_';
    return word;
}
INSTANTIATE_TEST_SUITE_P(Methods, DroppedScratchOfMethod, testing::ValuesIn(method_cases()),
                         [](const auto& instance) { return word_of(instance.param); });

TEST(MethodCases, are_all_run_with_dropped_scratch) {
    std::set<std::string> tried, there;
    for (const MethodCase& one : method_cases()) {
        tried.insert(one.name);
    }
    for (const auto& entry : std::filesystem::directory_iterator("tests/run/methods")) {
        there.insert(entry.path().stem());
    }
    EXPECT_EQ(tried, there);
}

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
