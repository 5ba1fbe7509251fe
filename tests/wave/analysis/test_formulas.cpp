// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/formulas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "riprap/wave/analysis/goda_pressure.hpp"
#include "riprap/wave/linear_wave.hpp"

namespace riprap::wave {
namespace {

const Formula& named(std::string_view name) {
    const auto list = formulas();
    return *std::find_if(list.begin(), list.end(), [name](const Formula& one) { return one.name == name; });
}

/// Period whose waves have a breaker parameter xi.
double period_of(double xi, double height, double cot) {
    return xi * cot * std::sqrt(height * 2 * std::numbers::pi / 9.81);
}

TEST(Formulas, OvertoppingOfTheCaseStudiesOfEurOtop) {
    // [EurOtop2018] case study 6, run 2: H_m0 2.53 m, R_c 5.94 m, 0.059 l/s/m by eq. 7.1.
    const Predicted deep =
        predict(named("overtopping of a wall in deep water"), {{"height", 2.53}, {"freeboard", 5.94}});
    EXPECT_NEAR(1e3 * deep.value, 0.059, 0.0005);
    EXPECT_LT(deep.low, 0.5 * deep.value);
    EXPECT_GT(deep.high, 2 * deep.value);
    // Case study 12, run 1: H_m0 2.22 m, R_c 5.67 m, 0.429 l/s/m by eq. 7.5.
    EXPECT_NEAR(
        1e3 *
            predict(named("overtopping of a wall, no impulsive waves"), {{"height", 2.22}, {"freeboard", 5.67}}).value,
        0.429, 0.003);
    // Case study 8: H_m0 4.9 m, Accropode II (gamma_f 0.44), R_c 5.61 m, 21 l/s/m by design, mean + 1 deviation.
    EXPECT_NEAR(1e3 * named("overtopping of a rubble mound")
                          .answer({{"height", 4.9}, {"freeboard", 5.61}, {"roughness", 0.44}}, 1),
                21, 0.1);
}

TEST(Formulas, ASlopeOvertopsAsAMoundWhereWavesDoNotBreak) {
    FormulaValues given{{"height", 2}, {"freeboard", 2}, {"roughness", 0.8}, {"cot_slope", 2}, {"energy_period", 14}};
    const double most = named("overtopping of a rubble mound").answer(given, 0);
    EXPECT_DOUBLE_EQ(named("overtopping of a slope").answer(given, 0), most);
    given["energy_period"] = 5;  // xi 2.2; by eq. 5.10 with 0.023 and 2.7
    const double xi = std::sqrt(9.81 * 25 / (2 * std::numbers::pi) / 2) / 2;
    given["cot_slope"] = 4;
    EXPECT_NEAR(named("overtopping of a slope").answer(given, 0),
                0.023 * 2 * (xi / 2) * std::sqrt(9.81 * 8) * std::exp(-std::pow(2.7 / (xi / 2 * 0.8), 1.3)), 1e-12);
    EXPECT_NEAR(named("overtopping of a slope").answer(given, 1),  // the coefficients of design, 0.026 and 2.5
                0.026 * 2 * (xi / 2) * std::sqrt(9.81 * 8) * std::exp(-std::pow(2.5 / (xi / 2 * 0.8), 1.3)), 1e-12);
}

TEST(Formulas, RunUpTurnsWhereTheManualSaysAndHasItsDesignCoefficients) {
    const Formula& formula = named("run-up that 2 % exceed");
    FormulaValues given{{"height", 1}, {"cot_slope", 3}, {"roughness", 1}};
    given["energy_period"] = period_of(1.2, 1, 3);
    EXPECT_NEAR(formula.answer(given, 0), 1.65 * 1.2, 1e-9);
    EXPECT_NEAR(formula.answer(given, 1), 1.75 * 1.2, 1e-9);
    given["energy_period"] = period_of(3, 1, 3);
    EXPECT_NEAR(formula.answer(given, 0), 4 - 1.5 / std::sqrt(3), 1e-9);
    EXPECT_NEAR(formula.answer(given, 1), 1.07 * (4 - 1.5 / std::sqrt(3)), 1e-9);
    EXPECT_FALSE(formula.is_in_range({{"height", 1}, {"cot_slope", 1}, {"energy_period", 30}}));
}

TEST(Formulas, RockOfTheBoxesOfTheRockManual) {
    // [RockManual2007] box 5.13: H_s 5 m, Delta 1.6, P 0.4, S_d 5, N 2100, 1 : 3, xi_m 1.85: D_n50 = 1.26 m; box 5.14,
    // with a coefficient of 5.5 instead of 6.2: 1.42 m.
    FormulaValues given{{"height", 5},
                        {"relative_density", 1.6},
                        {"permeability", 0.4},
                        {"damage", 5},
                        {"waves", 2100},
                        {"cot_slope", 3},
                        {"mean_period", period_of(1.85, 5, 3)}};
    const Formula& formula = named("rock for a damage");
    EXPECT_NEAR(formula.answer(given, 0), 1.26, 0.005);
    EXPECT_NEAR(formula.answer(given, 1.75), 1.42, 0.005);
    given["diameter"] = formula.answer(given, 0);
    EXPECT_NEAR(named("damage of rock").answer(given, 0), 5, 1e-9);
    // Surging: H_s 4 m, 1 : 1.5, xi_m 4.46, worked by hand from the formula.
    given = {{"height", 4},
             {"relative_density", 1.6},
             {"permeability", 0.4},
             {"damage", 5},
             {"waves", 2100},
             {"cot_slope", 1.5},
             {"mean_period", period_of(4.46, 4, 1.5)}};
    EXPECT_NEAR(formula.answer(given, 0), 1.5519, 1e-4);
    EXPECT_TRUE(formula.is_in_range(given));
    given["waves"] = 9000;
    EXPECT_FALSE(formula.is_in_range(given));
}

TEST(Formulas, HudsonGivesAUnitOfTheTableOfXbloc) {
    // Guidelines of Xbloc, table 1: K_D 16, Delta 1.33, 3 : 4, H_s 5.01 m takes 2.5 m^3.
    const double size =
        predict(named("armour by Hudson"),
                {{"height", 5.01}, {"relative_density", 1.33}, {"stability_coefficient", 16}, {"cot_slope", 4.0 / 3}})
            .value;
    EXPECT_NEAR(size * size * size, 2.5, 0.01);
}

TEST(Formulas, GodasPressuresAreThoseOfTwoWorkedWalls) {
    // [Goda2000] p. 140: H_max 8.05 m, H_1/3 5.8 m, 11.4 s, 15 degrees, h 10.1, d 5.6, h' 7.1, h_c 3.4 m: p_u = 65.7
    // kPa.
    const GodaPressure book =
        goda_pressure({8.05, 5.796, 11.4, 10.1, 5.6, 7.1, 3.4, 0.01, 15 * std::numbers::pi / 180, 1030});
    EXPECT_NEAR(book.uplift, 65739, 5);
    EXPECT_NEAR(book.reach, 11.87, 0.01);
    // Test data of the Coastal Structures Toolbox of Deltares: H_max 5.07 m, H_1/3 2.75 m, 8 s, h 5, d 4, h' 6, h_c 5
    // m.
    const GodaPressure wall = goda_pressure({5.07, 2.75, 8, 5, 4, 6, 5, 0.01, 0, 1025});
    EXPECT_NEAR(wall.at_level, 52940, 10);
    EXPECT_NEAR(wall.force, 466220, 100);
    const GodaPressure longer = goda_pressure({5.07, 2.75, 12, 5, 4, 6, 5, 0.01, 0, 1025});
    EXPECT_NEAR(longer.at_level, 57683, 10);
    EXPECT_NEAR(longer.force, 525380, 100);
}

TEST(Formulas, StandOnTheirPageWithSourceRangeAndInputs) {
    std::ifstream file("docs/reference/waves.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const Formula& one : formulas()) {
        const std::string row = "| " + std::string(one.name) + " | " + std::string(one.quantity) + " | " +
                                std::string(one.source) + " | " + std::string(one.range) + " |\n";
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
    for (const FormulaInput& one : formula_inputs()) {
        const std::string row = "| " + std::string(one.key) + " | " + std::string(one.unit) + " | " +
                                std::string(one.help) + (one.help.empty() ? "|\n" : " |\n");
        EXPECT_NE(page.find(row), std::string::npos) << row;
    }
}

TEST(Formulas, EachNamesItsSourceAndInputsThatThereAre) {
    for (const Formula& one : formulas()) {
        EXPECT_FALSE(one.source.empty() || one.range.empty()) << one.name;
        FormulaValues given;
        for (const std::string_view input : one.inputs) {
            const auto known = formula_inputs();
            EXPECT_TRUE(std::any_of(known.begin(), known.end(), [&](const FormulaInput& i) { return i.key == input; }))
                << input;
            EXPECT_EQ(lacks(one, given).empty(), false) << one.name;
            given[std::string(input)] = 1;
        }
        EXPECT_EQ(lacks(one, given), "") << one.name;
    }
}

}  // namespace
}  // namespace riprap::wave
