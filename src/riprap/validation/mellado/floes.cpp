// SPDX-License-Identifier: Apache-2.0
// Dam breaks over dry and wet beds with four, nine and no blocks afloat [Mellado2021, 3] [Amaro2021].
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mellado/floe_run.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

/// Judges what all eight scenarios have in common, and the four without blocks.
void judge_flow(CaseReport& report, const std::string& run, const FloeRun& floes, const FloeOutcome& outcome) {
    if (floes.depth == 0) {
        report.judge({run + ": front reaches the downstream wall", "s", 0.41, {}, "the article's first picture"},
                     outcome.arrival, 0.37, 0.45);
    } else {
        report.state({run + ": front reaches the downstream wall", "s", ""}, outcome.arrival);
    }
    if (floes.end >= rest_time) {
        report.judge({run + ": final level", "m", {}, outcome.expected_level, "volume over area; mean of 0.5 s"},
                     outcome.level, Relative{0.01});
    } else {
        report.state({run + ": mean level of the last half second over that of the volume, still in motion", "-", ""},
                     outcome.level / outcome.expected_level);
    }
    water::judge_ledger(report, *outcome.trial, run);
    const sim::Ledger& ledger = outcome.trial->report().ledger;
    report.judge_below({run + ": momentum that the ledgers miss, over weight of water times time",
                        "-",
                        {},
                        0.0,
                        {},
                        Kind::bookkeeping},
                       (norm(ledger.momentum_residual) + norm(ledger.fluid.momentum_residual)) /
                           (ledger.fluid.mass * 9.81 * outcome.trial->now()),
                       25.0 / (1 << 24));
    report.state({run + ": wall-clock time of a simulated second", "s", ""},
                 outcome.trial->wall_seconds() / outcome.trial->now());
    report.state({run + ": processor time of a simulated second", "s", ""},
                 outcome.trial->processor_seconds() / outcome.trial->now());
}

void judge_arrivals(CaseReport& report, const std::array<FloeOutcome, 4>& outcomes) {
    double least = 1;
    for (std::size_t k = 1; k < bed_depths.size(); ++k) {
        least = std::min(least, outcomes[k].arrival - outcomes[k - 1].arrival);
    }
    report.judge({"least delay of the front by a deeper bed", "s", {}, {}, "deeper beds, slower fronts"}, least, 0, 1);
}

std::string bed(double depth) { return depth == 0 ? "dry" : fmt::format("{:g} mm", 1000 * depth); }

/// Largest x of a block before 1.5 s in three experiments, and of the article's model [m]; when, where they say so [s].
struct Excursion {
    std::size_t depth;
    std::string_view block;
    double low, high, article;
    double time{0}, article_time{0};  ///< 0 = not told
};
constexpr std::array excursions_4{Excursion{0, "B1", 0.18, 0.18, 0.30}, Excursion{1, "B1", 0.20, 0.26, 0.28, 1.2, 1.1},
                                  Excursion{2, "B1", 0.18, 0.26, 0.23, 1.25, 1.1},
                                  Excursion{3, "B1", 0.08, 0.11, 0.12, 0.8, 0.8}};
constexpr std::array excursions_9{Excursion{0, "C1", 0.08, 0.22, 0.22}, Excursion{0, "C2", 0.33, 0.43, 0.43, 1.2},
                                  Excursion{1, "C1", 0.18, 0.18, 0.22}};

/// The article's model is up to 0.15 s early.
void judge_time(CaseReport& report, const FloeOutcome& outcome, const Excursion& e) {
    constexpr double band = 0.15;
    const double time = outcome.trial->time()[outcome.row_of_farthest(std::string(e.block))];
    const std::string note = fmt::format("experiments at about {} s; the article's largest error", e.time);
    report.judge({fmt::format("{}: time of the largest x of {} before 1.5 s", bed(bed_depths[e.depth]), e.block),
                  "s",
                  e.article_time > 0 ? Published(e.article_time) : Published(),
                  {},
                  note},
                 time, e.time - band, e.time + band);
}

void judge_excursions(CaseReport& report, const std::array<FloeOutcome, 4>& outcomes, std::span<const Excursion> all) {
    for (const Excursion& e : all) {
        const double x = outcomes[e.depth].farthest(std::string(e.block));
        const std::string name = fmt::format("{}: largest x of {} before 1.5 s", bed(bed_depths[e.depth]), e.block);
        report.judge(
            {name, "m", e.article, {}, fmt::format("experiments {} to {} m, widened by 0.04 m", e.low, e.high)}, x,
            e.low - 0.04, e.high + 0.04);
        const double error = std::max({0.0, e.article - e.high, e.low - e.article});
        if (error > 0) {
            report.judge_below(
                {name + ", beyond its experiments; the article's model", "m", error, 0.0, "to be beaten"},
                std::max({0.0, x - e.high, e.low - x}), error);
        }
        if (e.time > 0) {
            judge_time(report, outcomes[e.depth], e);
        }
    }
}

void judge_order(CaseReport& report, const std::array<FloeOutcome, 4>& outcomes, const std::string& block) {
    double worst = -1;
    for (std::size_t k = 1; k < bed_depths.size(); ++k) {
        worst = std::max(worst, outcomes[k].farthest(block) - outcomes[k - 1].farthest(block));
    }
    report.judge({fmt::format("{}: largest growth of its excursion with the depth of the bed", block),
                  "m",
                  {},
                  {},
                  "falls with depth"},
                 worst, -1, 0);
}

/// Blocks float at rest behind the closed gate.
void judge_freeboard(CaseReport& report, const CaseSetting& setting, const std::string& folder,
                     std::span<const std::string> blocks, FloeRun still = {}) {
    still.depth = 0;
    still.end = 1.0;
    still.more.emplace_back("body.gate.motion.linear.velocity=[0,0,0]");
    const FloeOutcome outcome = run_floes(setting, folder, still);
    // Behind the gate stands what the particles weigh: their level with the blocks afloat.
    report.judge({"mean freeboard behind the closed gate", "m", {}, 0.00257, "half a spacing"},
                 outcome.mean_height(blocks, 0.5) + 0.5 * floe_thickness - outcome.level_behind_gate,
                 Absolute{0.5 * floe_spacing(setting)});
}

/// The same in the resting end state over the deepest bed, above the free surface beside the blocks.
void judge_freeboard_at_rest(CaseReport& report, const CaseSetting& setting, const FloeOutcome& outcome,
                             std::span<const std::string> blocks) {
    report.judge({bed(bed_depths.back()) + ": mean freeboard in the resting end state",
                  "m",
                  {},
                  0.00257,
                  "half a spacing; mean of the last half second"},
                 outcome.mean_height(blocks, outcome.trial->now() - 0.5) + 0.5 * floe_thickness - outcome.level,
                 Absolute{0.5 * floe_spacing(setting)});
}

void plot_blocks(const CaseSetting& setting, const std::array<FloeOutcome, 4>& outcomes, const std::string& name,
                 std::span<const std::string> blocks) {
    Plot plot{name, "", {"time [s]", false}, {"x of the front row [m]", false}, {}, false};
    for (std::size_t k = 0; k < bed_depths.size(); ++k) {
        for (const std::string& block : blocks) {
            plot.curves.push_back({block + ", " + bed(bed_depths[k]), outcomes[k].trial->time(),
                                   outcomes[k].trial->column(block + ".position.x"), CurveStyle::line,
                                   static_cast<int>(k)});
        }
    }
    write_plot(setting, name, plot);
}

/// All four beds; the deepest until it rests.
std::array<FloeOutcome, 4> run_all(const CaseSetting& setting, CaseReport& report, const std::string& folder,
                                   FloeRun run) {
    std::array<FloeOutcome, 4> outcomes;
    run.end = std::max(run.end, setting.is_full ? rest_time : 0.0);
    for (std::size_t k = 0; k < bed_depths.size(); ++k) {
        run.depth = bed_depths[k];
        run.end = k + 1 == bed_depths.size() ? std::max(run.end, rest_time + 1) : run.end;
        outcomes[k] = run_floes(setting, folder, run);
        judge_flow(report, bed(bed_depths[k]), run, outcomes[k]);
    }
    judge_arrivals(report, outcomes);
    return outcomes;
}

}  // namespace

void floes_4(const CaseSetting& setting, CaseReport& report) {
    const std::vector<std::string> all{"A1", "A2", "B1", "B2"}, front{"B1", "B2"};
    const std::array<FloeOutcome, 4> outcomes = run_all(setting, report, "floes_4", {});
    judge_excursions(report, outcomes, excursions_4);
    judge_order(report, outcomes, "A2");
    judge_order(report, outcomes, "B2");
    judge_freeboard(report, setting, "floes_4", all);
    judge_freeboard_at_rest(report, setting, outcomes.back(), all);
    plot_blocks(setting, outcomes, "floes_4", front);
}

// The four by sph, with water in the gaps between floes, walls and bed, which the source leaves out.
void floes_sph(const CaseSetting& setting, CaseReport& report) {
    const std::vector<std::string> all{"A1", "A2", "B1", "B2"}, front{"B1", "B2"};
    const FloeRun wet{.fluid = "sph", .more = {"fluid.joint_pressure=true"}};
    const std::array<FloeOutcome, 4> outcomes = run_all(setting, report, "floes_4", wet);
    judge_excursions(report, outcomes, excursions_4);
    judge_order(report, outcomes, "A2");
    judge_order(report, outcomes, "B2");
    judge_freeboard(report, setting, "floes_4", all, wet);
    judge_freeboard_at_rest(report, setting, outcomes.back(), all);
    plot_blocks(setting, outcomes, "floes_sph", front);
}

void floes_9(const CaseSetting& setting, CaseReport& report) {
    const std::vector<std::string> all{"A1", "A2", "A3", "B1", "B2", "B3", "C1", "C2", "C3"}, front{"C1", "C2", "C3"};
    const std::array<FloeOutcome, 4> outcomes = run_all(setting, report, "floes_9", {});
    judge_excursions(report, outcomes, excursions_9);
    judge_freeboard(report, setting, "floes_9", all);
    judge_freeboard_at_rest(report, setting, outcomes.back(), all);
    plot_blocks(setting, outcomes, "floes_9", front);
}

// The dry one and the one over 25 mm at the published spacing, whatever is asked for: hours, saved on their way.
void floes_fine(const CaseSetting& setting, CaseReport& report) {
    CaseSetting full = setting;
    full.is_full = true;
    std::array<FloeOutcome, 4> outcomes;
    for (const std::size_t k : {0U, 2U}) {
        const FloeRun run{.depth = bed_depths[k], .end = 3.0};
        outcomes[k] = run_floes(full, "floes_4", run);
        judge_flow(report, bed(bed_depths[k]), run, outcomes[k]);
        judge_excursions(report, outcomes, {&excursions_4[k], 1});
    }
    report.judge({"delay of the front by the bed", "s", {}, {}, "deeper beds, slower fronts"},
                 outcomes[2].arrival - outcomes[0].arrival, 0, 1);
}

// The same without blocks: computed only in the source, so with blocks against without is all there is to judge.
void floes_none(const CaseSetting& setting, CaseReport& report) {
    const std::array<FloeOutcome, 4> outcomes = run_all(setting, report, "floes_none", {.end = 6.0});
    for (const std::size_t k : {0U, 3U}) {  // the beds of which the source says which of the two splashes higher
        const FloeOutcome loaded = run_floes(setting, "floes_4", {.depth = bed_depths[k], .end = late_end});
        if (k == 0) {
            report.judge({"dry: arrival with four blocks less that without",
                          "s",
                          {},
                          0.0,
                          "blocks hardly affect the early flow"},
                         loaded.arrival - outcomes[k].arrival, Absolute{0.04});
        }
        report.judge({fmt::format("{}: highest splash from {} to {} s, with four blocks over without",
                                  bed(bed_depths[k]), late, late_end),
                      "-",
                      {},
                      {},
                      "higher without, in pictures of the article; height above which a hundredth of the water stands"},
                     loaded.late_splash() / outcomes[k].late_splash(), 0, 1);
        report.state({fmt::format("{}: the same without blocks", bed(bed_depths[k])), "m", ""},
                     outcomes[k].late_splash());
    }
}

// One word each: three fluids by two solids.
void floe_methods(const CaseSetting& setting, CaseReport& report) {
    const double end = setting.is_full ? 1.5 : 0.4;
    std::vector<double> places;
    for (const std::string_view solid : {"sphere_dem", "distance_potential_dem"}) {
        for (const std::string_view fluid : {"sph", "wcmps", "mps"}) {
            const FloeRun run{.end = end, .fluid = fluid, .solid = solid};
            const FloeOutcome outcome = run_floes(setting, "floes_4", run);
            const std::string name = fmt::format("{}, {}", fluid, solid);
            judge_flow(report, name, run, outcome);
            places.push_back(outcome.trial->column("B2.position.x").back());
            report.state({name + ": x of B2 at the end", "m", ""}, places.back());
        }
    }
    const auto [low, high] = std::ranges::minmax(places);
    report.judge({"x of B2 at the end, spread over all six pairs of methods", "m", {}, 0.0, "a quarter of the block"},
                 high - low, 0, 0.018);
}

}  // namespace riprap::validation::mellado
