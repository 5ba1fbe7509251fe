// SPDX-License-Identifier: Apache-2.0
// Flow between two plates that starts from rest, against the series of the exact solution [Morris1997].
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double gap = 1e-3, viscosity = 1e-6, body_force = 1e-4, plate_speed = 1.25e-5;  ///< of both case.toml

/// u(y, t) = F/(2 nu) y (L - y) - sum over odd n of 4 F L^2/(nu pi^3 n^3) sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2) [m/s]
double poiseuille_speed(double y, double t) {
    double u = body_force / (2 * viscosity) * y * (gap - y);
    for (int n = 1; n < 200; n += 2) {
        const double k = n * M_PI / gap;
        u -= 4 * body_force * gap * gap / (viscosity * std::pow(n * M_PI, 3)) * std::sin(k * y) *
             std::exp(-k * k * viscosity * t);
    }
    return u;
}

/// u(y, t) = V y/L + sum over n of 2 V/(n pi) (-1)^n sin(n pi y/L) exp(-n^2 pi^2 nu t/L^2) [m/s]
double couette_speed(double y, double t) {
    double u = plate_speed * y / gap;
    for (int n = 1; n < 200; ++n) {
        const double k = n * M_PI / gap;
        u += 2 * plate_speed / (n * M_PI) * (n % 2 == 0 ? 1 : -1) * std::sin(k * y) * std::exp(-k * k * viscosity * t);
    }
    return u;
}

using ExactSpeed = std::function<double(double y, double t)>;

/// rms over particles of u - u_exact, over the largest exact speed at that time [-].
double profile_error(const WaterTrial& trial, const ExactSpeed& exact) {
    const fluid::ParticleState& water = trial.state().fluid;
    double sum = 0, largest = 0;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        const double u = exact(water.position[i].y, trial.now());
        sum += std::pow(water.velocity[i].x - u, 2);
        largest = std::max(largest, std::abs(u));
    }
    return std::sqrt(sum / static_cast<double>(water.position.size())) / largest;
}

/// Plates start at three resolutions; the finest is judged, the order of convergence printed.
void start_up(const CaseSetting& setting, CaseReport& report, const char* name, const char* title,
              const ExactSpeed& exact) {
    const std::vector<int> across = setting.is_full ? std::vector<int>{25, 50, 100} : std::vector<int>{12, 25, 50};
    std::vector<double> errors;
    Plot profile{title, "lines: series; marks: particles", {"u [m/s]", false}, {"y [m]", false}, {}, false};
    for (const int count : across) {
        WaterTrial trial(setting, std::vector{fmt::format("fluid.spacing={:.17g}", gap / count)});
        const bool is_finest = count == across.back();
        std::size_t next = 0;
        constexpr std::array moments{0.0225, 0.045, 0.1125, 0.225};
        trial.run([&](const WaterTrial& now) {
            if (!is_finest || next == moments.size() || now.now() < moments[next]) {
                return;
            }
            std::vector<double> y, u, all_y, all_u;
            for (int i = 0; i <= 100; ++i) {
                y.push_back(gap * i / 100);
                u.push_back(exact(y.back(), now.now()));
            }
            for (std::size_t i = 0; i < now.state().fluid.position.size(); ++i) {
                all_y.push_back(now.state().fluid.position[i].y);
                all_u.push_back(now.state().fluid.velocity[i].x);
            }
            profile.curves.push_back({fmt::format("t = {} s", moments[next]), u, y, CurveStyle::line, -1});
            profile.curves.push_back({"particles", all_u, all_y, CurveStyle::points, static_cast<int>(next)});
            ++next;
        });
        errors.push_back(profile_error(trial, exact));
        for (const double moment : moments) {
            if (is_finest) {
                report.judge({fmt::format("speed in the middle at {} s, {} across", moment, count),
                              "m/s",
                              {},
                              exact(0.5 * gap, moment),
                              "series"},
                             interpolated(trial.time(), trial.column("middle.x"), moment), Relative{0.01});
            }
        }
    }
    report.judge_below({fmt::format("rms error of the profile at the end, {} across", across[2]), "-", {}, 0.0, {}},
                       errors[2], 0.01);
    const double order = std::log(errors[1] / errors[2]) / std::log(static_cast<double>(across[2]) / across[1]);
    report.judge({fmt::format("order of convergence from {} to {} across", across[1], across[2]),
                  "-",
                  {},
                  2.0,
                  fmt::format("errors {:.2g}, {:.2g}, {:.2g}", errors[0], errors[1], errors[2])},
                 order, Absolute{0.5});
    write_plot(setting, name, profile);
}

}  // namespace

void poiseuille(const CaseSetting& setting, CaseReport& report) {
    start_up(setting, report, "poiseuille", "Poiseuille flow starts", poiseuille_speed);
}

void couette(const CaseSetting& setting, CaseReport& report) {
    start_up(setting, report, "couette", "Couette flow starts", couette_speed);
}

}  // namespace riprap::validation::water
