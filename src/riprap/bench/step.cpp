// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/sph_pass.hpp"
#include "riprap/bench/sph_scene.hpp"
#include "riprap/bench/step_scene.hpp"
#include "riprap/core/error.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"

namespace riprap::bench {

namespace {

/// Whole steps as `riprap run` takes them, but for output and the search for what is not finite.
class Run {
 public:
    explicit Run(StepScene scene) : scene_(std::move(scene)) {}
    void step() {
        const double dt = sim::full_time_step(scene_.model, scene_.state, scratch_).dt;
        report = sim::advance(scene_.model, scene_.state, scratch_, dt, sim::Measure::flow);
        if (!report.status.ok()) {
            throw InternalError(report.status.text);
        }
        ++steps;
    }
    void steps_in_a_row(int count) {
        for (int k = 0; k < count; ++k) {
            step();
        }
    }
    double particles() const { return static_cast<double>(scene_.state.fluid.size()); }
    double bytes() const {
        return static_cast<double>(sim::memory_bytes(scene_.model, scene_.state, scratch_)) / particles();
    }
    sim::StageTimes times() const { return sim::stage_times(scratch_); }
    std::string shares(double seconds) const;
    double blocks() const {
        return static_cast<double>(std::ranges::count(scene_.model.bodies.drive, body::Drive::free));
    }

    sim::StepReport report;
    std::int64_t steps{0};

 private:
    StepScene scene_;
    sim::Scratch scratch_;
};

/// Share of each stage in the seconds that all steps took.
std::string Run::shares(double seconds) const {
    std::string text;
    double named = 0;
    const auto add = [&](std::string_view name, double share) {
        text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", name, 100 * share / seconds);
        named += share;
    };
    const sim::StageTimes solids = times();
    add("water", solids.fluid);
    add("find pairs", solids.find_pairs);
    add("contacts", solids.find_contacts + solids.contact_loads);
    add("move bodies", solids.move_bodies);
    add("rest", seconds - named);
    return text;
}

constexpr int batch = 5;
constexpr int pairs_of_batches = 7;

/// Median over batches of the seconds of a step, by as many threads as are set.
Timing time_steps(Run& run) {
    return each_of(time_calls([&] { run.steps_in_a_row(batch); }, {5, 1.0}), batch);
}

/// Ratio of the time of a step of `longer` to one of `shorter`, in turn on one thread.
Timing times_as_long(Run& longer, Run& shorter) {
    const ThreadScope scope(1);
    return compare_calls([&] { longer.steps_in_a_row(batch); }, [&] { shorter.steps_in_a_row(batch); },
                         pairs_of_batches, Clock::processor);
}

/// Compares the time that the water takes of the steps of both.
Timing times_as_long_for_water(Run& longer, Run& shorter) {
    const ThreadScope scope(1);
    const auto water_of = [](Run& run) {
        const double before = run.times().fluid;
        run.steps_in_a_row(batch);
        return run.times().fluid - before;
    };
    return compare_seconds([&] { return water_of(longer); }, [&] { return water_of(shorter); }, pairs_of_batches);
}

void add_ratio(const std::string& name, const Timing& ratio, const std::string& what, std::vector<Result>& results) {
    results.push_back({name, 1, ratio.median, "-", fmt::format("{}; {}", what, spread(ratio))});
}

/// Time, shares of the stages, memory and speed-up of a scene.
void measure_steps(const Setting& setting, const std::string& name, const StepScene& scene,
                   std::vector<Result>& results) {
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        Run run(scene);
        const double before = now(Clock::wall);  // as stages are timed
        const Timing timing = time_steps(run);
        const double seconds = now(Clock::wall) - before;
        results.push_back({name, threads, 1e9 * timing.median / run.particles(), "ns/particle-step",
                           fmt::format("{:.2f} ms a step; {:.0f} particles, {:.0f} free blocks, {} steps of the solids "
                                       "and {} passes a step; {}; {}",
                                       1e3 * timing.median, run.particles(), run.blocks(), run.report.substeps,
                                       run.report.fluid_passes, run.shares(seconds), spread(timing))});
        if (threads == 1) {
            results.push_back({name + ".memory", threads, run.bytes(), "B/particle", "Model, State and Scratch"});
            continue;
        }
        Run one(scene);
        add_speedup(
            name, threads, [&] { one.steps_in_a_row(batch); }, [&] { run.steps_in_a_row(batch); }, results,
            pairs_of_batches);
    }
}

/// A whole step over the benched pass, per particle of the water.
void add_ratio_to_pass(const std::string& name, std::vector<Result>& results) {
    constexpr double smoothing_ratio = 1.5;
    const SphColumn column = sph_column(smoothing_ratio);
    Run run(dam_break_on_box());
    Pass pass(column);
    const ThreadScope scope(1);
    const Timing whole = compare_calls([&] { run.steps_in_a_row(batch); },
                                       [&] {
                                           for (int k = 0; k < batch; ++k) {
                                               pass();
                                           }
                                       },
                                       pairs_of_batches, Clock::processor);
    add_ratio(name, each_of(whole, run.particles() / static_cast<double>(column.size())),
              fmt::format("whole step over the benched pass at h/dp = {}, per particle", smoothing_ratio), results);
}

/// The same steps with water on the device, if there is one, and how many times as fast they are.
void measure_device_steps(const Setting& setting, const std::string& name, StepScene (*make)(const StepSize&),
                          const StepSize& size, std::vector<Result>& results) {
    if (!fluid::has_device()) {
        return;
    }
    const StepScene scene = make(size);
    StepScene there = scene;
    there.model.particles()->sph().runs_on = fluid::RunsOn::device;
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        Run device(there), host(scene);
        const Timing timing = time_steps(device);
        results.push_back({name + ".device", threads, 1e9 * timing.median / device.particles(), "ns/particle-step",
                           fmt::format("{:.2f} ms a step; {:.0f} particles; {}", 1e3 * timing.median,
                                       device.particles(), spread(timing))});
        const Timing ratio =
            compare_calls([&] { host.steps_in_a_row(batch); }, [&] { device.steps_in_a_row(batch); }, pairs_of_batches);
        results.push_back({name + ".device_speedup", threads, ratio.median, "-",
                           fmt::format("over the host with as many threads, in turn; {}", spread(ratio))});
    }
}

}  // namespace

void step_dam_break(const Setting& setting, std::vector<Result>& results) {
    measure_steps(setting, "step.dam_break", dam_break_on_box(), results);
    add_ratio_to_pass("step.dam_break.over_pass", results);
    measure_device_steps(setting, "step.dam_break", dam_break_on_box, {}, results);
    measure_device_steps(setting, "step.dam_break.fine", dam_break_on_box, {0.5}, results);
}

void step_floes(const Setting& setting, std::vector<Result>& results) {
    measure_steps(setting, "step.floes", dam_break_with_floes(), results);
    measure_device_steps(setting, "step.floes", dam_break_with_floes, {}, results);
}

void step_rubble(const Setting& setting, std::vector<Result>& results) {
    constexpr double third = 1.0 / 3;
    measure_steps(setting, "step.rubble", rubble_in_basin(Rubble::in_basin, third), results);
    {
        Run beside(rubble_in_basin(Rubble::far_dry, third)), alone(rubble_in_basin(Rubble::nowhere, third));
        const Timing water = times_as_long_for_water(beside, alone), whole = times_as_long(beside, alone);
        add_ratio("step.rubble.far_dry", water,
                  fmt::format("water's part of a step beside 3072 far dry blocks over one without, the whole of it "
                              "{:.2f} times",
                              whole.median),
                  results);
    }
    const auto compare = [&](const std::string& name, double wet) {
        Run longer(rubble_in_basin(Rubble::in_basin, wet)), shorter(rubble_in_basin(Rubble::none, wet));
        add_ratio(name, times_as_long(longer, shorter), "over the same water without blocks", results);
    };
    compare("step.rubble.third_wet", third);
    compare("step.rubble.half_wet", 0.5);
}

void step_slide(const Setting& setting, std::vector<Result>& results) {
    measure_steps(setting, "step.slide", slide_into_water(), results);
}

}  // namespace riprap::bench
