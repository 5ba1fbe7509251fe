// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/older_checkpoint.hpp"
#include "io/temporary_folder.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/simulate/restart.hpp"
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

/// Gives a table the heading that another version wrote; returns its text.
std::string with_other_heading(const std::filesystem::path& file) {
    std::string text = io::read_file(file, 1U << 24U);
    text.replace(text.find(",", 0) + 1, 5, "older");
    io::write_file(file, text);
    return text;
}

// Story: the ledger of version 0.2 has other columns, and a run of it could not go on for them.
TEST(OldCheckpoints, TablesWithOtherColumnsAreSetAsideAndNewOnesBegin) {
    const TemporaryFolder place;
    const std::filesystem::path folder = place.path() / "run", latest = RunFolder{folder}.checkpoint_latest();
    RunOptions options;
    options.overrides = {"end=0.1", "max_steps=60"};
    options.out = folder;
    options.threads = 1;
    options.silent = true;
    ASSERT_EQ(run_loaded(falling_blocks(options.overrides), options), 0);
    const std::string ledger = with_other_heading(folder / "ledger.csv");
    const std::string probes = io::read_file(folder / "probes.csv", 1U << 24U);
    make_older(latest, 1);
    const std::string checkpoint = io::read_file(latest, 1U << 24U);

    const auto expect_set_aside = [&] {
        EXPECT_EQ(io::read_file(folder / "ledger.older.csv", 1U << 24U), ledger);
        EXPECT_FALSE(std::filesystem::exists(folder / "ledger.older-2.csv"));
        const io::CsvTable now = io::read_record(folder / "ledger.csv");
        EXPECT_EQ(now.columns[1].name, "solid.kinetic");
        EXPECT_GT(now.values[0].front(), 0);                                               // from the checkpoint on
        EXPECT_TRUE(io::read_file(folder / "probes.csv", 1U << 24U).starts_with(probes));  // has its columns: goes on
    };
    ASSERT_EQ(resume_run({folder, 1, {}, 80, true}), 0);
    expect_set_aside();
    ASSERT_EQ(resume_run({folder, 1, {}, 90, true}), 0);  // by a checkpoint of this version
    expect_set_aside();

    // Killed after the table was set aside, before the next checkpoint: the new one has a heading at most.
    io::write_file(latest, checkpoint);
    std::filesystem::remove(folder / "ledger.csv");
    ASSERT_EQ(resume_run({folder, 1, {}, 80, true}), 0);
    expect_set_aside();
}

}  // namespace
}  // namespace riprap::run
