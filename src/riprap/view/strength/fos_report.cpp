// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/strength/fos_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv.hpp"
#include "riprap/view/plot_svg.hpp"
#include "riprap/view/sweep_page.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const BodyVerdict& body) {
    return {{"name", body.name},
            {"mode", body.mode},
            {"fails", body.fails},
            {"why", body.why},
            {"size", body.size},
            {"moved", body.moved},
            {"crept", body.crept},
            {"first_speed", body.first_speed},
            {"last_speed", body.last_speed},
            {"way", {body.way.x, body.way.y, body.way.z}},
            {"turned", body.turned}};
}

Json json_of(const FosReport& report) {
    Json json{{"factor", report.is_found() ? Json(report.factor()) : Json(nullptr)},
              {"stands", report.stood > 0 ? Json(report.stood) : Json(nullptr)},
              {"fails", report.failed > 0 ? Json(report.failed) : Json(nullptr)},
              {"contradictions", report.contradictions},
              {"between", {report.range.low, report.range.high}},
              {"tolerance", report.range.tolerance},
              {"reduces", report.reduces},
              {"begins", report.times.begins},
              {"over", report.times.over},
              {"hold", report.times.hold},
              {"creep", report.criteria.creep},
              {"displaced", report.criteria.displaced}};
    json["mode"] = Json::array();
    if (const TrialVerdict* trial = report.failing()) {
        for (const BodyVerdict& body : trial->bodies) {
            json["mode"].push_back(json_of(body));
        }
    }
    return json;
}

/// Tells the page of a trial as answers with verdicts.
Json answers_of(const TrialVerdict& trial) {
    double moved = 0, crept = 0;
    for (const BodyVerdict& body : trial.bodies) {
        moved = std::max(moved, body.moved);
        crept = std::max(crept, body.crept);
    }
    const char* verdict = trial.stands ? "passed" : "failed";
    return Json::array(
        {{{"name", "largest movement over size"}, {"unit", "-"}, {"value", moved}, {"verdict", verdict}},
         {{"name", "creep in the hold over size"}, {"unit", "-"}, {"value", crept}, {"verdict", verdict}}});
}

std::string bodies_csv(const TrialVerdict* trial) {
    std::string text = "name,mode,size [m],moved [size],crept [size],way.x [m],way.y [m],way.z [m],turned [deg]\n";
    if (trial == nullptr) {
        return text;
    }
    for (const BodyVerdict& body : trial->bodies) {
        const std::vector<double> row{body.size,
                                      body.moved,
                                      body.crept,
                                      body.way.x,
                                      body.way.y,
                                      body.way.z,
                                      body.turned * 180 / std::numbers::pi};
        text += fmt::format("\"{}\",{},{}\n", body.name, body.mode, io::csv_row(row));
    }
    return text;
}

/// Movement of the body that moves farthest over time, for the trials nearest to the answer.
Plot plot_of(const FosReport& report) {
    Plot plot;
    plot.title = headline(report);
    plot.subtitle =
        fmt::format("strength falls from {:.4g} to {:.4g} s and is held", report.times.begins, report.times.ramp_end());
    plot.x.label = "time [s]";
    plot.y.label = "largest movement over size [-]";
    plot.y.is_log = true;
    std::vector<const TrialVerdict*> nearest;
    for (const TrialVerdict& trial : report.trials) {
        nearest.push_back(&trial);
    }
    const double middle = report.is_found() ? report.factor() : std::max(report.stood, report.failed);
    std::ranges::stable_sort(nearest, [middle](const TrialVerdict* a, const TrialVerdict* b) {
        return std::abs(a->factor - middle) < std::abs(b->factor - middle);
    });
    nearest.resize(std::min(nearest.size(), color_count));
    std::ranges::sort(nearest, {}, [](const TrialVerdict* trial) { return trial->factor; });
    for (const TrialVerdict* trial : nearest) {
        Curve curve{fmt::format("F = {:.5g} {}", trial->factor, trial->stands ? "stands" : "fails"),
                    trial->time,
                    {},
                    trial->stands ? CurveStyle::line : CurveStyle::dashed};
        for (const double moved : trial->moved) {  // nothing at first, which a log scale does not show
            curve.y.push_back(moved > 0 ? std::max(moved, 1e-9) : std::numeric_limits<double>::quiet_NaN());
        }
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

}  // namespace

std::filesystem::path write_fos(const run::SweepOptions& study, const FosReport& report) {
    Json json = Json::parse(run::sweep_json(study));
    json["title"] = headline(report);
    json["factor_of_safety"] = json_of(report);
    for (std::size_t i = 0; i < study.points.size(); ++i) {
        json["runs"][i]["answers"] = answers_of(report.trials[i]);
        json["runs"][i]["reason"] = report.trials[i].why;
    }
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
    io::write_file(study.out / "fos.json", text);
    io::write_file(study.out / "fos.csv", run::sweep_csv(text));
    io::write_file(study.out / "fos_bodies.csv", bodies_csv(report.failing()));
    if (!report.trials.empty()) {
        write_svg(study.out / "fos.svg", plot_of(report));
    }
    return write_fos_page(study.out);
}

}  // namespace riprap::view
