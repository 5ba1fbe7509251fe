// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/chain.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double edge = 0.5, mass = 75, speed = 50, modulus = 2e9;  // [m], [kg], [m/s], [Pa]

/// Stiffness of two flat faces: k_n S/r per side that acts [N/m].
double face_stiffness(contact::Sides sides) {
    return modulus * edge * edge / (0.5 * edge) * (sides == contact::Sides::both ? 2 : 1);
}

CubeChain chain_of(contact::Sides sides, int count, bool has_edge_effect) {
    return {count, mass, edge, face_stiffness(sides), speed, has_edge_effect};
}

/// Time at which a gap opens, between two steps [s].
class OpeningGap {
 public:
    /// `overlap` of the pair now; true once, when it has been pushed together and comes apart.
    bool look(double now, double overlap) {
        const bool opens = has_touched_ && overlap <= 0 && previous_ > 0;
        if (opens) {
            time = previous_time_ + (now - previous_time_) * previous_ / (previous_ - overlap);
        }
        has_touched_ = has_touched_ || overlap > 1e-3 * speed * std::sqrt(mass / 4e9);
        previous_ = overlap;
        previous_time_ = now;
        return opens;
    }
    double time{std::nan("")};

 private:
    bool has_touched_{false};
    double previous_{0}, previous_time_{0};
};

/// An isolated row of six cubes, frictionless, without gravity.
struct RowAnswer {
    double separation_time{std::nan("")}, last_speed{std::nan("")};
    double momentum_error{0}, energy_error{0}, dt{0};
};

RowAnswer hit_row(contact::Sides sides) {
    SceneBuilder scene;
    scene.model.dem()->contact.sides = sides;
    scene.add_material({.name = "rock", .density = 600, .normal_stiffness = modulus});
    const ShapeId cube = scene.add_shape(geometry::cube(edge));
    BodyId body{};
    BodyId before_last{};
    for (int i = 0; i < 7; ++i) {
        BodySpec spec;
        spec.name = fmt::format("block{}", i);
        spec.shape = cube;
        spec.pose.position.y = edge * i;
        spec.velocity.y = i == 0 ? speed : 0;
        before_last = body;
        body = scene.add_body(spec);
    }
    scene.model.time.end = 2e-3;
    Trial trial(std::move(scene));
    RowAnswer answer;
    answer.dt = trial.dt();
    OpeningGap gap;
    trial.run_until(2e-3, [&](const Trial& now) {
        if (gap.look(now.time(), now.position(before_last).y + edge - now.position(body).y)) {
            answer.separation_time = gap.time;
            answer.last_speed = now.velocity(body).y;
        }
        const sim::Ledger& ledger = now.report().ledger;
        answer.momentum_error = std::max(answer.momentum_error, norm(ledger.momentum - Vec3{0, mass * speed, 0}));
        answer.energy_error =
            std::max(answer.energy_error, std::abs(ledger.kinetic + ledger.elastic - 0.5 * mass * speed * speed));
    });
    answer.momentum_error /= mass * speed;
    answer.energy_error /= 0.5 * mass * speed * speed;
    return answer;
}

/// The pillar: what the front block on the axis of the impact does, and the energy.
struct PillarAnswer {
    double separation_time{std::nan("")}, speed_at_separation{std::nan("")};
    double dt{0};           ///< [s]
    double energy_rise{0};  ///< largest climb of the total energy above an earlier value, over the impact energy [-]
    std::vector<double> time, forward, energy;
    std::vector<Curve> frames;
};

void take_frame(const Trial& now, double time, PillarAnswer& answer) {
    Curve frame;
    frame.label = fmt::format("t = {:.2f} s", time);
    frame.style = CurveStyle::points;
    for (const Vec3& position : now.state().bodies.position) {
        if (std::abs(position.x) < 0.3 && position.z > 0.01) {  // the slice x = 0 that the projectile hits
            frame.x.push_back(-position.y);
            frame.y.push_back(position.z);
        }
    }
    answer.frames.push_back(std::move(frame));
}

PillarAnswer hit_pillar(const CaseSetting& setting, double end) {
    Trial trial = trial_of(setting);
    const BodyId front = trial.body("pillar[109]"), behind = trial.body("pillar[112]");
    PillarAnswer answer;
    answer.dt = trial.dt();
    OpeningGap gap;
    double lowest = 0;
    std::vector<double> frame_times{0.03, 0.14, 0.20, 0.72};
    take_frame(trial, 0, answer);
    trial.run_until(end, [&](const Trial& now) {
        if (std::isnan(gap.time) && gap.look(now.time(), now.position(front).y + edge - now.position(behind).y)) {
            answer.separation_time = gap.time;
            answer.speed_at_separation = -now.velocity(front).y;
        }
        const sim::Ledger& ledger = now.report().ledger;
        const double total = ledger.kinetic + ledger.potential + ledger.elastic + ledger.shear;
        lowest = answer.time.empty() ? total : std::min(lowest, total);
        answer.energy_rise = std::max(answer.energy_rise, (total - lowest) / (0.5 * mass * speed * speed));
        answer.time.push_back(now.time());
        answer.forward.push_back(-now.velocity(front).y);
        answer.energy.push_back(total);
        if (!frame_times.empty() && now.time() >= frame_times.front() - 0.5 * now.dt()) {
            take_frame(now, frame_times.front(), answer);
            frame_times.erase(frame_times.begin());
        }
    });
    return answer;
}

/// The energy that leapfrog steps keep differs from the sampled one by up to (omega dt)^2/4 of it while the springs are
/// loaded; omega^2 = 2 K/m of a pair.
CloseBand swing_band(contact::Sides sides, double dt) {
    const double swing = 0.25 * 2 * face_stiffness(sides) / mass * dt * dt;
    return {0, swing, fmt::format("leapfrog's swing inside the contacts, (omega dt)^2/4 = {:.2g}", swing)};
}

void judge_row(const char* name, contact::Sides sides, CaseReport& report) {
    const RowAnswer row = hit_row(sides);
    const ChainAnswer exact = solve_chain(chain_of(sides, 6, true)), linear = solve_chain(chain_of(sides, 6, false));
    const auto of = [name](const char* what) { return fmt::format("row of 6, {}, {}", name, what); };
    report.judge({of("separation of the last block"), "s", 1.63e-3, exact.separation_time,
                  fmt::format("the paper's theory (1.64e-3 s = 3 m/1819.5 m/s) takes a stiffness in N/m for a modulus; "
                              "linear chain: {:.4g} s",
                              linear.separation_time)},
                 row.separation_time, Relative{0.01});
    report.judge({of("speed of the last block over impact speed"), "-", {}, exact.last_speed / speed, {}},
                 row.last_speed / speed, Relative{0.01});
    report.judge_below({of("change of momentum"), "-", {}, {}, {}, Kind::bookkeeping}, row.momentum_error, 1e-12);
    report.judge({of("change of energy"), "-", {}, 0.0, {}, Kind::bookkeeping}, row.energy_error, 0, 1e-3,
                 swing_band(sides, row.dt));
}

void plot_pillar(const CaseSetting& setting, const PillarAnswer& pillar, double chain_time) {
    Plot plot;
    plot.title = "Pillar impact: forward speed of the front block on the axis";
    plot.subtitle = "3 x 6 x 13 cubes hit at 50 m/s; dashed: separation in the chain of six blocks";
    plot.x.label = "time [ms]";
    plot.y.label = "forward speed [m/s]";
    Curve curve{"front block", {}, {}, CurveStyle::line, -1};
    for (std::size_t i = 0; i < pillar.time.size() && pillar.time[i] < 0.01; ++i) {
        curve.x.push_back(1e3 * pillar.time[i]);
        curve.y.push_back(pillar.forward[i]);
    }
    const double top = *std::max_element(curve.y.begin(), curve.y.end());
    plot.curves = {curve, {"chain: separation", {1e3 * chain_time, 1e3 * chain_time}, {0, top}, CurveStyle::dashed, 7}};
    write_plot(setting, "pillar_impact_front_block", plot);

    Plot frames;
    frames.title = "Pillar impact: centres of the blocks in the slice of the impact";
    frames.subtitle = "the projectile comes from the left at 50 m/s";
    frames.x.label = "forward [m]";
    frames.y.label = "height [m]";
    frames.has_equal_scales = true;
    frames.curves = pillar.frames;
    write_plot(setting, "pillar_impact_frames", frames);
}

}  // namespace

void pillar_impact(const CaseSetting& setting, CaseReport& report) {
    judge_row("both sides", contact::Sides::both, report);
    judge_row("one side", contact::Sides::contactor, report);

    const PillarAnswer pillar = hit_pillar(setting, setting.is_full ? 0.73 : 0.145);
    const double chain_time = solve_chain(chain_of(contact::Sides::both, 6, true)).separation_time;
    report.judge({"pillar, separation of the front block", "s", 1.63e-3, chain_time,
                  "size of the pillar and mass of the projectile are not in the paper"},
                 pillar.separation_time, Relative{0.1});
    report.judge({"pillar, forward speed of the front block at separation",
                  "m/s",
                  std::string("front blocks fly forward"),
                  {},
                  {}},
                 pillar.speed_at_separation, 1e-3, speed);
    report.judge(
        {"pillar, largest rise of the total energy over the impact energy", "-", {}, 0.0, {}, Kind::bookkeeping},
        pillar.energy_rise, 0, 1e-3, swing_band(contact::Sides::both, pillar.dt));
    plot_pillar(setting, pillar, chain_time);
}

}  // namespace riprap::validation::zhao
