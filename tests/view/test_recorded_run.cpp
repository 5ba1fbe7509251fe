// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/vtp.hpp"
#include "riprap/io/vtp_reader.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/view/chunk.hpp"
#include "riprap/view/pack_bodies.hpp"
#include "riprap/view/page_content.hpp"
#include "riprap/view/read_run.hpp"
#include "run/falling_blocks.hpp"
#include "view/unpack.hpp"

namespace riprap::view {
namespace {

namespace fs = std::filesystem;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr std::size_t plenty = 1U << 30U;

/// One short run of blocks on a floor, copied for each test that damages it.
class ARunFolder : public ::testing::Test {
 protected:
    static void SetUpTestSuite() {
        original_ = std::make_unique<TemporaryFolder>();
        std::ofstream(*original_ / "case.toml") << falling_blocks_text();
        run::run_case({.case_path = (*original_ / "case.toml").string(),
                       .overrides = {"end=0.05", "time_step=0.00025", "output.interval=0.005"},
                       .out = *original_ / "run",
                       .threads = 1,
                       .quiet = true});
    }
    static void TearDownTestSuite() { original_.reset(); }
    ARunFolder() { fs::copy(*original_ / "run", run_, fs::copy_options::recursive); }

    static void cut(const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); }
    nlohmann::json contents(std::size_t budget = plenty) const {
        return nlohmann::json::parse(pack_run(read_run(run_), budget).contents_json);
    }
    /// The last frame in the run's own order.
    fs::path last_frame() const { return run_ / "frames" / "bodies_000010.vtp"; }

    const TemporaryFolder folder_;
    const fs::path run_{folder_ / "run"};

 private:
    static inline std::unique_ptr<TemporaryFolder> original_;
};

TEST_F(ARunFolder, IsReadWholeWithoutANotice) {
    const RecordedRun run = read_run(run_);
    EXPECT_THAT(run.notices, IsEmpty());
    EXPECT_EQ(run.title, "Blocks fall on a floor");
    EXPECT_EQ(run.status, "finished");
    EXPECT_EQ(run.frames.size(), 11U);
    EXPECT_NEAR(run.frames.back().time, 0.05, 1e-12);
    EXPECT_EQ(run.body_names, (std::vector<std::string>{"floor", "low", "high", "lone"}));
    EXPECT_EQ(run.body_mass[1], 1250);
    EXPECT_EQ(run.gravity, (Vec3{0, 0, -9.81}));
    EXPECT_FALSE(run.is_planar);
    EXPECT_GT(run.ledger.row_count(), 10U);
    EXPECT_THAT(run.case_text, HasSubstr("name     = \"floor\""));
    const PageContent content = pack_run(run, plenty);
    EXPECT_THAT(content.notices, IsEmpty());
    EXPECT_EQ(nlohmann::json::parse(content.contents_json)["times"].size(), 11U);
}

TEST_F(ARunFolder, TellsGravityOfEveryFrameWhereItTurns) {
    EXPECT_TRUE(contents()["gravity_at"].is_null());
    std::ofstream(run_ / "resolved.toml")
        << "[gravity]\nvalue = [0.0, 0.0, -10.0]\n"
           "rotation = { axis = [0.0, -2.0, 0.0], rate = 10.0, start = 0.025 }\n"
           "[[output.gauge]]\nname = \"shore\"\nkind = \"level\"\npoint = [1.0, 2.0]\n";
    const nlohmann::json turning = contents();
    ASSERT_EQ(turning["gravity_at"].size(), 33U);
    EXPECT_EQ(turning["gravity_at"][0], 0);
    EXPECT_NEAR(turning["gravity_at"][30].get<double>(), 10 * std::sin(0.25), 1e-9);  // at 0.05 s
    EXPECT_NEAR(turning["gravity_at"][32].get<double>(), -10 * std::cos(0.25), 1e-9);
    EXPECT_EQ(turning["gauges"][0]["name"], "shore");
    EXPECT_EQ(turning["gauges"][0]["point"], (nlohmann::json{1.0, 2.0, 0.0}));
}

TEST_F(ARunFolder, IsLeftInTheMiddleOfPackingWhenTheUserStops) {
    const RecordedRun run = read_run(run_);
    const run::StopRequest stop;
    EXPECT_FALSE(pack_run(run, plenty, &stop).chunks.empty());
    std::raise(SIGINT);
    EXPECT_THROW(pack_run(run, plenty, &stop), Stopped);
}

TEST_F(ARunFolder, IsPackedWithThePosesThatBodiesCsvSays) {
    const PageContent content = pack_run(read_run(run_), plenty);
    const io::CsvTable bodies = io::read_csv(run_ / "bodies.csv", "name");
    bool is_found = false;
    for (const Chunk& chunk : content.chunks) {
        if (chunk.name != "poses-0") {
            continue;
        }
        is_found = true;
        std::string bytes = join_planes(decompress(chunk.packed, plenty), sizeof(double));
        restore_rows(bytes, 4 * pose_values * sizeof(double));
        const std::vector<double> poses = values_of<double>(bytes);
        ASSERT_EQ(poses.size(), 11 * 4 * pose_values);
        for (std::size_t body = 0; body < 4; ++body) {
            for (std::size_t k = 0; k < pose_values; ++k) {
                EXPECT_EQ(poses[(10 * 4 + body) * pose_values + k], bodies.values[4 + k][body]) << body << ' ' << k;
            }
        }
    }
    ASSERT_TRUE(is_found);
}

TEST_F(ARunFolder, HasEveryShapeInTheFrameOfItsBody) {
    const DrawnBodies bodies = read_shapes(io::read_vtp(last_frame()));
    const DrawnBodies at_start = read_shapes(io::read_vtp(run_ / "frames" / "bodies_000000.vtp"));
    ASSERT_EQ(bodies.body_count(), 4U);
    const DrawnShape& high = bodies.shapes[static_cast<std::size_t>(bodies.shape[2])];
    ASSERT_EQ(high.corners.size(), 8U);
    for (const Vec3& x : high.corners) {
        EXPECT_NEAR(norm(x), 0.5 * std::sqrt(0.6 * 0.6 + 0.7 * 0.7 + 0.5 * 0.5), 1e-12);
    }
    const DrawnShape& before = at_start.shapes[static_cast<std::size_t>(at_start.shape[2])];
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(norm(high.corners[i] - before.corners[i]), 0, 1e-12);
    }
}

TEST_F(ARunFolder, ThatIsNoneIsRefusedWithWhatToDo) {
    EXPECT_THAT([&] { read_run(folder_ / "nowhere"); }, ThrowsMessage<FileError>(HasSubstr("is no folder")));
    fs::create_directory(folder_ / "foreign");
    std::ofstream(folder_ / "foreign" / "letter.txt") << "Dear all";
    EXPECT_THAT([&] { read_run(folder_ / "foreign"); }, ThrowsMessage<FileError>(HasSubstr("holds no run")));
    EXPECT_THAT([&] { read_run(run_ / "case"); }, ThrowsMessage<FileError>(HasSubstr("into 'runs/case'")));
}

TEST_F(ARunFolder, WithAHalfWrittenLastFrameShowsTheOthers) {
    cut(last_frame());
    const nlohmann::json json = contents();
    EXPECT_EQ(json["times"].size(), 10U);
    ASSERT_EQ(json["notices"].size(), 1U);
    EXPECT_THAT(json["notices"][0].get<std::string>(), HasSubstr("bodies_000010.vtp"));
}

TEST_F(ARunFolder, WithDamagedFilesShowsTheRest) {
    cut(run_ / "summary.json");
    cut(run_ / "ledger.csv");
    std::ofstream(run_ / "probes.csv") << "something else\n";
    cut(run_ / "bodies.csv");
    std::ofstream(run_ / "resolved.toml") << "title = \"half";
    fs::remove(run_ / "case" / "case.toml");
    const RecordedRun run = read_run(run_);
    EXPECT_GE(run.notices.size(), 4U);
    EXPECT_EQ(run.status, "not finished");
    EXPECT_GT(run.ledger.row_count(), 5U);
    EXPECT_EQ(contents()["times"].size(), 11U);
}

TEST_F(ARunFolder, WithJsonNestedWithoutEndLeavesItOut) {
    const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
    std::ofstream(run_ / "summary.json") << deep;
    std::ofstream(run_ / "run.json") << deep;
    const PageContent content = pack_run(read_run(run_), plenty);
    EXPECT_THAT(content.notices, Each(HasSubstr("nested")));
    EXPECT_EQ(content.notices.size(), 2U);
    std::ofstream(run_ / "summary.json") << R"({"status": "a \"[[" , "x": [[)" << '"' << std::string(100, '{')
                                         << R"("]]})";
    EXPECT_EQ(read_run(run_).status, "a \"[[");  // brackets in texts do not count
}

TEST_F(ARunFolder, WithADamagedLineInATableSaysFromWhereOnRowsAreLost) {
    std::string text = io::read_file(run_ / "ledger.csv", plenty);
    const std::size_t third = text.find('\n', text.find('\n') + 1) + 1;
    text.replace(third, text.find('\n', third) - third, "half");
    std::ofstream(run_ / "ledger.csv") << text;
    const RecordedRun run = read_run(run_);
    EXPECT_EQ(run.ledger.row_count(), 1U);
    EXPECT_THAT(run.notices, ElementsAre(HasSubstr("line 3 of")));
}

TEST_F(ARunFolder, WithoutTheBodiesOfItsFirstFramesKeepsPosesAndTimesTogether) {
    std::string list = io::read_file(run_ / "out.pvd", plenty);
    for (const char* frame : {"frames/bodies_000000.vtp", "frames/bodies_000001.vtp"}) {
        const std::size_t at = list.find(frame);
        ASSERT_NE(at, std::string::npos);
        list.replace(at, std::string(frame).size(), "elsewhere/bodies.vtp");
    }
    std::ofstream(run_ / "out.pvd") << list;
    const RecordedRun run = read_run(run_);
    ASSERT_EQ(run.frames.size(), 11U);  // their contacts are still listed
    const PageContent content = pack_run(run, plenty);
    const std::size_t times = nlohmann::json::parse(content.contents_json)["times"].size();
    EXPECT_EQ(times, 9U);
    const auto poses = std::find_if(content.chunks.begin(), content.chunks.end(),
                                    [](const Chunk& chunk) { return chunk.name == "poses-0"; });
    ASSERT_NE(poses, content.chunks.end());
    EXPECT_EQ(decompress(poses->packed, plenty).size(), times * 4 * pose_values * sizeof(double));
}

TEST_F(ARunFolder, WithWaterAtInfinityLeavesThatWaterOut) {
    const std::string bodies = "frames/bodies_000003.vtp";
    std::string list = io::read_file(run_ / "out.pvd", plenty);
    const std::size_t name = list.find(bodies), begin = list.rfind("<DataSet", name), end = list.find('>', name) + 1;
    std::string entry = list.substr(begin, end - begin);
    entry.replace(entry.find(bodies), bodies.size(), "frames/water_000003.vtp");
    std::ofstream(run_ / "out.pvd") << list.insert(end, entry);
    for (const double far : {0.1, std::numeric_limits<double>::infinity(), 1e200}) {
        io::PolyData water;
        water.points = {{0, 0, 0}, {far, 0, 0}};
        water.add_point_array("id", std::array<std::int32_t, 2>{0, 1});
        water.add_point_array("pressure", std::array{0.0F, 1.0F});
        water.add_point_array("speed", std::array{0.0F, 1.0F});
        io::write_vtp(run_ / "frames" / "water_000003.vtp", water, 0.015);
        const nlohmann::json json = contents(1);
        EXPECT_EQ(json["water"].is_null(), far > 1) << far;
        EXPECT_EQ(json["notices"].dump().find("not finite") != std::string::npos, far > 1) << far;
        EXPECT_EQ(json["times"].size(), 11U);
    }
}

TEST_F(ARunFolder, WithoutItsListOfFramesShowsThoseItFinds) {
    fs::remove(run_ / "out.pvd");
    const RecordedRun run = read_run(run_);
    EXPECT_EQ(run.frames.size(), 11U);
    EXPECT_THAT(run.notices, Not(IsEmpty()));
    EXPECT_FALSE(run.frames[3].contacts.empty());
}

TEST_F(ARunFolder, WhoseListOfFramesIsCutSaysSoOnceAndShowsThemAll) {
    cut(run_ / "out.pvd");
    const PageContent content = pack_run(read_run(run_), plenty);
    EXPECT_THAT(content.notices, ElementsAre(HasSubstr("out.pvd' ends in the middle")));
    EXPECT_EQ(nlohmann::json::parse(content.contents_json)["times"].size(), 11U);
}

TEST_F(ARunFolder, WhoseSummaryWasLostIsKnownToHaveFinished) {
    fs::remove(run_ / "summary.json");
    const RecordedRun run = read_run(run_);
    EXPECT_EQ(run.status, "finished");
    EXPECT_THAT(run.notices, ElementsAre(HasSubstr("summary.json' is missing, though the run ended: finished at")));
    fs::remove(run_ / "run.jsonl");
    EXPECT_EQ(read_run(run_).status, "not finished");
    EXPECT_THAT(read_run(run_).notices, IsEmpty());
}

TEST_F(ARunFolder, TellsTheWarningsOfTheRun) {
    EXPECT_THAT(read_run(run_).warnings, IsEmpty());
    std::ofstream(run_ / "run.jsonl", std::ios::app) << R"({"event": "warning", "text": "thin gate"})" << '\n'
                                                     << R"({"event": "warning", "text": "thin gate"})" << '\n'
                                                     << R"({"event": "warn)";
    nlohmann::json summary = nlohmann::json::parse(io::read_file(run_ / "summary.json", plenty));
    summary.erase("warnings");
    std::ofstream(run_ / "summary.json") << summary;
    EXPECT_THAT(read_run(run_).warnings, ElementsAre("thin gate"));  // once, though it was said twice
    summary["warnings"] = {"thin wall"};
    std::ofstream(run_ / "summary.json") << summary;
    EXPECT_THAT(read_run(run_).warnings, ElementsAre("thin wall"));
    EXPECT_EQ(contents()["warnings"], summary["warnings"]);
}

TEST_F(ARunFolder, WithoutFramesStillHasItsTables) {
    fs::remove_all(run_ / "frames");
    const nlohmann::json json = contents();
    EXPECT_EQ(json["times"].size(), 0U);
    EXPECT_EQ(json["tables"].size(), 2U);
    EXPECT_GE(json["notices"].size(), 1U);
}

TEST_F(ARunFolder, WhoseListPointsElsewhereIsNotFollowed) {
    std::string list = io::read_file(run_ / "out.pvd", plenty);
    const std::string inside = "frames/bodies_000003.vtp";
    list.replace(list.find(inside), inside.size(), "../../etc/hostname");
    std::ofstream(run_ / "out.pvd") << list;
    EXPECT_EQ(read_run(run_).frames.size(), 11U);  // its contacts are still listed
    for (const FrameFiles& frame : read_run(run_).frames) {
        EXPECT_THAT(frame.bodies.string(), Not(HasSubstr("etc")));
    }
}

TEST_F(ARunFolder, TellsWhichBodiesWaterGoesThroughAndTheStonesThatItFlowsThrough) {
    RecordedRun run = read_run(run_);
    EXPECT_THAT(run.dry_names, IsEmpty());
    std::ofstream(run_ / "resolved.toml") << R"(dimension = 2
[[fluid.porous]]
shape = { polygon = [[0, 0], [2, 0], [2, 1]] }
position = [1.0, 0.5]
porosity = 0.45
[[fluid.porous]]
shape = { disc = 1.0 }
porosity = 0.3
[[body]]
name = "core"
wet = false
[[body]]
name = "corepiece"
wet = true
)";
    run = read_run(run_);
    EXPECT_THAT(run.dry_names, ElementsAre("core"));
    ASSERT_EQ(run.porous.size(), 1U);  // a disc is not hatched
    EXPECT_EQ(run.porous[0].porosity, 0.45);
    ASSERT_EQ(run.porous[0].corners.size(), 3U);
    EXPECT_EQ(run.porous[0].corners[2].x, 3);
    EXPECT_EQ(run.porous[0].corners[2].y, 1.5);
    run.body_names = {"core[0]", "corepiece", "core", "else"};
    EXPECT_EQ(nlohmann::json::parse(pack_run(run, plenty).contents_json)["bodies"]["dry"], (nlohmann::json{0, 2}));
}

}  // namespace
}  // namespace riprap::view
