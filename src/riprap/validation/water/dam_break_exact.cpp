// SPDX-License-Identifier: Apache-2.0
// A dam break of shallow water on a wet bed [Stoker1957].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double gravity = 9.81, depth = 1, tail = 0.5;  ///< of case.toml [m/s^2], [m], [m]

/// Height of the water at x [m].
double level_at(const WaterTrial& trial, double x) {
    fluid::Gauge gauge;
    gauge.kind = &fluid::level_gauge;
    gauge.point = {x, 0, 0};
    gauge.up = {0, 1, 0};
    return fluid::read_gauge(gauge, trial.sph(), trial.state().fluid)[0];
}

/// Heights between two places, this far apart.
struct Profile {
    std::vector<double> x, height;
};

Profile profile_of(const WaterTrial& trial, double low, double high, double step) {
    Profile profile;
    for (double x = low; x <= high + 1e-9; x += step) {
        profile.x.push_back(x);
        profile.height.push_back(level_at(trial, x));
    }
    return profile;
}

/// The plateau behind the bore on water of depth `tail`: u = 2 (c - sqrt(g h)) from the side of the reservoir, mass and
/// momentum across the bore from the other.
struct Bore {
    double height{0}, speed{0}, celerity{0};  ///< h_m [m], u_m [m/s], S [m/s]
};

Bore stoker() {
    double low = tail, high = depth;
    Bore bore;
    for (int i = 0; i < 100; ++i) {
        bore.height = 0.5 * (low + high);
        bore.speed = 2 * (std::sqrt(gravity * depth) - std::sqrt(gravity * bore.height));
        bore.celerity = std::sqrt(0.5 * gravity * bore.height * (bore.height + tail) / tail);
        // Mass: u_m h_m = S (h_m - tail). The wave of the reservoir gives too much where h_m is too low.
        (bore.speed * bore.height > bore.celerity * (bore.height - tail) ? low : high) = bore.height;
    }
    return bore;
}

std::vector<std::string> full_spacing(const CaseSetting& setting) {
    return setting.is_full ? std::vector<std::string>{"fluid.spacing=0.02"} : std::vector<std::string>{};
}

}  // namespace

void stoker(const CaseSetting& setting, CaseReport& report) {
    const Bore exact = stoker();
    WaterTrial trial(setting, full_spacing(setting));
    // Where the bore is half as high as its plateau, between places that stand still.
    std::vector<double> time, place;
    const double half = 0.5 * (exact.height + tail), step = 0.02;
    trial.run([&](const WaterTrial& now) {
        if (now.now() < 0.5 * now.model().time.end) {
            return;
        }
        double beyond = tail;
        for (double k = std::ceil((exact.celerity * now.now() + 1.5) / step); k > 0; --k) {
            const double level = level_at(now, k * step);
            if (level > half) {
                time.push_back(now.now());
                place.push_back(step * (k + (level - half) / (level - beyond)));
                return;
            }
            beyond = level;
        }
    });
    const double celerity =
        time.size() > 1 ? (place.back() - place.front()) / (time.back() - time.front()) : std::nan("");
    report.judge({"speed of the bore in the second half", "m/s", {}, exact.celerity, "Stoker"}, celerity,
                 Relative{0.02});
    const double t = trial.now();
    const double tail_of_wave = (exact.speed - std::sqrt(gravity * exact.height)) * t;
    const double low = tail_of_wave + 0.2 * (exact.celerity * t - tail_of_wave);
    const double high = tail_of_wave + 0.8 * (exact.celerity * t - tail_of_wave);
    const Profile plateau = profile_of(trial, low, high, 0.05);
    double mean = 0;
    for (const double height : plateau.height) {
        mean += height / static_cast<double>(plateau.height.size());
    }
    report.judge({"mean depth of the plateau, its middle 60 %", "m", {}, exact.height, "Stoker; the bore is undular"},
                 mean, Relative{0.03});
    double flow = 0, count = 0;
    const fluid::ParticleState& water = trial.state().fluid;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        if (water.position[i].x > low && water.position[i].x < high) {
            flow += water.velocity[i].x;
            count += 1;
        }
    }
    report.judge({"mean speed of the plateau", "m/s", {}, exact.speed, "Stoker"}, flow / count, Relative{0.03});
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
