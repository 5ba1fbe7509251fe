// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "riprap/scene/text/units.hpp"

namespace riprap::scene {
namespace {

double read(std::string_view text, const Dimension& dimension) {
    const Quantity quantity = parse_quantity(text, dimension);
    EXPECT_EQ(quantity.problem, "") << text;
    return quantity.value;
}

std::string problem(std::string_view text, const Dimension& dimension) {
    return parse_quantity(text, dimension).problem;
}

TEST(Units, decimal_units_give_the_same_bits_as_the_number_written_in_si) {
    EXPECT_EQ(read("2.5 cm", dimension::length), 2.5e-2);
    EXPECT_EQ(read("0.7 mm", dimension::length), 0.7e-3);
    EXPECT_EQ(read("0.1mm", dimension::length), 0.1e-3);
    EXPECT_EQ(read("1.1 km", dimension::length), 1.1e3);
    EXPECT_EQ(read("0.4 MPa", dimension::pressure), 0.4e6);
    EXPECT_EQ(read("2.7 GPa", dimension::pressure), 2.7e9);
    EXPECT_EQ(read("3e2 us", dimension::time), 3e-4);
    EXPECT_EQ(read("2.65 t/m^3", dimension::density), 2650.0);
    EXPECT_EQ(read("2.65 g/cm^3", dimension::density), 2650.0);
    EXPECT_EQ(read("35 %", dimension::plain), 0.35);
}

TEST(Units, a_bare_number_is_si) {
    EXPECT_EQ(read("9.81", dimension::acceleration), 9.81);
    EXPECT_EQ(read("+2", dimension::length), 2.0);
    EXPECT_EQ(read(" -3.5e-2 ", dimension::length), -0.035);
}

TEST(Units, products_quotients_and_powers_combine) {
    EXPECT_EQ(read("9.81 m/s^2", dimension::acceleration), 9.81);
    EXPECT_EQ(read("9.81 m s^-2", dimension::acceleration), 9.81);
    EXPECT_EQ(read("1.2 kN/m", dimension::stiffness), 1.2e3);
    EXPECT_EQ(read("4 N/mm^2", dimension::pressure), 4e6);
    EXPECT_EQ(read("5 1/s", dimension::frequency), 5.0);
    EXPECT_EQ(read("5 Hz", dimension::frequency), 5.0);
    EXPECT_DOUBLE_EQ(read("36 km/h", dimension::velocity), 10.0);
    EXPECT_EQ(read("2 min", dimension::time), 120.0);
}

TEST(Units, angles_are_a_dimension_of_their_own) {
    EXPECT_DOUBLE_EQ(read("180 deg", dimension::angle), std::numbers::pi);
    EXPECT_DOUBLE_EQ(read("0.5 rev", dimension::angle), std::numbers::pi);
    EXPECT_DOUBLE_EQ(read("60 rpm", dimension::angular_velocity), 2 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(read("90 deg/s", dimension::angular_velocity), std::numbers::pi / 2);
    EXPECT_EQ(problem("26 deg", dimension::plain), "'deg' is an angle, not a plain number");
}

TEST(Units, a_wrong_dimension_is_named_in_words) {
    EXPECT_EQ(problem("3 m", dimension::time), "'m' is a length, not a time");
    EXPECT_EQ(problem("3 kg", dimension::density), "'kg' is a mass, not a density");
    EXPECT_EQ(problem("1 kN/m", dimension::pressure), "'kN/m' is a stiffness, not a pressure");
}

TEST(Units, what_is_no_unit_or_no_number_is_refused) {
    EXPECT_EQ(problem("3 furlong", dimension::length), "'furlong' is not a unit Riprap knows");
    for (const char* text : {"9.81 m/s2", "3 m^", "3 m^0", "3 m^99", "3 m//s", "3 *m", "3 1", "3 m/", "3 m^2x"}) {
        EXPECT_NE(problem(text, dimension::length), "") << text;
    }
    for (const char* text : {"", "m", "nan m", "inf", "--3 m", "0x10 m", "1e999 m"}) {
        EXPECT_NE(problem(text, dimension::length), "") << text;
    }
}

TEST(Units, keys_may_end_in_a_unit) {
    const auto angle = split_unit_suffix("friction_angle_deg");
    ASSERT_TRUE(angle);
    EXPECT_EQ(angle->base, "friction_angle");
    EXPECT_EQ(angle->unit.dimension, dimension::angle);
    const auto spacing = split_unit_suffix("spacing_mm");
    ASSERT_TRUE(spacing);
    EXPECT_EQ(to_si(0.7, spacing->unit), 0.7e-3);
    EXPECT_FALSE(split_unit_suffix("max_steps"));
    EXPECT_FALSE(split_unit_suffix("mm"));
    EXPECT_FALSE(split_unit_suffix("_mm"));
}

TEST(Units, every_dimension_has_a_unit_that_reads_back) {
    for (const Dimension& d : {dimension::length, dimension::area, dimension::time, dimension::velocity,
                               dimension::acceleration, dimension::angular_velocity, dimension::density,
                               dimension::pressure, dimension::stiffness, Dimension{3, -1, 2, 1}}) {
        const auto unit = parse_unit(si_unit(d));
        ASSERT_TRUE(unit) << si_unit(d);
        EXPECT_EQ(unit->dimension, d);
        EXPECT_EQ(unit->decimal, 0);
        EXPECT_EQ(unit->factor, 1);
    }
}

}  // namespace
}  // namespace riprap::scene
