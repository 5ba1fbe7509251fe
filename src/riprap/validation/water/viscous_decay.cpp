// SPDX-License-Identifier: Apache-2.0
// Laminar viscosity against an exact solution: vortices that die.
#include <cmath>
#include <numbers>
#include <random>

#include "riprap/fluid/particle/state_equation.hpp"
#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::water {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

void taylor_green(const CaseSetting& setting, CaseReport& report) {
    constexpr double viscosity = 0.01, rate = 8 * pi * pi * viscosity;  // of the speed [1/s]; L = U = 1
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.01"};
    }
    WaterTrial trial(setting, finer);
    // A perfect lattice stretches along the stagnation lines without a gradient of concentration that shifting could
    // act on, until it tears: places are a tenth of a spacing off. Density starts with the pressure of the flow.
    sim::State& start = trial.initial();
    std::mt19937 random(1);
    const auto jitter = [&] {
        return 0.2 * trial.sph().spacing * (static_cast<double>(random()) / 4294967296.0 - 0.5);
    };
    for (std::size_t i = 0; i < start.fluid.position.size(); ++i) {
        start.fluid.position[i] += Vec3{jitter(), jitter(), 0};
        const double x = 2 * pi * start.fluid.position[i].x, y = 2 * pi * start.fluid.position[i].y;
        start.fluid.velocity[i] = {-std::cos(x) * std::sin(y), std::sin(x) * std::cos(y), 0};
        start.fluid.density[i] = fluid::density_of(trial.sph(), -0.25 * 1000 * (std::cos(2 * x) + std::cos(2 * y)));
    }
    trial.run();
    const std::vector<double>& energy = trial.column("fluid.kinetic");
    const auto speed = [&](double t) { return std::sqrt(interpolated(trial.time(), energy, t) / (0.25 * 1000)); };
    report.judge({"rms speed at 1 s over the first", "-", {}, std::exp(-rate), "exp(-8 pi^2 t/Re)"}, speed(1),
                 Relative{0.03});
    report.judge({"rms speed at 2 s over the first", "-", {}, std::exp(-2 * rate), "likewise"}, speed(2),
                 Relative{0.03});
    report.judge({"rate of decay from 0.2 to 2 s", "1/s", {}, rate, "8 pi^2/Re"}, std::log(speed(0.2) / speed(2)) / 1.8,
                 Relative{0.03});
}

}  // namespace riprap::validation::water
