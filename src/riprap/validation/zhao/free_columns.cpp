// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/tilt.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double friction = 0.4877;

/// A stack of equal blocks by itself, as the slopes are built of.
struct Column {
    const char* name;
    double width, height;  ///< of a block, downhill and upright [m]
    int layers;
    bool is_long;
    bool topples() const { return width / (layers * height) < friction; }
    /// tan(alpha) = b/(n h), or the friction angle where that is less [deg]
    double limit() const { return std::atan(std::min(friction, width / (layers * height))) / degree; }
};

constexpr std::array columns{
    Column{"5 cubes", 0.1, 0.1, 5, false},
    Column{"5 large blocks", 0.2, 0.1, 5, false},
    Column{"4 cubes", 0.1, 0.1, 4, true},
    Column{"6 cubes", 0.1, 0.1, 6, true},
    Column{"6 large blocks", 0.2, 0.1, 6, true},
    Column{"4 large blocks", 0.2, 0.1, 4, true},
    Column{"10 small blocks", 0.05, 0.05, 10, true},
};

std::vector<std::string> overrides_of(const Column& c, double stiffness) {
    return {fmt::format("body.block.shape.box=[{}, 0.1, {}]", c.width, c.height),
            fmt::format("body.block.position=[0.0, 0.0, {}]", 0.5 * c.height),
            fmt::format("body.block.repeat.counts=[1, 1, {}]", c.layers),
            fmt::format("body.block.repeat.pitch=[{}, 0.1, {}]", c.width, c.height),
            fmt::format("material.rock.normal_stiffness={}", stiffness)};
}

/// Angle at which the top cube of a column has moved by failure_slip over the platform, while it turns or gravity does
/// [deg].
double angle_of_fall(Trial trial, bool platform_turns) {
    constexpr double rate = 0.03, start = 0.5;
    const BodyId top = trial.body("block[4]");
    const Vec3 axis{0, 1, 0};
    double fallen = std::nan("");
    trial.follow_energy(false);
    trial.run_until(start);
    const Vec3 at_rest = trial.position(top);
    trial.run_until(8, [&](const Trial& now) {
        const double angle = rate * (now.time() - start);
        const Vec3 x = platform_turns ? rotate(conjugate(turn(axis, angle)), now.position(top)) : now.position(top);
        if (std::isnan(fallen) && norm(x - at_rest) > failure_slip) {
            fallen = angle / degree;
        }
    });
    return fallen;
}

}  // namespace

void free_columns(const CaseSetting& setting, CaseReport& report) {
    CaseSetting quiet = setting;  // the frames of the slopes show the same
    quiet.results.clear();
    quiet.is_full = false;
    for (const Column& column : columns) {
        if (column.is_long && !setting.is_full) {
            continue;
        }
        const double limit = column.limit();
        const Failures failures =
            tilt_until_failure(quiet, trial_of(setting, overrides_of(column, 50e9)), std::max(0.0, limit - 4));
        report.judge({fmt::format("{}, failure angle, held at every 0.1 deg", column.name), "deg", {}, limit, {}},
                     failures.held.collapsed ? failures.held.angle : std::nan(""), limit - 0.2, limit + 0.2);
        report.judge({fmt::format("{}, share of the moving mass that topples", column.name),
                      "-",
                      column.topples() ? "toppling" : "sliding",
                      {},
                      {}},
                     failures.turned.collapsed ? failures.turned.toppling_share : std::nan(""),
                     column.topples() ? 0.5 : 0.0, column.topples() ? 1.0 : 0.5);
    }
    const Failures soft = tilt_until_failure(quiet, trial_of(setting), columns[0].limit() - 4);
    report.judge({"5 cubes of 2 GPa, failure angle, held at every 0.1 deg",
                  "deg",
                  {},
                  columns[0].limit(),
                  "soft joints let the column lean: low by an amount that falls with k_n^(-1/3)"},
                 soft.held.collapsed ? soft.held.angle : std::nan(""), columns[0].limit() - 0.2,
                 columns[0].limit() + 0.2);
    const std::array turned_platform{
        std::string("gravity.rotation.rate=0"), std::string("body.platform.fixed=false"),
        std::string("body.platform.motion={ rotation = { center = [0.0, 0.0, 0.0], axis = [0.0, 1.0, 0.0], rate = 0.03 "
                    "}, start = 0.5 }")};
    const double by_gravity = angle_of_fall(trial_of(setting), false);
    const double by_platform = angle_of_fall(trial_of(setting, turned_platform), true);
    report.judge({"5 cubes of 2 GPa, angle at 1 mm, platform turned less gravity turned",
                  "deg",
                  {},
                  0.0,
                  "centrifugal terms are w^2 R/g = 5e-5 of the weight"},
                 by_platform - by_gravity, -0.05, 0.05);
}

}  // namespace riprap::validation::zhao
