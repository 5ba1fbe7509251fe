// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/ding/cases_3d.hpp"

namespace riprap::validation::ding {

namespace {

constexpr double gravity = 9.81, water = 1000, dip = 16.1 * M_PI / 180, friction = 30 * M_PI / 180;
constexpr double width = 2.5, weight = 2500 * gravity * 2.5 * 5;  ///< [m], [N/m]

/// Water in the crack [N/m], its pressure p0 + rho g x tan(dip) at x from the upstream end, times 1, 1 - x/B or 0.
double uplift_force(const std::string& kind, double h) {
    const double deepening = width * std::tan(dip), length = width / std::cos(dip);
    return kind == "none"     ? 0
           : kind == "linear" ? water * gravity * length * (h / 2 + deepening / 6)
                              : water * gravity * length * (h + deepening / 2);
}

/// Level above the upstream end of the crack at which driving force and strength are equal [m]:
/// H (cos + sin tan phi) + U tan phi = W (cos tan phi - sin) + c L, H = rho g h^2/2, with L the length of the crack.
double limit_level(const std::string& kind, double cohesion) {
    const double c = std::cos(dip), s = std::sin(dip), t = std::tan(friction), bonded = width / c;
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
        const double h = 0.5 * (low + high), thrust = 0.5 * water * gravity * h * h;
        const bool slides = thrust * (c + s * t) + uplift_force(kind, h) * t > weight * (c * t - s) + cohesion * bonded;
        (slides ? high : low) = h;
    }
    return low;
}

/// Level at which the top has gone a millimetre [m]. It comes to rest under its weight, as springs that are loaded at
/// once swing and let it slip; the water then rises to 6 % below the limit in 4 s, and slowly from there.
double level_of_failure(const CaseSetting& setting, const std::string& method, const std::string& kind,
                        double cohesion) {
    const double limit = limit_level(kind, cohesion), start = 10 + 0.94 * limit, rate = 0.02, settled = 2, slow = 6;
    Trial trial = trial_of(
        setting,
        std::array<std::string, 4>{fmt::format("solid.method=\"{}\"", method), fmt::format("fluid.uplift=\"{}\"", kind),
                                   fmt::format("material.concrete.cohesion={}", cohesion),
                                   fmt::format("fluid.levels=[[0.0,10.0],[{},10.0],[{},{}],[{},{}]]", settled, slow,
                                               start, slow + 100, start + 100 * rate)});
    const BodyId top = trial.body("top");
    trial.run_until(settled);
    const Vec3 before = trial.position(top);
    const double end = slow + 0.12 * limit / rate;
    double level = std::nan("");
    trial.run_until(end, [&](const Trial& now) {
        const double moved = norm(now.position(top) - before);
        if (std::isnan(level) && moved > 1e-3) {
            const double risen = (now.time() - settled) / (slow - settled);
            level = now.time() < slow ? risen * (start - 10) : start - 10 + rate * (now.time() - slow);
        }
    });
    return level;
}

}  // namespace

void dam_uplift(const CaseSetting& setting, CaseReport& report) {
    struct Row {
        const char *method, *kind;
        double cohesion;
    };
    for (const Row& row :
         {Row{"planar_dda", "none", 0}, Row{"planar_dda", "linear", 0}, Row{"planar_dda", "full", 0},
          Row{"planar_dda", "none", 5e3}, Row{"implicit_dda", "none", 0}, Row{"implicit_dda", "linear", 0}}) {
        report.judge({fmt::format("{}, uplift {}, c = {:.0f} kPa: level at which the top has slid 1 mm", row.method,
                                  row.kind, row.cohesion / 1e3),
                      "m",
                      {},
                      // The upstream corner carries half of the shear and 28 % of the push: its bond slides first,
                      // and keeps its cohesion while the other takes over.
                      limit_level(row.kind, row.cohesion),
                      "H (cos + sin tan phi) + U tan phi = W (cos tan phi - sin) + c L"},
                     level_of_failure(setting, row.method, row.kind, row.cohesion), Relative{0.01});
    }
}

}  // namespace riprap::validation::ding
