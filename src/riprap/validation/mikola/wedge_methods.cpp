// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/mikola/cases.hpp"
#include "riprap/validation/mikola/water_run.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mikola {

namespace {

constexpr double angle = 25 * M_PI / 180;

/// The wedge after its slide, by one solid method.
struct Slide {
    Curve way;          ///< along the slope [m]
    double speed{0};    ///< at the end [m/s]
    double surface{0};  ///< at x = 6 m, highest so far [m]
    WaterRecords records;
};

Slide slide_by(const CaseSetting& setting, std::string_view method) {
    CaseSetting with = setting;
    with.folder = setting.folder.parent_path() / "sliding_wedge";
    Trial trial =
        trial_of(with, std::array<std::string, 3>{fmt::format("solid.method=\"{}\"", method),
                                                  "material.rock.friction_coefficient=0.2",
                                                  fmt::format("fluid.spacing={}", setting.is_full ? 0.02 : 0.05)});
    Slide slide;
    slide.way = {std::string(method), {}, {}, CurveStyle::line, -1};
    const auto wedge = trial.body("wedge");
    const Vec3 start = trial.position(wedge), down{std::cos(angle), -std::sin(angle), 0};
    run_water(trial, slide.records, setting.is_full ? 1.5 : 0.8, 0.02, [&](const Trial& now) {
        slide.way.x.push_back(now.time());
        slide.way.y.push_back(dot(now.position(wedge) - start, down));
    });
    slide.speed = norm(trial.state().bodies.velocity[static_cast<std::size_t>(wedge.value)]);
    return slide;
}

}  // namespace

void wedge_methods(const CaseSetting& setting, CaseReport& report) {
    Plot plot;
    plot.title = "The wedge into water, by one word each";
    plot.x.label = "time [s]";
    plot.y.label = "way along the slope [m]";
    Slide rigid;
    for (const std::string_view method : {"distance_potential_dem", "explicit_dda", "implicit_dda", "planar_dda"}) {
        Slide slide = slide_by(setting, method);
        if (plot.curves.empty()) {
            report.state({fmt::format("{}: way at {:.2f} s", method, slide.way.x.back()), "m", {}}, slide.way.y.back());
            report.state({fmt::format("{}: speed then", method), "m/s", {}}, slide.speed);
            rigid = slide;
        } else {
            // Records may end a row apart, as steps of the methods differ: the last time that both have counts.
            const double time = std::min(slide.way.x.back(), rigid.way.x.back());
            const auto way_at = [time](const Slide& of) { return water::interpolated(of.way.x, of.way.y, time); };
            // Strains of 1e-6 do not change the displacement; differences are noise of water that moves with the wedge.
            report.judge({fmt::format("{}: way, against rigid polyhedra", method), "m", {}, way_at(rigid), {}},
                         way_at(slide), Relative{0.02});
            report.judge({fmt::format("{}: speed, against rigid polyhedra", method), "m/s", {}, rigid.speed, {}},
                         slide.speed, Relative{0.03});
        }
        judge_ledgers(report, std::string(method), slide.records);
        plot.curves.push_back(slide.way);
    }
    write_plot(setting, "wedge_methods", plot);
}

}  // namespace riprap::validation::mikola
