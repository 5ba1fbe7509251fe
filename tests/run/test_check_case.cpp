// SPDX-License-Identifier: Apache-2.0
// What `riprap check` says of a case with water.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/check_case.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;

/// A tank half a metre wide with 0.205 m of water at a spacing of 1 cm: half a row stays empty.
const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
[fluid]
spacing = 0.01
domain = { low = [0.0, -0.1], high = [0.5, 0.5], periodic = [true, false] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.5, 0.205] }
)";

CaseCheck check_of(const std::string& text) {
    return check_case(scene::read_case_text(text, "case.toml", "/nonexistent", {}));
}

TEST(CheckCase, volume_that_stays_empty_has_a_unit) {
    const CaseCheck check = check_of(tank);
    EXPECT_NEAR(check.trimmed_volume, 0.5 * 0.005, 1e-12);
    EXPECT_THAT(check_text(check), HasSubstr("100 kg/m, "));
    EXPECT_THAT(check_text(check), HasSubstr("0.0025 m^2 of its regions hold none"));
}

}  // namespace
}  // namespace riprap::run
