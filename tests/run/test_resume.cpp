// SPDX-License-Identifier: Apache-2.0
// Wherever a run is stopped, and however often, it ends as the run that was never stopped: runs that go back and take
// steps again above all, for what they go back to, and when they look, is as much a part of them as their State.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

namespace fs = std::filesystem;

bool is_full() { return std::getenv("RIPRAP_FULL") != nullptr; }

/// What must not depend on where a run was stopped.
struct Ending {
    int code{0};
    std::string status, hash, expects, probes, ledger;
    std::int64_t steps{0}, retries{0};
    bool operator==(const Ending&) const = default;
};
void PrintTo(const Ending& ending, std::ostream* out) {
    *out << fmt::format("code {}, {}, {} after {} steps and {} retries", ending.code, ending.status, ending.hash,
                        ending.steps, ending.retries);
}

/// A scene of tests/run/resume, run whole and in pieces.
class Resume : public ::testing::TestWithParam<std::string> {
 protected:
    RunOptions options(const fs::path& out, std::vector<std::string> overrides = {}, int threads = 1) const {
        overrides.emplace_back("output.vtk=false");
        const fs::path scene = fs::path("tests/run/resume") / (GetParam() + ".toml");
        RunOptions options;
        options.case_path = scene.string();
        options.overrides = std::move(overrides);
        options.out = out;
        options.threads = threads;
        options.quiet = options.silent = true;
        return options;
    }
    static Ending ending_of(const fs::path& folder, int code) {
        const auto read = [&](const char* file) { return io::read_file(folder / file, 1U << 26U); };
        const auto summary = nlohmann::json::parse(read("summary.json"));
        return {code,
                summary.at("status"),
                summary.at("state_hash"),
                summary.at("expects").dump(),
                read("probes.csv"),
                read("ledger.csv"),
                summary.at("steps"),
                summary.at("retries")};
    }
    /// The whole run, and where it went back.
    Ending whole() {
        RunOptions all = options(place / "whole");
        std::int64_t last = -1;
        all.watch = [&](Simulation& simulation) {
            const std::int64_t step = simulation.state().step;
            if (step <= last) {
                turns_.insert(step);
            }
            last = step;
            return true;
        };
        const int code = run_case(all);
        return ending_of(place / "whole", code);
    }
    Ending resumed(const fs::path& folder, int threads) const {
        const int code = resume_run({folder, threads, {}, -1, true});
        return ending_of(folder, code);
    }
    /// Steps at which to stop: about where the run went back, and as many others as `others`.
    std::vector<std::int64_t> stops_of(const Ending& whole, int others) const {
        std::set<std::int64_t> stops;
        for (const std::int64_t turn : turns_) {
            for (const int offset : {-2, 0, 1, 5}) {
                stops.insert(turn + offset);
            }
        }
        std::mt19937 random(20261127);
        for (int i = 0; i < others; ++i) {
            stops.insert(std::uniform_int_distribution<std::int64_t>(1, whole.steps - 1)(random));
        }
        std::vector<std::int64_t> inside;
        std::copy_if(stops.begin(), stops.end(), std::back_inserter(inside),
                     [&](std::int64_t stop) { return stop >= 1 && stop < whole.steps; });
        return inside;
    }

    const TemporaryFolder place;
    std::set<std::int64_t> turns_;
};

TEST_P(Resume, EndsAsTheWholeRunAfterAnyStop) {
    const Ending run = whole();
    ASSERT_EQ(run.code, 0) << run.status;
    ASSERT_GE(run.retries, 1) << "the scene has nothing to say";
    int threads = 1;
    for (const std::int64_t stop : stops_of(run, is_full() ? 200 : 6)) {
        const fs::path folder = place / fmt::format("stop_{}", stop);
        threads = threads % 3 + 1;
        ASSERT_EQ(run_case(options(folder, {fmt::format("max_steps={}", stop)}, threads)), 0) << stop;
        EXPECT_EQ(resumed(folder, threads % 3 + 1), run) << "stopped after " << stop << " steps";
        fs::remove_all(folder);
    }
}

TEST_P(Resume, EndsAsTheWholeRunAfterAKillInAnyStep) {
    // A kill leaves what lies in the folder: it is copied while the run goes on.
    const Ending run = whole();
    const std::vector<std::int64_t> stops = stops_of(run, is_full() ? 200 : 4);
    RunOptions all = options(place / "watched", {"output.checkpoint_interval=0.005"});
    std::vector<std::pair<fs::path, std::int64_t>> killed;
    all.watch = [&](Simulation& simulation) {
        const std::int64_t step = simulation.state().step;
        if (std::find(stops.begin(), stops.end(), step) != stops.end()) {
            killed.emplace_back(place / fmt::format("killed_{}", killed.size()), step);
            fs::copy(place / "watched", killed.back().first, fs::copy_options::recursive);
        }
        return true;
    };
    EXPECT_EQ(run_case(all), run.code);
    EXPECT_EQ(ending_of(place / "watched", run.code), run);
    int threads = 1;
    for (const auto& [folder, step] : killed) {
        threads = threads % 3 + 1;
        if (threads == 2 && fs::exists(folder / "checkpoint" / "previous")) {
            fs::remove(folder / "checkpoint" / "latest");  // the older one is kept
        }
        EXPECT_EQ(resumed(folder, threads), run) << "killed in step " << step;
    }
}

TEST_P(Resume, EndsAsTheWholeRunAfterManyStops) {
    const Ending run = whole();
    std::mt19937 random(1);
    ASSERT_GE(run.steps, 8);
    for (int chain = 0; chain < (is_full() ? 60 : 2); ++chain) {
        const fs::path folder = place / fmt::format("chain_{}", chain);
        Ending now{-1, "", "", "", "", "", 0, 0};
        while (now.status != "finished" && now.status != "failed") {
            const std::int64_t steps = std::uniform_int_distribution<std::int64_t>(1, run.steps / 4)(random);
            const int threads = 1 + static_cast<int>(random() % 3);
            if (now.steps > 0 && random() % 2 == 0) {
                now = ending_of(folder, resume_run({folder, threads, {}, now.steps + steps, true}));
            } else {
                std::int64_t taken = 0;
                RunOptions next = options(folder, {}, threads);
                next.resume = true;
                next.watch = [&](Simulation&) { return ++taken < steps; };  // as a signal
                now = ending_of(folder, run_case(next));
            }
        }
        EXPECT_EQ(now, run) << "chain " << chain;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Resume,
                         ::testing::Values("ledger_of_cubes", "deep_cubes", "deep_implicit_dda", "deep_planar_dda",
                                           "ledger_of_spheres"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace riprap::run
