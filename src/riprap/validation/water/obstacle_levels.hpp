// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace riprap::validation::water {

/// Heights of water [m] every half second from 0.5 to 6 s in a dam break against a box [Kleefsman2005], and when water
/// first passes 1 cm there.
struct ObstacleLevels {
    const char* gauge;  ///< "level_" and its place behind the far wall [mm]
    double place;       ///< [m]
    bool is_named;      ///< by the data's own measure, 3 % of the depth
    double arrival;     ///< [s]; 0 in the reservoir
    std::array<double, 12> height;
};
inline constexpr std::array<ObstacleLevels, 4> obstacle_levels{{
    {"level_2638",
     2.638,
     true,
     0,
     {{0.426, 0.279, 0.182, 0.130, 0.104, 0.202, 0.197, 0.332, 0.260, 0.233, 0.218, 0.186}}},
    {"level_1488",
     1.488,
     false,
     0.194,
     {{0.095, 0.155, 0.145, 0.142, 0.270, 0.238, 0.187, 0.174, 0.271, 0.205, 0.219, 0.185}}},
    {"level_992",
     0.992,
     true,
     0.358,
     {{0.099, 0.179, 0.236, 0.287, 0.281, 0.203, 0.202, 0.136, 0.145, 0.252, 0.219, 0.214}}},
    {"level_496",
     0.496,
     false,
     0.918,
     {{0.001, 0.151, 0.346, 0.289, 0.324, 0.229, 0.209, 0.162, 0.153, 0.170, 0.188, 0.308}}},
}};

}  // namespace riprap::validation::water
