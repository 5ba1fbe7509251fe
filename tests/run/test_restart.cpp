// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "io/temporary_folder.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/sim/advance.hpp"
#include "run/falling_blocks.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;

/// A run some steps in, and its folder.
struct SomeRun {
    TemporaryFolder place;
    RunFolder folder{place.path()};
    scene::LoadedCase loaded;
    sim::State initial, state;
    RunRecord record;

    explicit SomeRun(const std::vector<std::string>& overrides = {})
        : loaded(falling_blocks(overrides)), initial(loaded.state) {
        sim::initialise(loaded.model, initial);
        state = initial;
        sim::Scratch scratch;
        record.end = 0.5;
        record.frame_interval = record.row_interval = 0.01;
        record.csv_bytes = {1, 2};
        record.frame_times = {0, 0.5};
        io::make_folder(folder.checkpoint_latest().parent_path());
        step(scratch);
        save_checkpoint(folder, loaded.model, state, record);
        step(scratch);
        save_checkpoint(folder, loaded.model, state, record);
    }
    void step(sim::Scratch& scratch) {
        for (int i = 0; i < 200; ++i) {
            ASSERT_TRUE(advance(loaded.model, state, scratch, 1e-4).status.ok());
        }
    }
    Restart load() const { return load_checkpoint(folder, loaded.model, initial); }
    void flip_byte(const std::filesystem::path& path, std::size_t at) const {
        std::string bytes = io::read_file(path, 1U << 24U);
        bytes[at] = static_cast<char>(bytes[at] ^ 4);
        io::write_file(path, bytes);
    }
    std::string refusal() const {
        try {
            load();
        } catch (const CheckpointError& error) {
            return error.what();
        }
        return "accepted";
    }
};

TEST(Restart, TheLatestCheckpointBringsBackStateAndRecord) {
    const SomeRun run;
    const Restart restart = run.load();
    EXPECT_EQ(state_hash(restart.state), state_hash(run.state));
    EXPECT_EQ(hash_fields(restart.record), hash_fields(run.record));
    EXPECT_EQ(restart.notice, "");
}

TEST(Restart, ADamagedLatestCheckpointFallsBackToTheOneBeforeAndIsSetAside) {
    const SomeRun run;
    run.flip_byte(run.folder.checkpoint_latest(), 200);
    const Restart restart = run.load();
    EXPECT_EQ(restart.state.step, 200);
    EXPECT_THAT(restart.notice, HasSubstr("latest"));
    // The next checkpoint must not push the damaged file over the good one.
    EXPECT_FALSE(std::filesystem::exists(run.folder.checkpoint_latest()));
    save_checkpoint(run.folder, run.loaded.model, run.state, run.record);
    EXPECT_EQ(run.load().state.step, 400);
    run.flip_byte(run.folder.checkpoint_latest(), 200);
    EXPECT_EQ(run.load().state.step, 200);
}

TEST(Restart, AMissingLatestCheckpointFallsBackToTheOneBefore) {
    const SomeRun run;  // as after a kill between the two renames
    std::filesystem::remove(run.folder.checkpoint_latest());
    EXPECT_EQ(run.load().state.step, 200);
}

TEST(Restart, TwoDamagedCheckpointsAreBothNamed) {
    const SomeRun run;
    run.flip_byte(run.folder.checkpoint_latest(), 200);
    io::write_file(run.folder.checkpoint_previous(), "");
    EXPECT_THAT(run.refusal(), HasSubstr("latest"));
    EXPECT_THAT(run.refusal(), HasSubstr("previous"));
    EXPECT_THAT(run.refusal(), HasSubstr("--force"));
}

TEST(Restart, ACheckpointOfAnotherCaseIsRefusedEvenWhereThePreviousOneFits) {
    SomeRun run;
    sim::Model other = run.loaded.model;
    other.case_hash += 1;
    save_checkpoint(run.folder, other, run.state, run.record);
    EXPECT_THAT(run.refusal(), HasSubstr("another case"));
}

/// Returns the reason why a checkpoint with wrong content but good checksums is refused.
std::string refusal_of(const std::function<void(sim::State&, RunRecord&)>& change,
                       const std::vector<std::string>& overrides = {}) {
    SomeRun run(overrides);
    change(run.state, run.record);
    save_checkpoint(run.folder, run.loaded.model, run.state, run.record);
    std::filesystem::remove(run.folder.checkpoint_previous());
    return run.refusal();
}

TEST(Restart, EverythingThatLaterCodeReliesOnIsChecked) {
    const auto contact = [](sim::State& state, std::uint64_t a, std::uint64_t b) {
        state.contacts.resize(1);
        state.contacts.pair[0] = a << 32U | b;
    };
    EXPECT_EQ(refusal_of([](sim::State&, RunRecord&) {}), "accepted");
    EXPECT_THAT(refusal_of([&](sim::State& s, RunRecord&) { contact(s, 1, 999); }), HasSubstr("parts 1 and 999"));
    EXPECT_THAT(refusal_of([&](sim::State& s, RunRecord&) { contact(s, 2, 1); }), HasSubstr("parts 2 and 1"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.contacts.torsion.push_back(0); }),
                HasSubstr("differ in length"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) {
                    s.contacts.resize(2);
                    s.contacts.pair = {1, 1};
                    s.contacts.feature = {0, 0};
                }),
                HasSubstr("out of order"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.bodies.position.pop_back(); }), HasSubstr("entries"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.bodies.velocity[1].y = NAN; }),
                HasSubstr("body.velocity[1] is not a finite number"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.bodies.orientation[1].w += 1; }),
                HasSubstr("not a rotation"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.ledger.totals.push_back(0); }),
                HasSubstr("ledger.totals"));
    // Versions before what water has turned over and the work of a changing gravity on it, eight numbers, and the rise
    // of its energy and the miss of the first steps, three more, were kept.
    for (const std::size_t missing : {8U, 11U}) {
        EXPECT_EQ(
            refusal_of([&](sim::State& s, RunRecord&) { s.ledger.totals.resize(s.ledger.totals.size() - missing); }),
            "accepted");
    }
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.step = -1; }), HasSubstr("negative"));
    EXPECT_THAT(refusal_of([](sim::State& s, RunRecord&) { s.stepping.halvings = 60; }), HasSubstr("halved 60 times"));
    EXPECT_THAT(refusal_of([](sim::State&, RunRecord& r) { r.end = 0; }), HasSubstr("end of the run"));
    EXPECT_THAT(refusal_of([](sim::State&, RunRecord& r) { r.row_interval = 0; }), HasSubstr("interval"));
    EXPECT_THAT(refusal_of([](sim::State&, RunRecord& r) { r.next_frame = -1; }), HasSubstr("next output"));
    EXPECT_THAT(refusal_of([](sim::State&, RunRecord& r) { r.csv_bytes.clear(); }), HasSubstr("tables"));
}

TEST(Restart, TheFieldsOfASolidMethodAreThoseOfItsBodies) {
    const std::vector<std::string> dda{"solid.method=\"explicit_dda\"", "solid.youngs_modulus=1e7"};
    const std::vector<std::string> spheres{"solid.method=\"sphere_dem\""};
    const auto blocks = [](sim::State & s) -> auto& { return std::get<solid::explicit_dda::State>(s.solid_fields); };
    const auto springs = [](sim::State & s) -> auto& {
        return std::get<solid::sphere_dem::SphereState>(s.solid_fields).walls;
    };
    const auto touch = [](solid::affine::BlockContactHistory& contacts, std::uint64_t pair) {
        contacts.pair = {pair};
        contacts.feature = contacts.plane = {0};
        contacts.normal = contacts.slip = {Vec3{}};
        contacts.mode = contacts.is_intact = {0};
        contacts.plastic_slip = contacts.energy = {0.0};
    };
    EXPECT_EQ(refusal_of([](sim::State&, RunRecord&) {}, dda), "accepted");
    EXPECT_THAT(refusal_of([&](sim::State& s, RunRecord&) { blocks(s).blocks.position.pop_back(); }, dda),
                HasSubstr("there are 3 blocks of 4 bodies"));
    EXPECT_THAT(refusal_of([&](sim::State& s, RunRecord&) { touch(blocks(s).contacts, 99); }, dda),
                HasSubstr("a contact is of a block beyond the 4"));
    EXPECT_THAT(refusal_of([&](sim::State& s, RunRecord&) { blocks(s).contacts.slip.push_back({}); }, dda),
                HasSubstr("differ in length"));
    EXPECT_EQ(refusal_of([](sim::State&, RunRecord&) {}, spheres), "accepted");
    EXPECT_THAT(refusal_of(
                    [&](sim::State& s, RunRecord&) {
                        springs(s) = {
                            .pair = {~0ULL}, .force = {Vec3{}}, .stiffness = {0.0}, .rolling = {}, .normal = {Vec3{}}};
                    },
                    spheres),
                HasSubstr("a contact is of a sphere beyond"));
}

}  // namespace
}  // namespace riprap::run
