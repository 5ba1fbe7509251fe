// SPDX-License-Identifier: Apache-2.0
// Surfaces that swing, grow and rise.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

void still_water(const CaseSetting& setting, CaseReport& report) {
    (void)setting;
    GridSettings settings = make_tank({}, {1, 1, 0.1}, {40, 40, 1});
    settings.side[3].kind = SideKind::open;
    settings.porous.push_back({PorousMedium{0.45, 0.02}, [](const Vec3& x) { return x.x > 0.4 && x.y < 0.3; }});
    GridTrial trial(settings, make_state(settings, [](const Vec3& x) { return x.y < 0.5123; }));
    trial.run(3);
    double fastest = 0;
    for (int a = 0; a < 2; ++a) {
        for_faces(settings.mesh.box, a, [&](std::int64_t f, int, int, int) {
            fastest = std::max(fastest, std::abs(trial.state().velocity[at(a)][at(f)]));
        });
    }
    report.judge_below({"highest speed over a step of stones after 3 s", "m/s", {}, 0.0, {}}, fastest, 1e-10);
    const double level = read_level(settings, trial.state(), {0.1, 0, 0}, 1);
    report.judge({"pressure at the bottom", "Pa", {}, 9.81 * (1000 * level + 1.2 * (1 - level)), {}},
                 read_pressure(settings, trial.state(), {0.1, 0.0125, 0}) + 9.81 * 1000 * 0.0125, Relative{1e-9});
    trial.report_books(report);
}

void standing_wave(const CaseSetting& setting, CaseReport& report) {
    // First mode of a tank 1 m long with 0.5 m of water: omega^2 = g k tanh(kd), k = pi/L; amplitude 5 mm.
    const int n = setting.is_full ? 160 : 80;
    const double amplitude = 0.005, depth = 0.5, k = M_PI,
                 exact = 2 * M_PI / std::sqrt(9.81 * k * std::tanh(k * depth));
    GridSettings settings = make_tank({}, {1, 0.7, 0.1}, {n, n * 7 / 10, 1});
    settings.side[3].kind = SideKind::open;
    GridTrial trial(settings,
                    make_state(settings, [=](const Vec3& x) { return x.y < depth + amplitude * std::cos(k * x.x); }));
    trial.add("level", [=](const GridTrial& t) {
        return read_level(t.settings(), t.state(), {1e-3, 0, 0}, 1) - depth;
    });
    trial.run(6.3 * exact);
    std::vector<double> down, crests;
    const auto& t = trial.time();
    const auto& level = trial.column("level");
    double crest = 0;
    for (std::size_t i = 1; i < t.size(); ++i) {
        if (level[i - 1] > 0 && level[i] <= 0) {
            down.push_back(t[i - 1] + (t[i] - t[i - 1]) * level[i - 1] / (level[i - 1] - level[i]));
            crests.push_back(crest);
            crest = 0;
        }
        crest = std::max(crest, level[i]);
    }
    const double periods = static_cast<double>(down.size()) - 1;
    report.judge({"period, mean of what passes", "s", {}, exact, {}}, (down.back() - down.front()) / periods,
                 Relative{0.005});
    report.judge_below({"loss of height per period", "-", {}, 0.0, {}},
                       1 - std::pow(crests.back() / crests[1], 1 / (periods - 1)), 0.01);
    trial.report_books(report);
}

void sway(const CaseSetting& setting, CaseReport& report) {
    // Series 5 of [Bouscasse2013]: a tank 1 m long with 3 cm of water sways by 7 cm, x = A sin(omega t).
    const double depth = 0.03, amplitude = 0.06999, period = 2.99929, omega = 2 * M_PI / period;
    const int scale = setting.is_full ? 2 : 1;
    GridSettings settings = make_tank({}, {1, 0.15, 0.1}, {200 * scale, 40 * scale, 1});
    settings.side[3].kind = SideKind::open;
    settings.frame_acceleration = [=](double t) { return Vec3{amplitude * omega * omega * std::sin(omega * t), 0, 0}; };
    GridState state = make_state(
        settings, [=](const Vec3& x) { return x.y < depth ? 1.0 : 0.0; }, [](const Vec3&) { return Vec3{}; });
    GridTrial trial(settings, state);
    trial.add("level", [=](const GridTrial& t) {
        return read_level(t.settings(), t.state(), {0.05, 0, 0}, 1) - depth;
    });
    trial.run(11.4 * period);
    double height = 0, phase = 0, trough = 1;
    for (int n = 8; n < 11; ++n) {
        double crest = -1, when = 0;
        for (std::size_t i = 0; i < trial.time().size(); ++i) {
            const double turns = trial.time()[i] / period - n;
            if (turns >= 0.4 && turns < 1.4) {
                trough = std::min(trough, trial.column("level")[i]);
                if (trial.column("level")[i] > crest) {
                    crest = trial.column("level")[i];
                    when = turns;
                }
            }
        }
        height += crest / 3;
        phase += when / 3;
    }
    report.judge({"height of the crest, mean of periods", "m", 0.0583, {}, {}}, height, 0.9 * 0.0583, 1.1 * 0.0583);
    report.judge({"its phase", "period", 0.876, {}, {}}, phase, 0.846, 0.906);
    report.judge({"lowest level", "m", -0.011, {}, {}}, trough, -1.1 * 0.011, -0.9 * 0.011);
    trial.report_books(report);
}

namespace {

/// Rate at which a wave k of a heavy layer over a light one grows, equal kinematic viscosities [Chandrasekhar1961, X,
/// eq. 113] [1/s]: with the shear layers at the surface that [Duff1962] leaves out, -nu k^2 + sqrt(A g k + nu^2 k^4),
/// and that take 4 % here.
/// @param heavy  density of the heavy layer over the sum of both [-]
double growth_rate(double heavy, double gravity, double k, double nu) {
    const double product = heavy * (1 - heavy), drive = gravity * (2 * heavy - 1) / (k * k * k * nu * nu);
    double low = 1, high = 2 + std::pow(drive, 0.25);
    for (int i = 0; i < 100; ++i) {
        const double y = 0.5 * (low + high), square = y * y;
        const double excess = square * square + 4 * product * square * y + 2 * (1 - 6 * product) * square -
                              4 * (1 - 3 * product) * y + 1 - 4 * product - drive;
        (excess > 0 ? high : low) = y;
    }
    return (low * low - 1) * nu * k * k;
}

}  // namespace

void rayleigh_taylor(const CaseSetting& setting, CaseReport& report) {
    // Heavy over light, Atwood number 1/2, half a wave of k = 2 pi/m between slip walls, layers deep against 1/k: from
    // rest a = (s_- e^(s_+ t) - s_+ e^(s_- t))/(s_- - s_+) with the viscous rate s_+ [Chandrasekhar1961] and s_- = -A g
    // k/s_+, so that it starts as without viscosity, a'' = A g k a, before there are layers of shear. Viscosity keeps
    // the shortest waves of the mesh from growing out of round-off first.
    const int n = setting.is_full ? 64 : 32;
    const double start = 0.005, k = 2 * M_PI, depth = 1, nu = 2e-3;
    GridSettings settings = make_tank({0, -depth, 0}, {0.5, depth, 0.1}, {n, 4 * n, 1});
    settings.water = {3, nu};
    settings.air = {1, nu};
    settings.longest_step = 0.05 * 0.5 / n;
    const double sigma = growth_rate(0.75, 9.81, k, nu), fall = -0.5 * 9.81 * k / sigma;
    GridTrial trial(settings, make_state(settings, [=](const Vec3& x) { return x.y > start * std::cos(k * x.x); }));
    const double width = 0.5 / n;
    trial.add("rise", [=](const GridTrial& t) {  // half the difference of the two sides, of cells as wide as one
        const double mean = std::sin(k * width) / (k * width);
        return 0.5 *
               (read_level(t.settings(), t.state(), {0.5 - 1e-3, 0, 0}, 1) -
                read_level(t.settings(), t.state(), {1e-3, 0, 0}, 1)) /
               mean;
    });
    trial.run(2 / sigma);
    for (const double turns : {1.0, 1.5, 2.0}) {
        const double t = turns / sigma;
        const double exact = (fall * std::exp(sigma * t) - sigma * std::exp(fall * t)) / (fall - sigma);
        report.judge({fmt::format("amplitude at {}/sigma over the first", turns), "-", {}, exact, {}},
                     trial.at_time("rise", t) / start, Relative{0.05});
    }
    trial.report_books(report);
}

void rising_bubble(const CaseSetting& setting, CaseReport& report) {
    // First case of [Hysing2009]: density 1000 and 100, viscosity 10 and 1 Pa s, tension 24.5 N/m, g = 0.98 m/s^2.
    const int n = setting.is_full ? 80 : 40;
    GridSettings settings = make_tank({}, {1, 2, 1}, {n, 2 * n, 1});
    settings.gravity = {0, -0.98, 0};
    settings.water = {1000, 0.01};
    settings.air = {100, 0.01};
    settings.surface_tension = 24.5;
    settings.side[2].kind = settings.side[3].kind = SideKind::no_slip;
    GridTrial trial(settings,
                    make_state(settings, [](const Vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.5) > 0.25; }));
    const auto over_bubble = [](const GridTrial& t, bool is_speed) {
        double sum = 0, all = 0;
        const CellBox& box = t.settings().mesh.box;
        for_cells(box, [&](std::int64_t c, int, int j, int) {
            const double gas = 1 - t.state().fraction[at(c)];
            const auto& v = t.state().velocity[1];
            sum += gas * (is_speed ? 0.5 * (v[at(c)] + v[at(c + box.stride[1])]) : t.settings().mesh.centre(1, j));
            all += gas;
        });
        return sum / all;
    };
    trial.add("speed", [&](const GridTrial& t) { return over_bubble(t, true); });
    trial.add("height", [&](const GridTrial& t) { return over_bubble(t, false); });
    trial.run(3);
    const auto& speed = trial.column("speed");
    const auto top = std::max_element(speed.begin(), speed.end());
    report.judge({"highest speed of the bubble", "m/s", 0.2417, {}, "three finite-element codes: 0.2417 to 0.2421"},
                 *top, 0.98 * 0.2417, 1.02 * 0.2421);
    report.judge({"its time", "s", 0.9213, {}, "0.9213 to 0.9313"},
                 trial.time()[static_cast<std::size_t>(top - speed.begin())], 0.87, 0.98);
    report.judge({"height of the bubble at 3 s", "m", 1.0813, {}, "1.0799 to 1.0817"}, trial.column("height").back(),
                 0.99 * 1.0799, 1.01 * 1.0817);
    trial.report_books(report);
}

}  // namespace riprap::validation::grid
