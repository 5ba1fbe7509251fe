// SPDX-License-Identifier: Apache-2.0
// Water through stones: exact drops of pressure, Dupuit's flow, and the dam break of [Lin1998].
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "riprap/fluid/grid/porous.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

namespace {

/// Surface in the tank at x = 0.05, 0.15, ..., 0.85 m, read off the photographs of [Lin1998].
struct Profile {
    double time;
    std::array<double, 9> y;
};
constexpr std::array<Profile, 5> profiles{
    {{0.35, {0.2716, 0.2717, 0.2922, 0.2691, 0.1463, 0.0695, 0.0240, 0.0206, 0.0216}},
     {0.75, {0.2620, 0.2428, 0.2406, 0.2455, 0.2019, 0.1278, 0.0178, 0.0360, 0.0273}},
     {1.15, {0.2227, 0.2260, 0.2348, 0.2293, 0.1955, 0.1384, 0.0242, 0.0465, 0.0656}},
     {1.55, {0.2151, 0.2168, 0.2134, 0.2087, 0.1897, 0.1404, 0.0588, 0.0748, 0.0733}},
     {1.95, {0.2059, 0.1991, 0.1953, 0.2059, 0.1825, 0.1305, 0.0913, 0.0842, 0.0913}}}};

/// Edges from low to high that grow from `first` by a constant ratio, or shrink towards high for is_reversed.
void add_stretched(std::vector<double>& edges, double high, double first, double ratio, bool is_reversed) {
    const double low = edges.back(), length = high - low;
    std::vector<double> widths;
    double sum = 0;
    for (double w = first; sum < length; w *= ratio) {
        widths.push_back(w);
        sum += w;
    }
    double place = low;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        place += (is_reversed ? widths[widths.size() - 1 - i] : widths[i]) * length / sum;
        edges.push_back(i + 1 == widths.size() ? high : place);
    }
}

}  // namespace

void filter(const CaseSetting& setting, CaseReport& report) {
    (void)setting;
    for (const PorousClosure closure : {PorousClosure::ding, PorousClosure::van_gent, PorousClosure::engelund}) {
        GridSettings settings = make_tank({}, {1, 0.1, 0.1}, {20, 2, 1});
        settings.has_surface = false;
        settings.gravity = {};
        PorousMedium stones{0.45, 0.02};
        stones.closure = closure;
        settings.porous.push_back({stones, [](const Vec3& x) { return x.x > 0.3 && x.x < 0.7; }});
        settings.side[0].kind = SideKind::inflow;
        settings.side[0].inflow = [](const Vec3&, double) { return Inflow{{0.1, 0, 0}, 1}; };
        settings.side[1].kind = SideKind::open;
        settings.longest_step = 0.02;
        GridTrial trial(settings, make_state(
                                      settings, [](const Vec3&) { return 1.0; },
                                      [](const Vec3&) {
                                          return Vec3{0.1, 0, 0};
                                      }));
        trial.run(10);
        const auto p = [&](int i) { return trial.state().pressure[at(settings.mesh.box.index(i, 0, 0))]; };
        const Resistance r = resistance_of(stones);
        const double exact = r.linear * 1e-3 * 0.1 + r.quadratic * 1000 * 0.01;
        const char* name = closure == PorousClosure::ding       ? "ding"
                           : closure == PorousClosure::van_gent ? "van_gent"
                                                                : "engelund";
        report.judge({fmt::format("drop of pressure inside stones, closure {}", name), "Pa/m", {}, exact, {}},
                     (p(8) - p(12)) / 0.2, Relative{1e-6});
    }
}

void dupuit(const CaseSetting& setting, CaseReport& report) {
    // Reservoirs 10 m long on both sides of 1 m of stones, resistance linear: q = K (h_1^2 - h_2^2)/(2 L) [Bear1972].
    std::vector<double> x{-10};
    const double h = setting.is_full ? 0.01 : 0.02;
    add_stretched(x, 0, h, 1.15, true);
    for (int i = 1; i <= static_cast<int>(std::lround(1 / h)); ++i) {
        x.push_back(i * h);
    }
    add_stretched(x, 11, h, 1.15, false);
    GridSettings settings;
    settings.mesh = Mesh({x, uniform_edges(0, 0.8, static_cast<int>(std::lround(0.8 / h))), {0, 0.1}}, 2);
    settings.side[3].kind = SideKind::open;
    const PorousMedium stones{0.4, 0.002, 50, 0};
    settings.porous.push_back({stones, [](const Vec3& p) { return p.x > 0 && p.x < 1; }});
    const double conductivity = 9.81 / (resistance_of(stones).linear * 1e-6);
    GridTrial trial(settings, make_state(settings, [](const Vec3& p) {
                        return p.y < (p.x < 0 ? 0.6 : p.x > 1 ? 0.3 : 0.6 - 0.3 * p.x);
                    }));
    trial.add("left", [](const GridTrial& t) { return read_level(t.settings(), t.state(), {-5, 0, 0}, 1); });
    trial.add("right", [](const GridTrial& t) { return read_level(t.settings(), t.state(), {6, 0, 0}, 1); });
    trial.add("in", [&](const GridTrial& t) { return t.flow_at(0.5 * h); });
    trial.add("out", [&](const GridTrial& t) { return t.flow_at(1 - 0.5 * h); });
    const double end = 20;
    trial.run(end);
    const auto mean = [&](const char* name) { return mean_over(trial.time(), trial.column(name), 0.5 * end, end); };
    const double h1 = mean("left"), h2 = mean("right"), exact = conductivity * (h1 * h1 - h2 * h2) / 2;
    report.judge({"flow through the stones per metre, mean of in and out",
                  "m^2/s",
                  {},
                  exact,
                  "of the levels at the time, last half of the run"},
                 0.5 * (mean("in") + mean("out")), Relative{0.02});
    report.state({"conductivity K of the stones", "m/s"}, conductivity);
    trial.report_books(report);
}

void porous_dam_break(const CaseSetting& setting, CaseReport& report) {
    const int scale = setting.is_full ? 2 : 1;
    GridSettings settings = make_tank({}, {0.89, 0.58, 0.01}, {89 * scale, 58 * scale, 1});
    settings.side[3].kind = SideKind::open;
    settings.air = {1, 1.48e-5};
    settings.porous.push_back({PorousMedium{0.49, 0.0159, 50, 2.0, 0.34},
                               [](const Vec3& x) { return x.x > 0.30 && x.x < 0.59 && x.y < 0.37; }});
    GridTrial trial(settings,
                    make_state(settings, [](const Vec3& x) { return x.y < 0.025 || (x.x < 0.28 && x.y < 0.35); }));
    double largest = 0;
    Plot plot{
        "Dam break through crushed rock", "lines: Riprap; marks: Lin", {"x [m]", false}, {"y [m]", false}, {}, false};
    for (std::size_t t = 0; t < profiles.size(); ++t) {
        trial.run(profiles[t].time);
        double square = 0;
        Curve ours{fmt::format("t = {} s", profiles[t].time), {}, {}, CurveStyle::line, static_cast<int>(t)};
        Curve theirs{"", {}, {}, CurveStyle::markers, static_cast<int>(t)};
        for (std::size_t i = 0; i < 9; ++i) {
            const double x = 0.05 + 0.1 * static_cast<double>(i);
            const double y = read_level(settings, trial.state(), {x, 0, 0}, 1);
            square += std::pow(y - profiles[t].y[i], 2) / 9;
            theirs.x.push_back(x);
            theirs.y.push_back(profiles[t].y[i]);
        }
        for (int i = 0; i < settings.mesh.box.cells[0]; ++i) {
            ours.x.push_back(settings.mesh.centre(0, i));
            ours.y.push_back(read_level(settings, trial.state(), {ours.x.back(), 0, 0}, 1));
        }
        plot.curves.push_back(ours);
        plot.curves.push_back(theirs);
        const double rms = std::sqrt(square);
        largest = std::max(largest, rms);
        report.judge_below({fmt::format("rms error of the surface at {} s", profiles[t].time),
                            "m",
                            {},
                            0.0,
                            t == 0 ? "the gate of the experiment took 0.1 s; there is none here" : ""},
                           rms, 0.012);
    }
    trial.report_books(report);
    write_plot(setting, "porous_dam_break", plot);
}

}  // namespace riprap::validation::grid
