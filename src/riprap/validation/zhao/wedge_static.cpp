// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/wedge_scene.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double degree = M_PI / 180;

/// Table 8 of the source: rho 2600, k_n = 2e9 Pa, k_s/k_n = 0.06. @param groove  full opening angle [rad]
WedgeSetting table_8(double plunge, double left, double right, double friction) {
    return {.plunge = plunge,
            .left_angle = left,
            .right_angle = right,
            .density = 2600,
            .stiffness = 2e9,
            .shear_ratio = 0.06,
            .friction = friction};
}

struct WedgeSlide {
    double displacement{0};  ///< along l after 1 s [m]
    double error{0};         ///< largest |s - a t^2/2| over a 1^2/2 [-]
    double drift{0};         ///< largest motion off the line of intersection [m]
    double rotation{0};      ///< largest turn [rad]
    double acceleration{0};  ///< theory [m/s^2]
    std::vector<double> time, path;
};

WedgeSlide slide(const WedgeSetting& setting) {
    WedgeTrial wedge(setting);
    const Vec3 l = wedge.theory.along;
    WedgeSlide slide;
    slide.acceleration = wedge.theory.acceleration;
    wedge.trial.run_until(wedge.start + 1, [&](const Trial& now) {
        const double t = now.time() - wedge.start;
        const Vec3 moved = wedge.displacement();
        const double s = dot(moved, l);
        slide.error = std::max(slide.error, std::abs(s - 0.5 * slide.acceleration * t * t));
        slide.drift = std::max(slide.drift, norm(moved - s * l));
        slide.rotation = std::max(slide.rotation, wedge.rotation());
        slide.time.push_back(t);
        slide.path.push_back(s);
        slide.displacement = s;
    });
    slide.error /= 0.5 * slide.acceleration;
    return slide;
}

void judge(const std::string& name, const Published& paper, const WedgeSlide& slide, CaseReport& report) {
    report.judge({name + ", s(1 s)", "m", paper, 0.5 * slide.acceleration, {}}, slide.displacement, Relative{1e-3});
    report.judge_below({name + ", largest error of s over s(1 s)", "-", {}, {}, {}}, slide.error, 1e-3);
    report.judge_below({name + ", drift off the line of intersection", "m", {}, {}, {}}, slide.drift, 1e-6);
    report.judge_below({name + ", rotation", "rad", {}, {}, {}}, slide.rotation, 1e-6);
}

}  // namespace

void wedge_static(const CaseSetting& setting, CaseReport& report) {
    Plot plot;
    plot.title = "Wedge on two planes: displacement along the line of intersection";
    plot.subtitle = "frictionless; theory: s = g t^2 sin(theta)/2, whatever the shape of the wedge";
    plot.x.label = "time [s]";
    plot.y.label = "displacement [m]";
    int color = 0;
    for (const double plunge : {20.0, 30.0, 40.0}) {
        const WedgeSlide symmetric = slide(table_8(plunge * degree, 50 * degree, 50 * degree, 0));
        judge(fmt::format("theta = {}", plunge), std::string("agrees with s = g t^2 sin(theta)/2"), symmetric, report);
        std::vector<double> theory;
        for (const double t : symmetric.time) {
            theory.push_back(0.5 * symmetric.acceleration * t * t);
        }
        plot.curves.push_back(
            {fmt::format("theory, theta = {}", plunge), symmetric.time, theory, CurveStyle::line, color});
        plot.curves.push_back(
            {fmt::format("ours, theta = {}", plunge), symmetric.time, symmetric.path, CurveStyle::markers, color++});
    }
    judge("theta = 30, groove 35 + 65", {}, slide(table_8(30 * degree, 35 * degree, 65 * degree, 0)), report);

    // With friction the wedge tilts a little as it starts: only the displacement is compared.
    const WedgeSlide rough = slide(table_8(30 * degree, 50 * degree, 50 * degree, 0.2));
    report.judge({"theta = 30, mu = 0.2, s(1 s)", "m", {}, 0.5 * rough.acceleration, {}}, rough.displacement,
                 Relative{2e-3});
    const WedgeSlide uneven = slide(table_8(30 * degree, 35 * degree, 65 * degree, 0.2));
    report.judge({"theta = 30, groove 35 + 65, mu = 0.2, s(1 s)", "m", {}, 0.5 * uneven.acceleration, {}},
                 uneven.displacement, Relative{2e-3});
    write_plot(setting, "wedge_static", plot);
}

}  // namespace riprap::validation::zhao
