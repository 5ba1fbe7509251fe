// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/older_checkpoint.hpp"
#include "io/temporary_folder.hpp"
#include "riprap/run/restart.hpp"
#include "riprap/sim/advance.hpp"
#include "run/falling_blocks.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

struct OldRun {
    TemporaryFolder place;
    RunFolder folder{place.path()};
    scene::LoadedCase loaded;
    sim::State initial;

    explicit OldRun(const std::vector<std::string>& overrides)
        : loaded(falling_blocks(overrides)), initial(loaded.state) {
        sim::initialise(loaded.model, initial);
        io::make_folder(folder.checkpoint_latest().parent_path());
    }
    sim::State steps(sim::State state, int count) const {
        sim::Scratch scratch;
        for (int i = 0; i < count; ++i) {
            EXPECT_TRUE(advance(loaded.model, state, scratch, 1e-4).status.ok());
        }
        return state;
    }
    void save(const sim::State& state) const {
        RunRecord record;
        record.end = 0.5;
        record.frame_interval = record.row_interval = 0.01;
        record.csv_bytes = {1, 2};
        save_checkpoint(folder, loaded.model, state, record);
    }
};

TEST(OldCheckpoints, OfEveryFormatAreTakenUpAndGoOnAsTheRunWouldHave) {
    const std::vector<std::vector<std::string>> methods{{},
                                                        {"solid.method=\"sphere_dem\""},
                                                        {"solid.method=\"explicit_dda\"", "solid.youngs_modulus=1e7"},
                                                        {"solid.method=\"implicit_dda\"", "solid.youngs_modulus=1e7"}};
    for (const std::vector<std::string>& method : methods) {
        const OldRun run(method);
        const sim::State middle = run.steps(run.initial, 300);
        const sim::State end = run.steps(middle, 100);
        for (std::uint32_t version = 1; version < io::checkpoint_version; ++version) {
            SCOPED_TRACE((method.empty() ? "default" : method.front()) + ", format " + std::to_string(version));
            run.save(middle);
            make_older(run.folder.checkpoint_latest(), version);
            const Restart restart = load_checkpoint(run.folder, run.loaded.model, run.initial);
            EXPECT_TRUE(restart.is_of_unknown_case);
            EXPECT_THAT(restart.notice, AllOf(HasSubstr("rules and defaults of this version"), HasSubstr("Riprap")));
            EXPECT_EQ(state_hash(run.steps(restart.state, 100)), state_hash(end));
        }
    }
}

TEST(OldCheckpoints, AFieldThatTheirFormatHadIsMissedAsEver) {
    const OldRun run({});
    run.save(run.steps(run.initial, 10));
    const std::filesystem::path path = run.folder.checkpoint_latest();
    make_older(path, 1);
    RunRecord record;
    const auto any_length = [](std::string_view) { return false; };
    const std::string bytes = io::read_file(path, 1U << 24U);
    io::restore(io::Checkpoint::parse(bytes, "file"), record, any_length);
    const io::Checkpoint false_claim = io::Checkpoint::parse(with_format(bytes, 2), "file");
    EXPECT_THAT([&] { io::restore(false_claim, record, any_length); },
                ::testing::ThrowsMessage<CheckpointError>(HasSubstr("no section 'run.approached'")));
}

}  // namespace
}  // namespace riprap::run
