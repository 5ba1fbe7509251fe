// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/bench/pile_scene.hpp"

namespace riprap::bench {

namespace {

/// What one number of threads made of a pile.
struct PileFigures {
    Timing step;  ///< [s]
    sim::StepReport report;
    sim::StageTimes stages;  ///< of all steps
    std::size_t bytes;
};

/// Steps a copy of `pile`: first some steps that fill caches and buffers, then batches of about a fifth of a second.
PileFigures time_pile(Pile pile, int threads, int warm_steps) {
    const ThreadScope scope(threads);
    sim::Scratch scratch;
    PileFigures figures{};
    advance(pile, scratch, 1);
    const double start = now();
    figures.report = advance(pile, scratch, warm_steps);
    const double warm_seconds = std::max(1e-6, now() - start);
    const int batch = std::max(2, static_cast<int>(0.2 * warm_steps / warm_seconds));
    figures.step = time_calls([&] { figures.report = advance(pile, scratch, batch); }, {7, 1.0});
    for (double* time : {&figures.step.median, &figures.step.low, &figures.step.high}) {
        *time /= batch;
    }
    figures.stages = sim::stage_times(scratch);
    figures.bytes = sim::memory_bytes(pile.model, pile.state, scratch);
    return figures;
}

std::string shares(const sim::StageTimes& t) {
    const double percent = 100 / (t.find_pairs + t.find_contacts + t.contact_loads + t.move_bodies + t.measure);
    return fmt::format(
        "find pairs {:.0f} %, find contacts {:.0f} %, contact loads {:.0f} %, move bodies {:.0f} %, measure {:.0f} %",
        t.find_pairs * percent, t.find_contacts * percent, t.contact_loads * percent, t.move_bodies * percent,
        t.measure * percent);
}

/// Body-steps per second with every number of threads, the ratio of the last to the first, memory per block.
void measure_pile(const Setting& setting, const std::string& name, const Pile& pile, int warm_steps,
                  std::vector<Result>& results) {
    const double blocks = static_cast<double>(std::ranges::count(pile.model.bodies.drive, body::Drive::free));
    double first_rate = 0;
    for (const int threads : setting.thread_counts) {
        const PileFigures figures = time_pile(pile, threads, warm_steps);
        const double rate = blocks / figures.step.median;
        const auto per_block = [&](std::int64_t count) { return static_cast<double>(count) / blocks; };
        std::string note;
        if (threads == 1) {
            first_rate = rate;
            note = fmt::format("{:.4g} scaled to the reference core; ", rate / core_speed(setting.machine));
        }
        note += fmt::format("{:.0f} blocks, {:.2f} contacts and {:.2f} candidates a block, fastest {:.2g} m/s; {}; {}",
                            blocks, per_block(figures.report.contact_count), per_block(figures.report.pair_count),
                            figures.report.max_speed, shares(figures.stages), spread(figures.step));
        results.push_back({name, threads, rate, "body-steps/s", note});
        if (threads == 1) {
            results.push_back({name + ".memory", threads, static_cast<double>(figures.bytes) / blocks, "B/block",
                               "Model, State and Scratch"});
        } else {
            results.push_back({name + ".speedup", threads, rate / first_rate, "-",
                               "over one thread; both must have the machine to themselves"});
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
