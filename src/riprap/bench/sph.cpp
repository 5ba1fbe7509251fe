// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>

#include <cmath>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/sph_pass.hpp"
#include "riprap/bench/sph_scene.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"
#include "riprap/fluid/sph/delta_sph.hpp"

namespace riprap::bench {

namespace {

constexpr double flops_per_pair = 70;       ///< of both sweeps, a reciprocal counted as four
constexpr double bytes_per_particle = 300;  ///< that a pass must move through memory

/// Whole steps of the default scheme, with everything a step does but output.
class Steps {
 public:
    explicit Steps(const SphColumn& column) : column_(column), scheme_(column.settings) {}
    void operator()() {
        fluid::SphSettings& s = column_.settings;
        if (step_++ % s.sort_interval == 0) {
            sort_by_place(column_.water, s.domain, s.spacing);
        }
        fluid::ParticleReport report;
        const double dt = scheme_.limit(column_.water).limit;
        const TimeSpan span{0, dt};
        const Vec3& g = column_.gravity;
        scheme_.update_density(column_.water, column_.walls, g, 0.5 * (last_dt_ + dt), report);
        drift(s, column_.water, 0.5 * dt);
        scheme_.begin_forces(column_.water, column_.walls, span, g, report);
        scheme_.load_walls(column_.water, column_.walls, g);
        scheme_.kick(column_.water, column_.walls, g, span, {}, report);
        drift(s, column_.water, 0.5 * dt);
        last_dt_ = dt;
        problem = report.problem;
    }
    std::string problem;

 private:
    SphColumn column_;
    fluid::DeltaSph<fluid::WaterInPlace> scheme_;
    double last_dt_{0};
    std::int64_t step_{0};
};

/// Memory that the program has asked for and not given back [B].
double bytes_in_use() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// Calls made in one go, so that lists made anew every few sweeps count with their share.
constexpr int batch = 10;

template <class Work>
void make_batch(Work& work) {
    for (int k = 0; k < batch; ++k) {
        work();
    }
}

/// Time of one call on average over batches.
template <class Work>
Timing time_in_batches(Work& work) {
    return each_of(time_calls([&] { make_batch(work); }, {5, 1.0}), batch);
}

void add_rate(const std::string& name, int threads, double particles, const Timing& timing, const std::string& note,
              std::vector<Result>& results) {
    const double rate = particles / timing.median;
    results.push_back({name, threads, 1e-6 * rate, "M particle-passes/s",
                       fmt::format("{:.0f} ns; {}; {}", 1e9 / rate, note, spread(timing))});
}

/// Adds the speed-up of threads over one that make batches of a Work on the column.
template <class Work>
void add_speedup_of(const std::string& name, const SphColumn& column, int threads, std::vector<Result>& results) {
    Work one(column), many(column);
    add_speedup(
        name, threads, [&] { make_batch(one); }, [&] { make_batch(many); }, results);
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
            add_speedup_of<Pass>(name, column, threads, results);
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
            add_speedup_of<Steps>(name + ".step", column, threads, results);
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
