// SPDX-License-Identifier: Apache-2.0
// Whole steps of the three schemes of particles on one column of water: cost of a particle and of a simulated second.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/sph_scene.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/schemes.hpp"

namespace riprap::bench {

namespace {

/// Steps of a scheme as a run takes them, but without output and bodies.
class SchemeSteps {
 public:
    template <class Settings>
    SchemeSteps(const SphColumn& column, Settings own)
        : column_(column), settings_(std::make_unique<fluid::SchemeSettings>(shared(column, own))) {
        scheme_ = make_scheme(*settings_);
        for (double& density : column_.water.density) {
            density = own.rest_density * start(own, density / own.rest_density);
        }
    }

    void operator()() {
        const fluid::ParticleSettings& s = base_of(*settings_);
        if (count_++ % s.sort_interval == 0) {
            sort_by_place(column_.water, s.domain, s.spacing);
        }
        fluid::ParticleReport report;
        const double dt = scheme_->limit(column_.water).limit;
        const TimeSpan span{time_, dt};
        const Vec3& g = column_.gravity;
        scheme_->update_density(column_.water, column_.walls, g, 0.5 * (last_dt_ + dt), report);
        drift(s, column_.water, 0.5 * dt);
        scheme_->begin_forces(column_.water, column_.walls, span, g, report);
        scheme_->load_walls(column_.water, column_.walls, g);
        scheme_->kick(column_.water, column_.walls, g, span, {}, report);
        drift(s, column_.water, 0.5 * dt);
        last_dt_ = dt;
        time_ += dt;
        iterations += report.solver_iterations;
        problem = report.problem;
    }

    std::int64_t count() const { return count_; }
    double time() const { return time_; }
    std::int64_t iterations{0};
    std::string problem;

 private:
    /// The settings with size, speed and place of the column.
    template <class Settings>
    static Settings shared(const SphColumn& column, Settings own) {
        const fluid::ParticleSettings kept = own;
        static_cast<fluid::ParticleSettings&>(own) = column.settings;
        own.smoothing_ratio = kept.smoothing_ratio;
        own.courant = kept.courant;
        own.state_equation = kept.state_equation;
        return own;
    }
    /// Density of the State over that of rest: semi-implicit MPS keeps its pressure there.
    static double start(const fluid::MpsSettings& own, double concentration) {
        const double pressure = own.rest_density * own.sound_speed * own.sound_speed * (concentration - 1);
        return 1 + pressure * own.compressibility / own.relaxation;
    }
    template <class Settings>
    static double start(const Settings& /*own*/, double concentration) {
        return concentration;
    }

    SphColumn column_;
    std::unique_ptr<fluid::SchemeSettings> settings_;
    std::unique_ptr<fluid::ParticleScheme> scheme_;
    double time_{0}, last_dt_{0};
    std::int64_t count_{0};
};

template <class Settings>
SchemeSteps steps_of(const SphColumn& column, double support) {
    Settings settings;
    settings.smoothing_ratio = 0.5 * support;
    return {column, settings};
}

constexpr int batch = 4;

/// Times batches of steps; adds nanoseconds per particle and step, and seconds per simulated second.
/// @returns the processor time of a step [s]
double add_cost(const std::string& name, const SphColumn& column, SchemeSteps& steps, std::vector<Result>& results) {
    for (int k = 0; k < batch; ++k) {  // until pressure and lists are those of water under way
        steps();
    }
    const std::int64_t count = steps.count(), iterations = steps.iterations;
    const double simulated = steps.time();
    const Timing timing = time_calls(
        [&] {
            for (int k = 0; k < batch; ++k) {
                steps();
            }
        },
        {3, 0.5});
    const auto made = static_cast<double>(steps.count() - count);
    const double of_step = timing.median / batch, dt = (steps.time() - simulated) / made;
    std::string note = fmt::format("{} particles, {} in walls; {}", column.size(), column.walls.size(), spread(timing));
    if (steps.iterations > iterations) {
        note += fmt::format("; {:.1f} iterations a step", static_cast<double>(steps.iterations - iterations) / made);
    }
    note += steps.problem.empty() ? "" : "; " + steps.problem;
    results.push_back({name, 1, 1e9 * of_step / static_cast<double>(column.size()), "ns/particle-step", note});
    results.push_back(
        {name + ".second", 1, of_step / dt, "s/s", fmt::format("steps of {:.3g} ms of the column's 0.5 m", 1e3 * dt)});
    return of_step;
}

}  // namespace

// Equal supports of 3.1 spacings first; then the 2.1 that both MPS take in three dimensions.
void water_schemes(const Setting& /*setting*/, std::vector<Result>& results) {
    const ThreadScope scope(1);
    for (const double support : {3.1, 2.1}) {
        const SphColumn column = sph_column(0.5 * support);
        const std::string end = fmt::format(".r{:.0f}", 10 * support);
        SchemeSteps sph = steps_of<fluid::SphSettings>(column, support),
                    wcmps = steps_of<fluid::WcmpsSettings>(column, support);
        const double of_sph = add_cost("water.delta_sph" + end, column, sph, results),
                     of_wcmps = add_cost("water.wcmps" + end, column, wcmps, results);
        results.push_back({"water.wcmps_over_delta_sph" + end, 1, of_wcmps / of_sph, "-", "of these two"});
    }
    for (const int coarsening : {4, 2, 1}) {
        const SphColumn column = sph_column(1.05, coarsening);
        SchemeSteps mps = steps_of<fluid::MpsSettings>(column, 2.1);
        add_cost(fmt::format("water.mps.r21.{}k", column.water.size() / 1000), column, mps, results);
    }
}

}  // namespace riprap::bench
