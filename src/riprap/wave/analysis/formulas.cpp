// SPDX-License-Identifier: Apache-2.0
#include "riprap/wave/analysis/formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "riprap/wave/analysis/goda_pressure.hpp"

namespace riprap::wave {

namespace {

constexpr double gravity = 9.81;  // that of the sources [m/s^2]

double at(const FormulaValues& given, std::string_view key) { return given.find(key)->second; }

/// xi = tan alpha / sqrt(H / (g T^2/(2 pi))) [-]
double breaker(const FormulaValues& given, std::string_view period) {
    const double length = gravity * at(given, period) * at(given, period) / (2 * std::numbers::pi);
    return 1 / (at(given, "cot_slope") * std::sqrt(at(given, "height") / length));
}

/// q = scale sqrt(g H^3) exp(-(c R_c/H)^power) [m^2/s]
double overtopping(double scale, double c, double power, const FormulaValues& given) {
    const double height = at(given, "height");
    return scale * std::sqrt(gravity * height * height * height) *
           std::exp(-std::pow(c * at(given, "freeboard") / height, power));
}

/// [EurOtop2018, eqs. 5.10, 5.11] without berm, wall and oblique waves:
/// 0.023/sqrt(tan alpha) xi exp(-(2.7 R_c/(xi H gamma_f))^1.3), at most 0.09 exp(-(1.5 R_c/(H gamma_f))^1.3).
double over_slope(const FormulaValues& given, double n) {
    const double xi = breaker(given, "energy_period"), rough = at(given, "roughness");
    const double breaking = overtopping((0.023 + 0.003 * n) * std::sqrt(at(given, "cot_slope")) * xi,
                                        (2.7 - 0.20 * n) / (xi * rough), 1.3, given);
    return std::min(breaking, overtopping(0.09 + 0.0135 * n, (1.5 - 0.15 * n) / rough, 1.3, given));
}

/// [EurOtop2018, eq. 6.5]
double over_mound(const FormulaValues& given, double n) {
    return overtopping(0.09 + 0.0135 * n, (1.5 - 0.15 * n) / at(given, "roughness"), 1.3, given);
}

/// [EurOtop2018, eq. 7.1]
double over_deep_wall(const FormulaValues& given, double n) {
    return overtopping(0.047 + 0.007 * n, 2.35 - 0.23 * n, 1.3, given);
}

/// [EurOtop2018, eq. 7.5]
double over_wall(const FormulaValues& given, double n) {
    return overtopping(0.05 + 0.012 * n, 2.78 - 0.17 * n, 1, given);
}

/// [EurOtop2018, eqs. 5.1, 5.2]: R_u2% = 1.65 gamma_f xi H, at most gamma_f (4 - 1.5/sqrt(xi)) H.
double run_up(const FormulaValues& given, double n) {
    const double xi = breaker(given, "energy_period"), rough = at(given, "roughness") * at(given, "height");
    return std::min((1.65 + 0.10 * n) * rough * xi, (1 + 0.07 * n) * rough * (4 - 1.5 / std::sqrt(xi)));
}

/// Stability number H_s/(Delta D_n50) of rock [VanDerMeer1988] times a power of the damage:
/// plunging 6.2 P^0.18 (S/sqrt N)^0.2 xi^-0.5, surging 1.0 P^-0.13 (S/sqrt N)^0.2 sqrt(cot alpha) xi^P from
/// xi = (6.2 P^0.31 sqrt(tan alpha))^(1/(P + 0.5)) on.
double rock_number(const FormulaValues& given, double n) {
    const double p = at(given, "permeability"), cot = at(given, "cot_slope"), xi = breaker(given, "mean_period");
    const double turn = std::pow(6.2 * std::pow(p, 0.31) / std::sqrt(cot), 1 / (p + 0.5));
    return xi < turn ? (6.2 - 0.4 * n) * std::pow(p, 0.18) / std::sqrt(xi)
                     : (1 - 0.08 * n) * std::pow(p, -0.13) * std::sqrt(cot) * std::pow(xi, p);
}

double rock_diameter(const FormulaValues& given, double n) {
    const double damage = std::pow(at(given, "damage") / std::sqrt(at(given, "waves")), 0.2);
    return at(given, "height") / (at(given, "relative_density") * rock_number(given, n) * damage);
}

double rock_damage(const FormulaValues& given, double n) {
    const double number = at(given, "height") / (at(given, "relative_density") * at(given, "diameter"));
    return std::pow(number / rock_number(given, n), 5) * std::sqrt(at(given, "waves"));
}

/// D_n50 = H/(Delta (K_D cot alpha)^(1/3)) [SPM1984, eq. 7-116]
double hudson(const FormulaValues& given, double) {
    return at(given, "height") /
           (at(given, "relative_density") * std::cbrt(at(given, "stability_coefficient") * at(given, "cot_slope")));
}

GodaPressure goda(const FormulaValues& given) {
    return goda_pressure({at(given, "highest"), at(given, "height"), at(given, "significant_period"),
                          at(given, "depth"), at(given, "depth_at_wall"), at(given, "wall_foot"), at(given, "crest"),
                          at(given, "foreshore_slope"), at(given, "angle_deg") * std::numbers::pi / 180,
                          at(given, "water_density")});
}
double goda_largest(const FormulaValues& given, double) { return goda(given).at_level; }
double goda_uplift(const FormulaValues& given, double) { return goda(given).uplift; }
double goda_force(const FormulaValues& given, double) { return goda(given).force; }

bool is_anywhere(const FormulaValues&) { return true; }
bool is_slope(const FormulaValues& given) {
    return at(given, "cot_slope") >= 2 && at(given, "freeboard") >= 0.5 * at(given, "height");
}
bool is_mound(const FormulaValues& given) { return at(given, "freeboard") >= 0.5 * at(given, "height"); }
bool is_run_up(const FormulaValues& given) {
    const double xi = breaker(given, "energy_period");
    return xi >= 0.5 && xi <= 4;
}
bool is_rock(const FormulaValues& given) {
    const double p = at(given, "permeability"), n = at(given, "waves"), cot = at(given, "cot_slope");
    return p >= 0.1 && p <= 0.6 && n <= 7500 && cot >= 1.5 && cot <= 6;
}

}  // namespace

std::span<const FormulaInput> formula_inputs() {
    static constexpr std::array inputs{
        FormulaInput{"height", "m", "significant height at the toe: H_m0, of van der Meer and Goda H_1/3"},
        FormulaInput{"highest", "m", "H_max, the mean of the highest 1/250 of the waves"},
        FormulaInput{"energy_period", "s", "T_m-1,0"},
        FormulaInput{"mean_period", "s", "T_m"},
        FormulaInput{"significant_period", "s", "T_1/3"},
        FormulaInput{"waves", "-", "number of waves"},
        FormulaInput{"depth", "m", "of still water at the structure"},
        FormulaInput{"water_density", "kg/m^3", ""},
        FormulaInput{"cot_slope", "-", "cotangent of the slope: 1.5 for 1 : 1.5"},
        FormulaInput{"freeboard", "m", "R_c, crest above still water"},
        FormulaInput{"roughness", "-", "gamma_f: 1 smooth, 0.40 two layers of rock on a permeable core"},
        FormulaInput{"permeability", "-", "P: 0.1 impermeable core, 0.4 breakwater, 0.6 no core"},
        FormulaInput{"diameter", "m", "D_n50 of the armour"},
        FormulaInput{"relative_density", "-", "Delta = density of the armour / that of water - 1"},
        FormulaInput{"damage", "-", "S_d that is allowed: 2 start, 8 to 17 failure"},
        FormulaInput{"stability_coefficient", "-", "K_D"},
        FormulaInput{"depth_at_wall", "m", "d, above the armour of the foundation"},
        FormulaInput{"wall_foot", "m", "h', foot of the wall below still water"},
        FormulaInput{"crest", "m", "h_c, top of the wall above still water"},
        FormulaInput{"foreshore_slope", "-", "tangent"},
        FormulaInput{"angle_deg", "deg", "between the waves and the normal of the wall, turned by 15 towards it"},
    };
    return inputs;
}

std::span<const Formula> formulas() {
    static const std::vector<std::string_view> sea_and_crest{"height", "freeboard"};
    static const std::vector<std::string_view> wall{
        "highest",   "height", "significant_period", "depth",     "depth_at_wall",
        "wall_foot", "crest",  "foreshore_slope",    "angle_deg", "water_density"};
    static const std::vector<Formula> list{
        {"overtopping of a slope",
         "q",
         "m^2/s",
         "EurOtop2018, eqs. 5.10, 5.11",
         "cot_slope from 2, R_c/H from 0.5",
         {"height", "energy_period", "cot_slope", "freeboard", "roughness"},
         &over_slope,
         &is_slope,
         true},
        {"overtopping of a rubble mound",
         "q",
         "m^2/s",
         "EurOtop2018, eq. 6.5",
         "R_c/H from 0.5; armour crest as high",
         {"height", "freeboard", "roughness"},
         &over_mound,
         &is_mound,
         true},
        {"overtopping of a wall in deep water", "q", "m^2/s", "EurOtop2018, eq. 7.1", "no foreshore", sea_and_crest,
         &over_deep_wall, &is_anywhere, true},
        {"overtopping of a wall, no impulsive waves", "q", "m^2/s", "EurOtop2018, eq. 7.5", "with a foreshore",
         sea_and_crest, &over_wall, &is_anywhere, true},
        {"run-up that 2 % exceed",
         "R_u2%",
         "m",
         "EurOtop2018, eqs. 5.1, 5.2",
         "xi from 0.5 to 4",
         {"height", "energy_period", "cot_slope", "roughness"},
         &run_up,
         &is_run_up,
         true},
        {"damage of rock",
         "S_d",
         "-",
         "VanDerMeer1988",
         "P 0.1 to 0.6, N to 7500, cot_slope 1.5 to 6",
         {"height", "mean_period", "cot_slope", "permeability", "waves", "relative_density", "diameter"},
         &rock_damage,
         &is_rock,
         true},
        {"rock for a damage",
         "D_n50",
         "m",
         "VanDerMeer1988",
         "P 0.1 to 0.6, N to 7500, cot_slope 1.5 to 6",
         {"height", "mean_period", "cot_slope", "permeability", "waves", "relative_density", "damage"},
         &rock_diameter,
         &is_rock,
         true},
        {"armour by Hudson",
         "D_n50",
         "m",
         "SPM1984, eq. 7-116",
         "no overtopping; no period, no number of waves",
         {"height", "relative_density", "stability_coefficient", "cot_slope"},
         &hudson,
         &is_anywhere,
         false},
        {"pressure on a wall at still water", "p_1", "Pa", "Goda2000, sec. 4.2", "no impulsive breaking", wall,
         &goda_largest, &is_anywhere, false},
        {"uplift at the front of a wall", "p_u", "Pa", "Goda2000, sec. 4.2", "no impulsive breaking", wall,
         &goda_uplift, &is_anywhere, false},
        {"force on a wall", "F", "N/m", "Goda2000, sec. 4.2", "no impulsive breaking", wall, &goda_force, &is_anywhere,
         false},
    };
    return list;
}

std::string_view lacks(const Formula& formula, const FormulaValues& given) {
    for (const std::string_view input : formula.inputs) {
        if (!given.contains(input)) {
            return input;
        }
    }
    return {};
}

Predicted predict(const Formula& formula, const FormulaValues& given) {
    constexpr double share = 1.645;  // deviations that 5 % of a normal distribution lie beyond
    if (!formula.has_band) {
        const double value = formula.answer(given, 0);
        return {value, value, value};
    }
    const double a = formula.answer(given, -share), b = formula.answer(given, share);
    return {formula.answer(given, 0), std::min(a, b), std::max(a, b)};
}

}  // namespace riprap::wave
