// SPDX-License-Identifier: Apache-2.0
// Prescribed motions of bodies, and paddles that make waves.
#include <cmath>
#include <numbers>

#include "case_fixture.hpp"
#include "io/temporary_folder.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadMotion, motions_reach_the_model) {
    const std::string moving = minimal_case + "motion = { start = 0.5, stop = \"2 s\", ";
    const auto law = [&](const std::string& text) { return read(moving + text + " }\n").model.bodies.motions.at(0); };
    const body::PrescribedMotion linear = law("linear = { velocity = [1, 0, 0] }");
    EXPECT_EQ(linear.start, 0.5);
    EXPECT_EQ(linear.stop, 2);
    EXPECT_EQ(std::get<body::LinearMotion>(linear.law).velocity, (Vec3{1, 0, 0}));
    EXPECT_EQ(std::get<body::SinusoidalMotion>(law("sinusoidal = { amplitude = [0, 0, 0.1], period = 3 }").law).period,
              3);
    const auto rotation = std::get<body::RotatingMotion>(
        law("rotation = { center = [0, 0, 0], axis = [0, 3, 0], rate = \"1 rpm\" }").law);
    EXPECT_DOUBLE_EQ(rotation.rate, std::numbers::pi / 30);
    EXPECT_EQ(rotation.axis, (Vec3{0, 1, 0}));
    const auto table =
        std::get<body::TableMotion>(law("table = { time = [0, 1], displacement = [[0, 0, 0], [0, 0, 1]] }").law);
    EXPECT_EQ(table.displacement[1], (Vec3{0, 0, 1}));
}

TEST(ReadMotion, wave_makers_get_their_stroke_from_wave_theory) {
    const std::string moving = minimal_case + "motion = { wave_maker = { height = 0.1, depth = 0.5, ";
    const auto law = [&](const std::string& text) {
        return read(moving + text + " } }\n").model.bodies.motions.at(0).law;
    };
    const auto paddle = [&](const std::string& text) { return std::get<body::HarmonicMotion>(law(text)); };
    EXPECT_NEAR(2 * paddle("period = 1.2").amplitude[0], 0.1 / 1.41675, 1e-6);
    EXPECT_EQ(paddle("period = 1.2").amplitude[1], 0);
    const auto flap = paddle("period = 1.2, paddle = \"flap\", hinge = [0, 0, 0]");
    EXPECT_NEAR(2 * flap.amplitude[0], 0.1 / 0.82085, 1e-5);
    EXPECT_EQ(flap.arm, 0.5);
    EXPECT_EQ(flap.direction, (Vec3{0, 1, 0}));
    EXPECT_GT(paddle("period = 2, wave = \"second_order\"").amplitude[1], 0);
    const auto solitary = std::get<body::SplineMotion>(law("wave = \"solitary\", direction = [0, 2, 0]"));
    EXPECT_NEAR(solitary.stroke.back(), 0.999 * 2 * 0.1 / (0.7746 * 0.5), 1e-5);
}

TEST(ReadMotion, a_paddle_makes_a_sea_to_the_end_of_the_run_and_beyond) {
    const auto sea = [&](const std::string& text) {
        const std::string moving = minimal_case + "motion = { wave_maker = { wave = \"irregular\", depth = 0.5, ";
        return std::get<body::SplineMotion>(read(moving + text + " } }\n").model.bodies.motions.at(0).law);
    };
    const std::string usual = "height = 0.06, period = 1.5";
    const body::SplineMotion first = sea(usual), linear = sea(usual + ", second_order = false");
    EXPECT_GE(first.time.back(), read(minimal_case).model.time.end);
    EXPECT_EQ(first.stroke.front(), 0);
    EXPECT_NE(first.stroke, linear.stroke);
    EXPECT_NE(first.stroke, sea(usual + ", seed = 2").stroke);
    EXPECT_NE(first.stroke, sea(usual + ", spectrum = \"pierson_moskowitz\"").stroke);
    EXPECT_EQ(sea(usual + ", gamma = 1").stroke, sea(usual + ", spectrum = \"pierson_moskowitz\"").stroke);
}

TEST(ReadMotion, a_sea_takes_its_spectrum_from_a_file_and_its_height_from_the_case) {
    const TemporaryFolder folder;
    folder.write("sea.csv", "f [1/s],S [m^2 s]\n0.4,0\n0.6,1e-3\n0.8,2e-4\n1.2,0\n");
    folder.write("falling.csv", "f,S\n0.6,1e-3\n0.4,1e-3\n");
    const auto text = [&](const std::string& more) {
        return minimal_case + "motion = { wave_maker = { wave = \"irregular\", depth = 0.5, " + more + " } }\n";
    };
    const auto stroke = [&](const std::string& more) {
        const LoadedCase loaded = read_case_text(text(more), "case.toml", folder.path().string(), {});
        return std::get<body::SplineMotion>(loaded.model.bodies.motions.at(0).law).stroke;
    };
    const std::vector<double> own = stroke("second_order = false, spectrum_file = \"sea.csv\"");
    // m_0 = 1e-4 + 1.2e-4 + 4e-5 m^2: H_m0 = 4 sqrt(2.6e-4) = 0.064498 m.
    const std::vector<double> twice = stroke("second_order = false, spectrum_file = \"sea.csv\", height = 0.128996");
    for (std::size_t i = 1; i < own.size(); i += 7) {
        EXPECT_NEAR(twice[i], 2 * own[i], 1e-4 * std::abs(own[i]));
    }
    const auto problems = [&](const std::string& more) {
        try {
            read_case_text(text(more), "case.toml", folder.path().string(), {});
        } catch (const CaseError& error) {
            return error.problems().front().message + "; " + error.problems().front().allowed;
        }
        return std::string();
    };
    EXPECT_THAT(problems("spectrum_file = \"falling.csv\""),
                HasSubstr("row 2 of the spectrum has f = 0.4 1/s and S = 0.001 m^2 s (file of case.toml:"));
    EXPECT_THAT(problems("spectrum_file = \"sea.csv\", period = 2"), HasSubstr("which has its own"));
    EXPECT_THAT(problems("height = 0.1"), HasSubstr("a sea without 'period'"));
    EXPECT_THAT(problems("height = 0.3, period = 9"), HasSubstr("beyond second-order theory"));
    // The same spectrum over rad/s, as other programs write it, was a sea of waves a few centimetres long.
    folder.write("radians.csv", "2.5133,0\n3.7699,1.5915e-4\n5.0265,3.1831e-5\n7.5398,0\n");
    EXPECT_THAT(
        problems("spectrum_file = \"radians.csv\""),
        HasSubstr(
            "a sea 0.0645 m high whose peak at 3.77 Hz is 0.1099 m long breaks; less than 0.0156 m, 0.142 L tanh kd; "
            "frequencies of the file in 1/s, not rad/s"));
    EXPECT_THAT(problems("height = 0.1, period = 0.5"), HasSubstr("less than 0.05543 m, 0.142 L tanh kd"));
}

TEST(ReadMotion, waves_that_cannot_be_made_are_refused_with_the_reason) {
    const auto problems = [](const std::string& text) {
        return problems_of(minimal_case + "motion = { wave_maker = { " + text + " } }\n");
    };
    EXPECT_THAT(problems("height = 0.1, depth = 0.5"), ElementsAre(HasSubstr("without 'period'")));
    // The lower of two limits is told: steepness of a short wave, depth for a long one.
    EXPECT_THAT(problems("height = 0.4, depth = 0.5, period = 1"),
                ElementsAre(HasSubstr("1.513 m long in 0.5 m of water breaks; less than 0.2082 m, 0.142 L tanh kd")));
    EXPECT_THAT(problems("height = 0.4, depth = 0.5, period = 9"),
                ElementsAre(HasSubstr("breaks; less than 0.39 m, 0.78 of the depth")));
    EXPECT_THAT(problems("height = 0.4, depth = 0.5, wave = \"solitary\""),
                ElementsAre(HasSubstr("a wave 0.4 m high in 0.5 m of water breaks; less than 0.39 m")));
    EXPECT_THAT(problems("height = 0.1, depth = 0.5, period = 1, paddle = \"flap\""), ElementsAre(HasSubstr("hinge")));
    EXPECT_THAT(problems("height = 0.1, depth = 0.5, paddle = \"flap\", hinge = [0, 0, 0], wave = \"solitary\""),
                ElementsAre(HasSubstr("flap")));
    EXPECT_THAT(problems("height = 0.1, depth = 0.5, period = 1, direction = [1, 0, 1]"),
                ElementsAre(HasSubstr("up or down")));
    EXPECT_THAT(problems("height = 0.1, depth = 0.5, period = 1e-9"),
                ElementsAre(HasSubstr("waves of 1e-09 s in 0.5 m of water are too short for a paddle")));
    for (const std::string period : {"1e9", "1e200"}) {
        EXPECT_THAT(problems("height = 0.1, depth = 0.5, period = " + period),
                    ElementsAre(HasSubstr("too long for a paddle; a period with kd = 2 pi d/L from 0.0001 to 300")));
    }
    EXPECT_THAT(problems("depth = 0.5, period = 1"), ElementsAre(HasSubstr("without 'height'")));
    EXPECT_THAT(problems("depth = 0.5, wave = \"none\""), ElementsAre(HasSubstr("neither makes nor absorbs")));
    EXPECT_THAT(problems("height = 0.1, depth = 0.5, period = 1, absorb = [0, 0, 0]"),
                ElementsAre(HasSubstr("without water")));
    EXPECT_THAT(problems("height = 0.2, depth = 0.3, period = 9, wave = \"second_order\""),
                ElementsAre(HasSubstr("second-order theory")));
}

TEST(ReadMotion, a_motion_table_is_read_from_the_folder_of_the_case) {
    const TemporaryFolder folder;
    folder.write("shake.csv", "time [s],x [m],y [m],z [m]\n0,0,0,0\r\n0.5, 0.1 ,0,0\n\n1,0,0,0\n");
    const LoadedCase loaded = read(minimal_case + "motion = { table = { file = \"shake.csv\" } }\n", {}, folder.path());
    const auto table = std::get<body::TableMotion>(loaded.model.bodies.motions.at(0).law);
    EXPECT_THAT(table.time, ElementsAre(0, 0.5, 1));
    EXPECT_EQ(table.displacement[1].x, 0.1);
    ASSERT_EQ(loaded.inputs.size(), 1U);
    EXPECT_EQ(loaded.inputs[0].path, "shake.csv");
    folder.write("shake.csv", "t,x,y,z\n0,0,0,0\n1,1,x,0\n");
    EXPECT_THAT(problems_of(minimal_case + "motion = { table = { file = \"shake.csv\" } }\n", {}, folder.path()),
                ElementsAre(HasSubstr("shake.csv:3:5: \"x\" in column 3 is not a finite number (file of case.toml:")));
}

}  // namespace
}  // namespace riprap::scene
