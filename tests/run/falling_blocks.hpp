// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/scene/read_case.hpp"

namespace riprap {

/// Blocks that fall on a floor and on each other: contacts are made and lost, friction has history.
inline std::string falling_blocks_text() {
    return R"(
title   = "Blocks fall on a floor"
gravity = [0, 0, -9.81]
end     = 0.5

[material.rock]
density          = 2500.0
normal_stiffness = "20 MPa"
friction_angle   = "30 deg"

[[body]]
name     = "floor"
shape    = { half_space = { normal = [0, 0, 1] } }
material = "rock"
fixed    = true

[[body]]
name     = "low"
shape    = { box = [1.0, 1.0, 0.5] }
position = [0, 0, 0.26]
material = "rock"

[[body]]
name     = "high"
shape    = { box = [0.6, 0.7, 0.5] }
position = [0.3, 0.1, 0.79]
velocity = [0.5, 0, -1]
material = "rock"

[[body]]
name     = "lone"
shape    = { box = [0.5, 0.5, 0.5] }
position = [-2, 0, 0.3]
velocity = [1, 0, 0]
angular_velocity = [0, 3, 1]
material = "rock"

[[output.probe]]
body     = "high"
quantity = "displacement"

[[output.probe]]
body     = "low"
quantity = "contact_force"
)";
}

inline scene::LoadedCase falling_blocks(const std::vector<std::string>& overrides = {}) {
    return scene::read_case_text(falling_blocks_text(), "case.toml", ".", overrides);
}

}  // namespace riprap
