// SPDX-License-Identifier: Apache-2.0
// `riprap fos`: the factor of safety as a user gets it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

constexpr double degree = M_PI / 180, dip = 35 * degree;

/// A block of 1 x 0.4 m on a plane that dips at 35 degrees, x down the dip; friction of 45 degrees: F = 1.428.
constexpr double exact = 1 / 0.70020753820970977;

std::string block_text(const std::string& more = "") {
    return fmt::format(R"(
dimension = 2
gravity = [{}, {}]
settle = 0.5
settle_static = true
end = 1.0
[solid]
method = "planar_dda"
step = "4 ms"
[material.rock]
density = 2500.0
friction_angle_deg = 45.0
{}
[[body]]
name = "plane"
shape = {{ box = [30.0, 1.0] }}
position = [10.0, -0.5]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = {{ box = [1.0, 0.4] }}
position = [0.0, 0.2]
material = "rock"
)",
                       9.81 * std::sin(dip), -9.81 * std::cos(dip), more);
}

class Fos : public RunFixture {
 protected:
    Ending fos(const std::string& text, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"fos", write_case("fos.toml", text), "--out", out("fos"), "--jobs", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    nlohmann::json found() const {
        return nlohmann::json::parse(text_of(in("fos", "fos.json"))).at("factor_of_safety");
    }
};

TEST_F(Fos, FindsThatOfABlockOnAPlaneWithItsModeAndAPage) {
    const Ending ending = fos(block_text());
    ASSERT_EQ(ending.code, 0) << ending.out << ending.err;
    EXPECT_THAT(ending.out, HasSubstr("factor of safety 1.4"));
    const nlohmann::json answer = found();
    EXPECT_NEAR(answer.at("factor").get<double>(), exact, 0.01 * exact);
    EXPECT_LT(answer.at("stands").get<double>(), 1.005 * exact);
    EXPECT_GT(answer.at("fails").get<double>(), 0.995 * exact);
    const double unit = std::sqrt(std::hypot(1, 0.4) / 9.81);  // sqrt(size/g)
    EXPECT_NEAR(answer.at("over").get<double>(), 6 * unit, 1e-6);
    EXPECT_NEAR(answer.at("hold").get<double>(), 6 * unit, 1e-6);
    EXPECT_EQ(answer.at("begins"), 0);
    EXPECT_EQ(answer.at("creep"), 1e-3);
    EXPECT_EQ(answer.at("displaced"), 0.1);
    ASSERT_EQ(answer.at("mode").size(), 1U);
    EXPECT_EQ(answer.at("mode")[0].at("mode"), "slides");
    EXPECT_THAT(text_of(in("fos", "index.html")), HasSubstr("factor of safety 1.4"));
    EXPECT_THAT(text_of(in("fos", "fos.csv")), HasSubstr("run,status,strength.reduction"));
    EXPECT_THAT(text_of(in("fos", "fos_bodies.csv")), HasSubstr("\"block\",slides"));
    EXPECT_THAT(text_of(in("fos", "fos.svg")), HasSubstr("stands"));
    // The same command again runs nothing and says the same.
    const std::string before = text_of(in("fos", "F_1.00000/run.jsonl"));
    const Ending again = fos(block_text());
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(text_of(in("fos", "F_1.00000/run.jsonl")), before);
    EXPECT_EQ(found(), answer);
    EXPECT_EQ(fos(block_text(), {"--over", "1"}).code, 5);  // another search
}

TEST_F(Fos, HardlyDependsOnHowLongStrengthFallsNorOnDamping) {
    const auto factor = [this](const std::vector<std::string>& more) {
        std::filesystem::remove_all(out("fos"));
        std::vector<std::string> words{"--between", "1.35", "1.5", "--tolerance", "0.003", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Ending ending = fos(block_text("damping_ratio = 0.2\n"), words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        return found().at("factor").get<double>();
    };
    const double usual = factor({});
    EXPECT_NEAR(usual, exact, 0.005 * exact);
    EXPECT_NEAR(factor({"--over", "4.0"}), usual, 0.005 * usual);  // 2 s by itself
    EXPECT_NEAR(factor({"--set", "material.rock.damping_ratio=0.1"}), usual, 0.005 * usual);
}

TEST_F(Fos, IsBelow1WhereABlockSlidesAtFullStrength) {
    const Ending ending = fos(block_text(), {"--set", "material.rock.friction_angle_deg=30"});
    EXPECT_EQ(ending.code, 0) << ending.out << ending.err;
    const double expected = std::tan(30 * degree) / std::tan(dip);
    EXPECT_NEAR(found().at("factor").get<double>(), expected, 0.01 * expected);
}

TEST_F(Fos, CountsCohesionAlone) {
    // Base of 1 m, weight W = 2500 g 0.4: F = c A/(W sin 35 - W cos 35 tan phi) where friction stays.
    const double weight = 2500 * 9.81 * 0.4, friction = std::tan(20 * degree);
    const double lack = weight * (std::sin(dip) - std::cos(dip) * friction);
    const Ending ending = fos(block_text(fmt::format("cohesion = {}\n", 1.7 * lack)),
                              {"--set", "material.rock.friction_angle_deg=20", "--reduce", "cohesion"});
    EXPECT_EQ(ending.code, 0) << ending.out << ending.err;
    EXPECT_NEAR(found().at("factor").get<double>(), 1.7, 0.017);
}

TEST_F(Fos, TellsThatSomethingElseThanStrengthHoldsOrFails) {
    const Ending held = fos(block_text(), {"--between", "0.9", "1.2"});
    EXPECT_EQ(held.code, 1) << held.out;
    EXPECT_THAT(held.out, HasSubstr("factor of safety above 1.2"));
    EXPECT_THAT(held.out, HasSubstr("--between 0.9 4.8"));
    std::filesystem::remove_all(out("fos"));
    // A column of 0.4 x 1.6 m on the same plane topples at any strength.
    std::string slender = block_text();
    slender.replace(slender.find("[1.0, 0.4]"), 10, "[0.4, 1.6]");
    slender.replace(slender.find("[0.0, 0.2]"), 10, "[0.0, 0.8]");
    const Ending topples =
        fos(slender, {"--set", "settle_static=false", "--set", "settle=0.05", "--between", "0.7", "3"});
    EXPECT_EQ(topples.code, 1) << topples.out;
    EXPECT_THAT(topples.out, HasSubstr("fails at F = 0.7, the lower end, too"));
    EXPECT_THAT(topples.out, HasSubstr("topples"));
}

TEST_F(Fos, RefusesWhatCannotBeSearched) {
    const auto refusal = [this](const std::string& text, const std::vector<std::string>& more) {
        const Ending ending = fos(text, more);
        EXPECT_FALSE(std::filesystem::exists(out("fos"))) << ending.out;
        return ending;
    };
    const Ending smooth = refusal(block_text(), {"--set", "material.rock.friction_angle_deg=0"});
    EXPECT_EQ(smooth.code, 3);
    EXPECT_THAT(smooth.err, HasSubstr("'strength' divides nothing"));
    const Ending nobody = refusal(block_text(), {"--watch", "stone"});
    EXPECT_EQ(nobody.code, 3);
    EXPECT_THAT(nobody.err, HasSubstr("no free body has a name that begins with 'stone'"));
    const Ending twice = refusal(block_text(), {"--set", "strength={reduction=1.2, over=1.0}"});
    EXPECT_EQ(twice.code, 3);
    EXPECT_THAT(twice.err, HasSubstr("the case without [strength]"));
    const Ending turning =
        refusal(block_text(), {"--set", "gravity={value=[0, -9.81], rotation={axis=[0,0,1], rate=0.1}}"});
    EXPECT_EQ(turning.code, 3);
    EXPECT_THAT(turning.err, HasSubstr("gravity still turns"));
    EXPECT_EQ(refusal(block_text(), {"--between", "3", "2"}).code, 2);
    EXPECT_EQ(refusal(block_text(), {"--reduce", "stiffness"}).code, 2);
    EXPECT_EQ(fos(block_text(), {"--plan"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(out("fos")));
}

TEST_F(Fos, TakesWaterThatStandsBehindADam) {
    // A top of 2 x 4 m on a level crack, 3 m of water on it without uplift: F = W tan phi/(1/2 rho g h^2).
    const Ending ending = fos(R"(
dimension = 2
gravity = [0.0, -9.81]
settle = 0.5
settle_static = true
end = 1.5
[solid]
method = "planar_dda"
step = "4 ms"
[material.concrete]
density = 2400.0
friction_angle_deg = 30.0
[[body]]
name = "base"
shape = { box = [40.0, 2.0] }
position = [0.0, -1.0]
material = "concrete"
fixed = true
[[body]]
name = "dam"
shape = { box = [2.0, 4.0] }
position = [0.0, 2.0]
material = "concrete"
[fluid]
method = "hydrostatic"
spacing = 0.1
uplift = "none"
domain = { low = [-10.0, 0.0], high = [20.0, 6.0] }
levels = [[0.0, 0.0], [1.0, 3.0], [60.0, 3.0]]
[[fluid.region]]
box = { low = [-10.0, 0.0], high = [0.9, 6.0] }
)");
    ASSERT_EQ(ending.code, 0) << ending.out << ending.err;
    const double expected = 2400 * 8 * std::tan(30 * degree) / (0.5 * 1000 * 9);
    EXPECT_NEAR(found().at("factor").get<double>(), expected, 0.01 * expected);
}

}  // namespace
}  // namespace riprap
