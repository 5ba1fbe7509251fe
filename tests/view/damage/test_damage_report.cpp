// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/damage/damage_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/damage/survey.hpp"
#include "riprap/view/read_run.hpp"

namespace riprap::view {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string body(const std::string& name, const std::string& shape, const std::string& position,
                 const std::string& rest) {
    return fmt::format("[[body]]\nname = \"{}\"\nshape = {{ {} }}\nposition = {}\nmaterial = \"rock\"\n{}\n", name,
                       shape, position, rest);
}

/// Rows of three cubes of 1 m on the ground; the middle one of the first row is driven 10 m away within 1 s.
std::string row_text(int rows, bool is_planar) {
    const std::string down = is_planar ? "[0, -10]" : "[0, 0, -10]", up = is_planar ? "[0, 1]" : "[0, 0, 1]";
    std::string text = std::string(is_planar ? "dimension = 2\n" : "") + "gravity = " + down +
                       "\nend = 1.0\n[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1.0e7\n[output]\ninterval = "
                       "0.25\n[[body]]\nname = \"ground\"\nshape = { half_space = { normal = " +
                       up + ", offset = 0.0 } }\nmaterial = \"rock\"\nfixed = true\n";
    // The ground is drawn as wide as the scene is at the start: a post makes it reach to where the unit comes to lie.
    text += body("post", is_planar ? "box = [1.0, 1.0]" : "cube = 1.0", is_planar ? "[20, 0.5]" : "[20, 0, 0.5]",
                 "fixed = true");
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < 3; ++x) {
            const bool moves = x == 1 && y == 0;
            const std::string place = is_planar ? fmt::format("[{}, 0.5]", x) : fmt::format("[{}, {}, 0.5]", x, y);
            const std::string way = is_planar ? "[10, 0]" : "[10, 0, 0]";
            text += body(fmt::format("armour_{}_{}", y, x), is_planar ? "box = [1.0, 1.0]" : "cube = 1.0", place,
                         moves ? "motion = { linear = { velocity = " + way + " } }" : "fixed = true");
        }
    }
    return text;
}

RecordedRun run_of(const TemporaryFolder& place, const std::string& text) {
    io::write_file(place.path() / "case.toml", text);
    run::RunOptions options;
    options.case_path = (place.path() / "case.toml").string();
    options.out = place.path() / "run";
    options.threads = 1;
    options.silent = true;
    EXPECT_EQ(run::run_case(options), 0);
    return read_run(options.out);
}

DamageRequest of_armour() {
    DamageRequest request;
    request.units = "armour";
    return request;
}

/// Area of a gap of 1 m by 1 m that a foot of radius 0.25 m feels: at either wall it stands higher.
constexpr double radius = 0.25;
constexpr double felt = 1 - 2 * (radius - radius * radius + std::numbers::pi * radius * radius / 4);

TEST(DamageReport, AUnitThatLeavesARowIsOneAndErodesItsGap) {
    for (const bool is_planar : {true, false}) {
        const TemporaryFolder place;
        const DamageReport report = damage_report(run_of(place, row_text(1, is_planar)), of_armour());
        ASSERT_EQ(report.units.size(), 3U);
        EXPECT_NEAR(report.diameter, 1, 1e-9);
        EXPECT_NEAR(report.width, 1, 1e-9);
        EXPECT_NEAR(report.units[1].displacement, 10, 1e-6);
        EXPECT_NEAR(report.units[1].largest_speed, 10, 1e-5);
        EXPECT_EQ(report.units[0].displacement, 0);
        const ZoneDamage& all = report.zones[0];
        EXPECT_EQ(all.moved, 1U);
        EXPECT_NEAR(all.number, 1, 1e-9) << is_planar;
        EXPECT_NEAR(all.damage, felt, 0.06) << is_planar;  // stations 0.05 m apart
        // Where it lies now a foot feels it wider by what it misses of the gap.
        EXPECT_NEAR(all.deposited, 2 - felt, 0.06) << is_planar;
    }
}

TEST(DamageReport, InAStripOfTwoRowsItIsHalfAsMuch) {
    const TemporaryFolder place;
    const RecordedRun run = run_of(place, row_text(2, false));
    const DamageReport report = damage_report(run, of_armour());
    EXPECT_NEAR(report.width, 2, 1e-9);
    EXPECT_NEAR(report.zones[0].number, 0.5, 1e-9);
    EXPECT_NEAR(report.zones[0].damage, 0.5 * felt, 0.06);
    DamageRequest request = of_armour();
    request.zones = {{-1, 0.4}, {0.4, 2}};
    request.to = 0.0501;  // of frames 0.25 s apart the nearest is the first one
    EXPECT_THAT([&] { damage_report(run, request); }, ThrowsMessage<BadRequest>(HasSubstr("no two frames")));
    request.to = 0.25;
    const DamageReport zones = damage_report(run, request);
    ASSERT_EQ(zones.zones.size(), 3U);
    EXPECT_EQ(zones.zones[1].units, 0U);
    EXPECT_EQ(zones.zones[2].units, 6U);
    EXPECT_EQ(zones.zones[2].moved_twice, 1U);  // 2.5 m
    EXPECT_NEAR(zones.zones[1].eroded + zones.zones[2].eroded, zones.zones[0].eroded, 1e-12);
    request.units = "armor";
    EXPECT_THAT([&] { damage_report(run, request); }, ThrowsMessage<BadRequest>(HasSubstr("begins with 'armor'")));
    EXPECT_THAT([&] { damage_report(run, {}); }, ThrowsMessage<BadRequest>(HasSubstr("no body of the run is free")));
}

TEST(DamageReport, AnUntouchedSlopeHasNone) {
    const TemporaryFolder place;
    std::string text = row_text(2, false);
    text.replace(text.find("velocity = [10, 0, 0]"), 21, "velocity = [0, 0, 0]");
    const DamageReport report = damage_report(run_of(place, text), of_armour());
    EXPECT_EQ(report.zones[0].damage, 0);
    EXPECT_EQ(report.zones[0].number, 0);
    EXPECT_EQ(report.zones[0].deposited, 0);
}

TEST(DamageReport, IsWrittenAsTablesAndAFigure) {
    const TemporaryFolder place;
    const DamageReport report = damage_report(run_of(place, row_text(1, false)), of_armour());
    const std::vector<std::filesystem::path> files = write_damage(place.path() / "damage", report);
    ASSERT_EQ(files.size(), 4U);
    EXPECT_THAT(io::read_file(files[1], 1U << 20U), HasSubstr("\"armour_0_1\",1,0.5,10"));
    EXPECT_THAT(io::read_file(files[3], 1U << 20U), HasSubstr("Profile before and after"));
    EXPECT_THAT(damage_text(report), HasSubstr("3 units, D_n50 = 1 m"));
    EXPECT_EQ(nlohmann::json::parse(damage_json(report)).at("zones").at(0).at("moved"), 1);
}

TEST(Survey, VolumesAreThoseOfTheShapes) {
    DrawnShape tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    EXPECT_NEAR(volume_of(tetrahedron, false), 1, 1e-12);
    const DrawnShape square{{{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}, {{0, 1, 2, 3}}};
    EXPECT_NEAR(volume_of(square, true), 4, 1e-12);
}

}  // namespace
}  // namespace riprap::view
