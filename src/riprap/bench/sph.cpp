// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/sph_pairs.hpp"
#include "riprap/bench/sph_scene.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/sph_step.hpp"

namespace riprap::bench {

namespace {

using fluid::component;
using fluid::field;
using fluid::sink;
using fluid::sink_component;
using fluid::SweepScratch;

constexpr double flops_per_pair = 70;       ///< of both sweeps, a reciprocal counted as four
constexpr double bytes_per_particle = 300;  ///< that a pass must move through memory

/// One set of particles with the numbers that both pairs read and the sums that they make.
struct PassSide {
    const std::vector<Vec3>& position;
    const std::vector<Vec3>& velocity;
    std::vector<double> density, excess, volume, pressure_term, density_rate;
    std::vector<Vec3> acceleration;

    PassSide(const std::vector<Vec3>& x, const std::vector<Vec3>& v, std::vector<double> rho, const SphConstants& c)
        : position(x), velocity(v), density(std::move(rho)), density_rate(x.size()), acceleration(x.size()) {
        for (const double r : density) {
            const double stiffness = c.rest_density * c.sound_speed * c.sound_speed / 7;
            excess.push_back(r - c.rest_density);
            volume.push_back(c.particle_mass / r);
            pressure_term.push_back(stiffness * (std::pow(r / c.rest_density, 7) - 1) / (r * r));
        }
    }
    fluid::SweepSide<5> density_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(excess), field(volume)}};
    }
    fluid::SweepSide<5> force_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(pressure_term),
                 field(density)}};
    }
    std::array<fluid::FieldSink, 3> force_sinks() {
        return {sink_component(acceleration, 0), sink_component(acceleration, 1), sink_component(acceleration, 2)};
    }
};

/// Both sweeps over water and walls with the physics of the peers: what docs/howto/benchmarks.md compares.
class Pass {
 public:
    explicit Pass(const SphColumn& column)
        : column_(column),
          constants_{fluid::WendlandC2(column.settings.smoothing_length(), 3),
                     column.settings.smoothing_length(),
                     column.settings.sound_speed,
                     column.settings.rest_density,
                     column.settings.particle_mass,
                     0.1,
                     0.1,
                     column.gravity},
          reach_{column.settings.support_radius(), column.settings.domain},
          water_(column_.water.position, column_.water.velocity, column_.water.density, constants_),
          walls_(column_.walls.position, column_.walls.velocity,
                 std::vector<double>(column_.walls.position.size(), constants_.rest_density), constants_) {}
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

    /// One pass of a step: the water moves by half a step before each sweep.
    void operator()() {
        move();
        const DensityRatePair density{constants_};
        exchange_within(density, reach_, water_.density_side(), {sink(water_.density_rate)}, water_water_);
        exchange(density, reach_, water_.density_side(), walls_.density_side(), {sink(water_.density_rate)},
                 {sink(walls_.density_rate)}, water_walls_);
        move();
        const AccelerationPair force{constants_};
        exchange_within(force, reach_, water_.force_side(), water_.force_sinks(), water_water_);
        exchange(force, reach_, water_.force_side(), walls_.force_side(), water_.force_sinks(), walls_.force_sinks(),
                 water_walls_);
    }
    /// Directed pairs that act.
    double count_pairs() {
        std::vector<double> in_water(water_.position.size()), in_walls(walls_.position.size());
        const auto count = [&](const PassSide& a, const PassSide& b, std::vector<double>& sum, SweepScratch& scratch) {
            sweep(CountPair{constants_}, reach_, {a.position, {}}, {b.position, {}}, {sink(sum)}, scratch);
        };
        SweepScratch water_water, water_walls, walls_water;
        count(water_, water_, in_water, water_water);
        count(water_, walls_, in_water, water_walls);
        count(walls_, water_, in_walls, walls_water);
        double pairs = 0;
        for (const auto* counts : {&in_water, &in_walls}) {
            for (const double n : *counts) {
                pairs += n;
            }
        }
        return pairs;
    }

 private:
    void move() {
        const fluid::SphSettings& s = column_.settings;
        const double half_step = 0.5 * s.courant * s.smoothing_length() / (1.1 * s.sound_speed);
        parallel::for_each(column_.water.size(), [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            column_.water.position[i] += half_step * column_.water.velocity[i];
        });
    }
    SphColumn column_;
    SphConstants constants_;
    fluid::SweepReach reach_;
    PassSide water_, walls_;
    SweepScratch water_water_, water_walls_;
};

/// Whole steps of the default scheme, with everything a step does but output.
class Steps {
 public:
    explicit Steps(const SphColumn& column) : column_(column) {}
    void operator()() {
        fluid::SphSettings& s = column_.settings;
        if (step_++ % s.sort_interval == 0) {
            sort_by_place(column_.water, s.domain, s.spacing);
        }
        fluid::FluidReport report;
        const double dt = fluid::choose_fluid_time_step(s, column_.water).limit;
        update_density(s, column_.water, column_.walls, column_.gravity, 0.5 * (last_dt_ + dt), scratch_, report);
        drift(s, column_.water, 0.5 * dt);
        accelerate(s, column_.water, column_.walls, column_.gravity, dt, 0, scratch_, report);
        drift(s, column_.water, 0.5 * dt);
        last_dt_ = dt;
        problem = report.problem;
    }
    std::string problem;

 private:
    SphColumn column_;
    fluid::SphScratch scratch_;
    double last_dt_{0};
    std::int64_t step_{0};
};

/// Memory that the program has asked for and not given back [B].
double bytes_in_use() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Time of one call on average over batches of ten, so that lists made anew every few sweeps count with their share.
template <class Call>
Timing time_in_batches(Call& call) {
    constexpr int batch = 10;
    Timing timing = time_calls(
        [&] {
            for (int k = 0; k < batch; ++k) {
                call();
            }
        },
        {5, 1.0});
    for (double* time : {&timing.median, &timing.low, &timing.high}) {
        *time /= batch;
    }
    return timing;
}

void add_rate(const std::string& name, int threads, double particles, const Timing& timing, const std::string& note,
              std::vector<Result>& results) {
    const double rate = particles / timing.median;
    results.push_back({name, threads, 1e-6 * rate, "M particle-passes/s",
                       fmt::format("{:.0f} ns; {}; {}", 1e9 / rate, note, spread(timing))});
}

/// How many times as fast `threads` make ten calls of a Work on the column as one thread does.
template <class Work>
void add_speedup(const std::string& name, const SphColumn& column, int threads, std::vector<Result>& results) {
    Work one(column), many(column);
    const auto batch = [](Work& work, int count) {
        const ThreadScope scope(count);
        for (int k = 0; k < 10; ++k) {
            work();
        }
    };
    const Timing ratio = compare_calls([&] { batch(one, 1); }, [&] { batch(many, threads); });
    results.push_back({name + ".speedup", threads, ratio.median, "-",
                       fmt::format("over one thread, in turn on the wall; {}", spread(ratio))});
}

void measure_sph(const Setting& setting, const std::string& name, double smoothing_ratio,
                 std::vector<Result>& results) {
    const SphColumn column = sph_column(smoothing_ratio);
    const auto particles = static_cast<double>(column.size());
    double pairs = 0;
    for (std::size_t t = 0; t < setting.thread_counts.size(); ++t) {
        const int threads = setting.thread_counts[t];
        const ThreadScope scope(threads);
        Pass pass(column);
        pairs = pass.count_pairs();
        const Timing timing = time_in_batches(pass);
        const double pair_rate = pairs / timing.median;
        std::string note = threads > 1 ? ""
                                       : fmt::format("{:.2f} M/s scaled to the reference core; ",
                                                     1e-6 * particles / timing.median / core_speed(setting.machine));
        note += fmt::format("{:.0f} particles, {:.0f} in walls; {:.1f} neighbours; {:.0f} M pairs/s", particles,
                            static_cast<double>(column.walls.size()), pairs / particles, 1e-6 * pair_rate);
        if (t < setting.machine.by_threads.size()) {
            const ThreadLimits& limits = setting.machine.by_threads[t];
            note += fmt::format("; {:.0f} % of the peak of f32 FMA at {:.0f} flops a pair, {:.0f} % of the bandwidth",
                                100 * pair_rate * flops_per_pair / limits.fma_single, flops_per_pair,
                                100 * particles / timing.median * bytes_per_particle / limits.triad);
        }
        add_rate(name, threads, particles, timing, note, results);
        if (threads > 1) {
            add_speedup<Pass>(name, column, threads, results);
        }
    }
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        const double before = bytes_in_use();
        Steps steps(column);
        const Timing timing = time_in_batches(steps);
        const double bytes = (bytes_in_use() - before) / particles;
        const std::string note = fmt::format("whole steps of delta_sph, {:.0f} M pairs/s in both of their sums",
                                             1e-6 * pairs / timing.median);
        add_rate(name + ".step", threads, particles, timing, note + (steps.problem.empty() ? "" : "; " + steps.problem),
                 results);
        if (threads > 1) {
            add_speedup<Steps>(name + ".step", column, threads, results);
        } else {
            results.push_back(
                {name + ".memory", threads, bytes, "B/particle",
                 fmt::format("State and Scratch of whole steps; 1.5 million particles: {:.2f} GB", 1.5e-3 * bytes)});
        }
    }
}

}  // namespace

void sph_h1732(const Setting& setting, std::vector<Result>& results) {
    measure_sph(setting, "sph.h1732", 1.732, results);
}
void sph_h12(const Setting& setting, std::vector<Result>& results) { measure_sph(setting, "sph.h12", 1.2, results); }

}  // namespace riprap::bench
