// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/validation/case_trial.hpp"
#include "riprap/validation/zhao/cases.hpp"

namespace riprap::validation::zhao {

namespace {

constexpr double drop = 2.592;        // of the lower edge onto the ridge [m]
constexpr double gravity = 10;        // [m/s^2]
constexpr double impact_speed = 7.2;  // sqrt(2 g drop) [m/s]

/// Result of one fall.
struct Fall {
    double touch_time{std::nan("")};       ///< first contact [s]
    double leave_time{std::nan("")};       ///< end of contact [s]
    double depth{0};                       ///< deepest position of the lower edge below the ridge [m]
    double apex{-10};                      ///< highest position of the lower edge after the impact [m]
    double energy_error{0};                ///< |E - E_0|/E_0 over the whole run [-]
    double returned_energy{std::nan("")};  ///< kinetic + potential at separation over that at first touch [-]
    double sideways{0};                    ///< largest of |v_x|, |v_z| [m/s] and |omega| [rad/s] after separation
    double dt{0};                          ///< [s]
    Vec3 velocity{};                       ///< at separation [m/s]
    Vec3 spin{};                           ///< at separation [rad/s]
    std::vector<double> time, kinetic, potential, contact, height, lateral;  ///< [s], [J], [m]
};

/// Energy above that of the block at rest on the ridge [J].
double mechanical(const sim::Ledger& ledger, double ground) { return ledger.kinetic + ledger.potential - ground; }

Fall fall(const CaseSetting& setting, bool is_parallel, bool is_fdem) {
    std::vector<std::string> overrides;
    if (is_parallel) {
        overrides.emplace_back("body.falling.orientation={axis_angle={axis=[0,1,0],angle_deg=90}}");
    }
    if (is_fdem) {
        // In a regular tetrahedron the FDEM field is a quarter of the distance field: four times the stiffness.
        overrides.insert(overrides.end(), {"solid.potential='fdem'", "material.rock.normal_stiffness=8e7"});
    }
    Trial trial = trial_of(setting, overrides);
    const BodyId body = trial.body("falling");
    const double start = trial.position(body).y;
    const double mass = trial.model().bodies.mass[static_cast<std::size_t>(body.value)];
    const double ground = mass * gravity * (start - drop);

    Fall fall;
    fall.dt = trial.dt();
    double first_total = 0, energy_at_touch = 0;
    bool was_touching = false, has_left = false;
    trial.run_until(1.6, [&](const Trial& now) {
        const sim::Ledger& ledger = now.report().ledger;
        const double total = mechanical(ledger, ground) + ledger.elastic;
        const double edge = now.position(body).y - start + drop;
        first_total = fall.time.empty() ? total : first_total;
        fall.energy_error = std::max(fall.energy_error, std::abs(total / first_total - 1));
        const bool is_touching = now.report().contact_count > 0;
        if (is_touching && !was_touching && !has_left) {
            fall.touch_time = now.time();
        } else if (!is_touching && !was_touching && !has_left && std::isnan(fall.touch_time)) {
            energy_at_touch = mechanical(ledger, ground);
        } else if (!is_touching && was_touching && !has_left) {
            has_left = true;
            fall.leave_time = now.time();
            fall.returned_energy = mechanical(ledger, ground) / energy_at_touch;
            fall.velocity = now.velocity(body);
            fall.spin = now.angular_velocity(body);
        }
        was_touching = is_touching;
        fall.depth = std::max(fall.depth, -edge);
        if (has_left) {
            const Vec3& v = now.velocity(body);
            fall.sideways = std::max({fall.sideways, std::abs(v.x), std::abs(v.z), norm(now.angular_velocity(body))});
            fall.apex = std::max(fall.apex, edge);
        }
        fall.time.push_back(ledger.time);
        fall.kinetic.push_back(ledger.kinetic);
        fall.potential.push_back(ledger.potential - ground);
        fall.contact.push_back(ledger.elastic);
        fall.height.push_back(edge);
        fall.lateral.push_back(now.position(body).z);
    });
    return fall;
}

void judge_straight_return(const char* name, const Fall& fall, double depth, CaseReport& report) {
    const auto of = [name](const char* what) { return fmt::format("{}, {}", name, what); };
    const std::string no_number = "returns straight up";
    report.judge({of("time of first touch"), "s", 0.72, 0.72, {}}, fall.touch_time, Absolute{1e-3});
    report.judge({of("deepest overlap"), "m", {}, depth, {}}, fall.depth, Relative{1e-3});
    report.judge({of("energy returned at separation"), "-", std::string("KE as at 0.72 s"), 1.0, {}},
                 fall.returned_energy, Absolute{1e-4});
    report.judge_below({of("sideways speed and spin after impact"), "m/s, rad/s", no_number, {}, {}}, fall.sideways,
                       1e-8 * impact_speed);
    // The energy that leapfrog steps keep is not the sampled one: in a spring of frequency omega they differ by up to
    // (omega dt)^2/4 of the energy while the spring is loaded, and by nothing afterwards.
    const double omega = M_PI / (fall.leave_time - fall.touch_time);
    const double swing = 0.25 * omega * omega * fall.dt * fall.dt;
    const Reference energy{of("change of kinetic + potential + contact energy"), "-", {}, 0.0, {}, Kind::bookkeeping};
    report.judge(energy, fall.energy_error, 0, 1e-4,
                 CloseBand{0, 2 * swing,
                           fmt::format("leapfrog's swing inside the contact, (omega dt)^2/4 = {:.2g}; before and after "
                                       "it the energy is the same to {:.1g}",
                                       swing, std::abs(fall.returned_energy - 1))});
    report.judge({of("height of return"), "m", no_number, drop, {}}, fall.apex, Relative{1e-3});
}

void plot_energies(const CaseSetting& setting, const char* name, const char* title, const Fall& fall) {
    Plot plot;
    plot.title = title;
    plot.subtitle = "distance potential; contact energy = k_n times the integral of both fields over the overlap";
    plot.x.label = "time [s]";
    plot.y.label = "energy above the block at rest on the ridge [J]";
    std::vector<double> total(fall.time.size());
    for (std::size_t i = 0; i < total.size(); ++i) {
        total[i] = fall.kinetic[i] + fall.potential[i] + fall.contact[i];
    }
    plot.curves = {{"kinetic", fall.time, fall.kinetic, CurveStyle::line, -1},
                   {"potential", fall.time, fall.potential, CurveStyle::line, -1},
                   {"contact", fall.time, fall.contact, CurveStyle::line, -1},
                   {"sum", fall.time, total, CurveStyle::dashed, 7}};
    write_plot(setting, name, plot);
}

void plot_paths(const CaseSetting& setting, const Fall& distance, const Fall& fdem) {
    Plot plot;
    plot.title = "Path of the falling tetrahedron, edge parallel to the ridge";
    plot.subtitle =
        "faces of unequal area: the FDEM potential throws the block sideways, the distance potential does not";
    plot.x.label = "sideways z [m]";
    plot.y.label = "height of the lower edge [m]";
    plot.curves = {{"FDEM potential", fdem.lateral, fdem.height, CurveStyle::line, 1},
                   {"distance potential", distance.lateral, distance.height, CurveStyle::dashed, 0}};
    write_plot(setting, "two_tetrahedra_paths", plot);
}

}  // namespace

void two_tetrahedra(const CaseSetting& setting, CaseReport& report) {
    const Fall crossed = fall(setting, false, false);
    const Fall parallel = fall(setting, true, false);
    judge_straight_return("crossed edges", crossed, 0.157396, report);
    report.judge({"crossed edges, rebound speed", "m/s", impact_speed, 7.1997, {}}, crossed.velocity.y, Relative{1e-3});
    judge_straight_return("parallel edges", parallel, 0.0822, report);

    // The comparison method deflects the block; its numbers come from an independent computation, not from the paper.
    const Fall fdem_crossed = fall(setting, false, true), fdem_parallel = fall(setting, true, true);
    const std::string deflects = "sideways deflection";
    report.judge({"FDEM crossed, v_z", "m/s", deflects, 0.0647, {}}, fdem_crossed.velocity.z, Relative{0.02});
    report.judge({"FDEM crossed, omega_x", "rad/s", deflects, 0.677, {}}, fdem_crossed.spin.x, Relative{0.02});
    report.judge({"FDEM crossed, deepest overlap", "m", {}, 0.1604, {}}, fdem_crossed.depth, Relative{0.02});
    report.judge({"FDEM parallel, v_y", "m/s", deflects, 3.14, {}}, fdem_parallel.velocity.y, Relative{0.02});
    report.judge({"FDEM parallel, v_z", "m/s", deflects, 3.83, {}}, fdem_parallel.velocity.z, Relative{0.02});
    report.judge({"FDEM parallel, omega_x", "rad/s", deflects, -24.0, {}}, fdem_parallel.spin.x, Relative{0.02});
    report.judge({"FDEM parallel, largest error of the energy over the run", "-", {}, 0.0, {}, Kind::bookkeeping},
                 fdem_parallel.energy_error, 0, 1e-3);

    plot_energies(setting, "two_tetrahedra_energy_crossed", "Energies while two tetrahedra collide, crossed edges",
                  crossed);
    plot_energies(setting, "two_tetrahedra_energy_parallel", "Energies while two tetrahedra collide, parallel edges",
                  parallel);
    plot_paths(setting, parallel, fdem_parallel);
}

}  // namespace riprap::validation::zhao
