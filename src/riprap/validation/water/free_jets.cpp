// SPDX-License-Identifier: Apache-2.0
// Water in free flight: through a sharp slot, and against water [MilneThomson1968].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

void torricelli(const CaseSetting& setting, CaseReport& report) {
    constexpr double slot = 0.1, width = 1.5, gravity = 9.81;  // half of the slot, of the tank; case.toml [m], [m/s^2]
    constexpr double contraction = std::numbers::pi / (std::numbers::pi + 2);
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.00625"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    // The jet leaves with the head over its middle, contraction slot/2 above the floor.
    const std::vector<double>& volume = trial.column("left_behind");
    const double start = 0.6, end = trial.now();
    std::vector<double> ideal;  // sqrt(2 g head) of the level of the moment
    for (const double v : volume) {
        ideal.push_back(slot * std::sqrt(2 * gravity * (v / width - 0.5 * contraction * slot)));
    }
    const double lost = interpolated(trial.time(), volume, start) - volume.back();
    report.judge({fmt::format("flow over slot times sqrt(2 g H), {} to {:.1f} s", start, end),
                  "-",
                  {},
                  contraction,
                  "pi/(pi + 2)"},
                 lost / integral(trial.time(), ideal, start, end), Relative{0.04});
    judge_ledger(report, trial);
}

namespace {

/// Where the particles are on average [m], and their mean velocity over their mean speed [-].
struct Mean {
    Vec3 place{}, momentum{};
};

Mean mean_of(const fluid::ParticleState& water) {
    Mean mean;
    double speeds = 0;
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        mean.place += (1.0 / static_cast<double>(water.position.size())) * water.position[i];
        mean.momentum += water.velocity[i];
        speeds += norm(water.velocity[i]);
    }
    mean.momentum = (1 / speeds) * mean.momentum;
    return mean;
}

}  // namespace

void colliding_squares(const CaseSetting& setting, CaseReport& report) {
    constexpr double side = 0.5;  // case.toml [m]
    WaterTrial trial(setting);
    trial.run();
    const Mean mean = mean_of(trial.state().fluid);
    constexpr double float_sums = 1e-6;  // pair forces are summed in single precision
    report.judge_below({"momentum over that of one square", "-", {}, 0.0, {}, Kind::bookkeeping}, norm(mean.momentum),
                       float_sums);
    report.judge_below({"way of the centre of mass over a side",
                        "-",
                        {},
                        0.0,
                        "shifting moves a particle by its own rate of strain, two of them not by opposite amounts",
                        Kind::bookkeeping},
                       norm(mean.place) / side, float_sums);
    WaterTrial unshifted(setting, std::vector<std::string>{"fluid.shifting=0"});
    unshifted.run();
    report.judge_below({"the same without shifting", "-", {}, 0.0, {}, Kind::bookkeeping},
                       norm(mean_of(unshifted.state().fluid).place) / side, float_sums);
    // Incompressible impact on the plane of symmetry x = 0: the pressure impulse P is harmonic, zero on the free sides,
    // and dP/dx = rho U on the plane, so P = rho U a sum over odd n of 4 (-1)^((n-1)/2)/k^2 cos(k y/a) sinh(k (x +
    // a)/a)/cosh k with k = n pi. It takes the energy U/2 times its integral over the plane.
    double loss = 0;
    for (int n = 1; n < 400; n += 2) {
        const double k = n * std::numbers::pi;
        loss += 8 * std::tanh(k) / (k * k * k);
    }
    const std::vector<double>& energy = trial.column("fluid.kinetic");
    // The squares meet at 0.1 s.
    const double first = 2 * 0.5 * 1000 * 0.5 * 0.5;  // two squares of 0.25 m^2 at 1 m/s [J/m]
    report.judge({"kinetic energy lost at 0.25 s over that at the start",
                  "-",
                  {},
                  loss,
                  "pressure impulse on two squares, incompressible"},
                 1 - interpolated(trial.time(), energy, 0.25) / first, Relative{0.1});
    judge_ledger(report, trial);
}

}  // namespace riprap::validation::water
