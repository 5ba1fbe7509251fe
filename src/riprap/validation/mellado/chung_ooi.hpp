// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

// Lines of the figures of [ChungOoi2011], read by others from its pages.

namespace riprap::validation::mellado::chung_ooi {

struct Line {
    double x, y;
};

/// Test 1, two spheres of glass that meet: overlap [um], force [kN].
constexpr std::array glass_curve{Line{29.05, 0.4503},  Line{54.76, 0.9681},  Line{73.81, 1.5084},  Line{94.29, 2.1839},
                                 Line{109.05, 2.7017}, Line{128.57, 3.4221}, Line{148.1, 4.2326},  Line{167.14, 5.0657},
                                 Line{186.19, 5.9662}, Line{200.95, 6.7092}, Line{217.14, 7.5197}, Line{231.9, 8.2852},
                                 Line{251.43, 9.3659}, Line{265.24, 10.1764}};

// Test 5: incident surface speed over mu v_n [-], then the rebound of the surface or the spin R omega, over mu v_n [-].

/// Finite elements of Wu, Thornton and Li.
constexpr std::array elements_rebound{
    Line{0.006, -0.0267},  Line{0.2719, -0.0267}, Line{0.5861, -0.0267}, Line{0.8761, -0.08},   Line{1.1903, -0.2133},
    Line{1.5529, -0.3733}, Line{1.9154, -0.6267}, Line{2.3142, -0.9467}, Line{2.7855, -1.2533}, Line{3.3172, -1.52},
    Line{3.9698, -1.72},   Line{4.7553, -1.7067}, Line{5.7583, -1.2},    Line{7.1239, 0.1333},  Line{9.1178, 2.1467},
    Line{12.3565, 5.4267}, Line{12.9607, 6.0133}};
constexpr std::array elements_spin{
    Line{0.0058, 0.0},      Line{0.3179, -0.1866}, Line{0.5954, -0.4056}, Line{0.8902, -0.6653}, Line{1.185, -0.9818},
    Line{1.5318, -1.3551},  Line{1.896, -1.7933},  Line{2.2775, -2.3208}, Line{2.763, -2.8564},  Line{3.3006, -3.4407},
    Line{3.8902, -4.0412},  Line{4.6879, -4.5685}, Line{5.659, -4.9415},  Line{7.0289, -4.9407}, Line{9.0405, -4.9721},
    Line{12.3353, -4.9703}, Line{18.8035, -4.9749}};
/// Theory of Thornton.
constexpr std::array theory_spin{
    Line{0.2838, -0.0761}, Line{0.977, -0.4789},  Line{1.8064, -1.5144}, Line{2.748, -2.7243}, Line{3.6769, -3.7705},
    Line{4.7073, -4.6203}, Line{5.7562, -5.0119}, Line{7.0082, -4.9887}, Line{8.4162, -5.009}, Line{9.9668, -4.9964}};
/// Springs of the paper's own codes.
constexpr std::array steel_rebound{
    Line{0.0665, -0.08},   Line{0.3323, -0.28}, Line{0.6707, -0.4933}, Line{1.0091, -0.7467}, Line{1.3353, -1.0},
    Line{1.6616, -1.2667}, Line{2.0, -1.5333},  Line{2.3505, -1.8133}, Line{2.9909, -2.44},   Line{3.3414, -2.6933},
    Line{4.006, -2.7867},  Line{4.997, -2.0},   Line{6.0, -1.0133},    Line{9.9879, 3.0133},  Line{12.9607, 6.0133}};
constexpr std::array steel_spin{
    Line{0.0578, -0.1055}, Line{0.3526, -0.4301}, Line{0.6821, -0.8197}, Line{0.9942, -1.2498},  Line{1.341, -1.6637},
    Line{1.6879, -2.0938}, Line{2.0, -2.524},     Line{2.3295, -2.9784}, Line{2.9884, -3.9037},  Line{3.3179, -4.2932},
    Line{3.9942, -4.8368}, Line{5.0, -5.0068},    Line{6.0058, -5.0062}, Line{10.0116, -5.0041}, Line{20.0, -4.9905}};
constexpr std::array polyethylene_rebound{
    Line{0.0785, -0.08},  Line{0.3444, -0.2933}, Line{0.6707, -0.5733}, Line{0.997, -0.88},  Line{1.3474, -1.12},
    Line{1.6737, -1.44},  Line{2.0121, -1.76},   Line{2.3263, -2.0533}, Line{2.9909, -2.68}, Line{3.3414, -2.9467},
    Line{3.994, -2.9333}, Line{4.997, -2.0},     Line{5.9879, -1.0},    Line{10.0, 3.0},     Line{12.9607, 6.0133}};
constexpr std::array polyethylene_spin{
    Line{0.0751, -0.0974}, Line{0.3526, -0.4382}, Line{0.6821, -0.9009}, Line{0.9942, -1.331},  Line{1.341, -1.7611},
    Line{1.6879, -2.2156}, Line{2.0173, -2.6701}, Line{2.3468, -3.1165}, Line{3.0231, -4.0498}, Line{3.3353, -4.4556},
    Line{4.0116, -4.9342}, Line{5.0, -4.9662},    Line{6.0058, -4.9575}, Line{9.9942, -4.9635}, Line{20.0, -4.9418}};

}  // namespace riprap::validation::mellado::chung_ooi
