// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/pile_scene.hpp"

namespace riprap::bench {

namespace {

/// A pile that so many threads step, in batches of about a fifth of a second.
class PileRun {
 public:
    /// Makes some steps that fill caches and buffers.
    PileRun(Pile pile, int threads, int warm_steps) : pile_(std::move(pile)), threads_(threads) {
        const ThreadScope scope(threads_);
        advance(pile_, scratch_, 1);
        const double start = now();
        advance(pile_, scratch_, warm_steps);
        const double warm_seconds = std::max(1e-6, now() - start);
        batch_ = std::max(2, static_cast<int>(0.2 * warm_steps / warm_seconds));
    }
    void step_batch() {
        const ThreadScope scope(threads_);
        report = advance(pile_, scratch_, batch_);
    }
    /// Seconds of a step.
    Timing time_steps() {
        const ThreadScope scope(threads_);
        return each_of(time_calls([this] { step_batch(); }, {7, 1.0}), batch_);
    }
    sim::StageTimes stages() const { return sim::stage_times(scratch_); }  ///< of all steps
    std::size_t bytes() const { return sim::memory_bytes(pile_.model, pile_.state, scratch_); }
    int batch() const { return batch_; }
    void set_batch(int batch) { batch_ = batch; }

    sim::StepReport report;  ///< of the last batch

 private:
    Pile pile_;
    sim::Scratch scratch_;
    int threads_, batch_;
};

std::string shares(const sim::StageTimes& t) {
    const double percent = 100 / (t.find_pairs + t.find_contacts + t.contact_loads + t.move_bodies + t.measure);
    return fmt::format(
        "find pairs {:.0f} %, find contacts {:.0f} %, contact loads {:.0f} %, move bodies {:.0f} %, measure {:.0f} %",
        t.find_pairs * percent, t.find_contacts * percent, t.contact_loads * percent, t.move_bodies * percent,
        t.measure * percent);
}

/// Body-steps per second with every number of threads, its ratio to that of one thread, memory per block.
void measure_pile(const Setting& setting, const std::string& name, const Pile& pile, int warm_steps,
                  std::vector<Result>& results) {
    const double blocks = static_cast<double>(std::ranges::count(pile.model.bodies.drive, body::Drive::free));
    for (const int threads : setting.thread_counts) {
        PileRun run(pile, threads, warm_steps);
        const Timing step = run.time_steps();
        const double rate = blocks / step.median;
        const auto per_block = [&](std::int64_t count) { return static_cast<double>(count) / blocks; };
        std::string note;
        if (threads == 1) {
            note = fmt::format("{:.4g} scaled to the reference core; ", rate / core_speed(setting.machine));
        }
        note += fmt::format("{:.0f} blocks, {:.2f} contacts and {:.2f} candidates a block, fastest {:.2g} m/s; {}; {}",
                            blocks, per_block(run.report.contact_count), per_block(run.report.pair_count),
                            run.report.max_speed, shares(run.stages()), spread(step));
        results.push_back({name, threads, rate, "body-steps/s", note});
        if (threads == 1) {
            results.push_back({name + ".memory", threads, static_cast<double>(run.bytes()) / blocks, "B/block",
                               "Model, State and Scratch"});
        } else {
            PileRun one(pile, 1, warm_steps), many(pile, threads, warm_steps);
            many.set_batch(one.batch());
            add_speedup(
                name, threads, [&] { one.step_batch(); }, [&] { many.step_batch(); }, results, 15);
        }
    }
}

}  // namespace

void pile_735_cubes(const Setting& setting, std::vector<Result>& results) {
    measure_pile(setting, "pile.735_cubes", settled_cubes(), 50, results);
}
void pile_1k(const Setting& setting, std::vector<Result>& results) {
    measure_pile(setting, "pile.1k", mixed_bed(1, 1), 50, results);
}
void pile_10k(const Setting& setting, std::vector<Result>& results) {
    measure_pile(setting, "pile.10k", mixed_bed(5, 2), 30, results);
}
void pile_100k(const Setting& setting, std::vector<Result>& results) {
    measure_pile(setting, "pile.100k", mixed_bed(10, 10), 10, results);
}
void pile_voronoi(const Setting& setting, std::vector<Result>& results) {
    measure_pile(setting, "pile.voronoi", voronoi_pack(2000), 30, results);
}

}  // namespace riprap::bench
