// SPDX-License-Identifier: Apache-2.0
// Surfaces that swing and rise.
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

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
