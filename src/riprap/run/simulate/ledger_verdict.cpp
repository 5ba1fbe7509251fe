// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/ledger_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {

namespace {

/// Energy of motion of a body [J].
double kinetic_energy(const sim::Model& model, const sim::State& state, std::int32_t body) {
    const Vec3 spin = angular_velocity(model.bodies, state.bodies, BodyId{body});
    return 0.5 * model.bodies.mass[at(body)] * norm_squared(state.bodies.velocity[at(body)]) +
           0.5 * dot(spin, state.bodies.angular_momentum[at(body)]);
}

/// Names the free body with the largest energy of motion; empty where none moves.
std::string most_energetic(const sim::Model& model, const sim::State& state) {
    std::int32_t most = -1;
    double largest = 0;
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        if (is_free(model.bodies, BodyId{b}, state.time)) {
            const double energy = kinetic_energy(model, state, b);
            if (!(energy <= largest)) {
                largest = energy;
                most = b;
            }
        }
    }
    return most < 0 ? ""
                    : fmt::format("; '{}' moves with {:.3g} {}, more than any other body",
                                  model.bodies.name(BodyId{most}), largest, sim::unit_in("J", model.bodies.is_planar));
}

/// Energy of all free bodies after a fall by a tenth of their inscribed radii [J].
double short_fall(const sim::Model& model, const sim::State& state) {
    const double gravity = norm(model.gravity.at(state.time));
    double energy = 0;
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        const std::int32_t part = model.bodies.part_begin[at(b)];
        if (is_free(model.bodies, BodyId{b}, state.time) && part < model.bodies.part_begin[at(b) + 1]) {
            const double radius = model.shapes.view(model.bodies.parts[at(part)].shape).inscribed_radius;
            energy += std::isfinite(radius) ? 0.1 * radius * gravity * model.bodies.mass[at(b)] : 0;
        }
    }
    return energy;
}

/// Largest of the energies that the balance adds up: its round-off is a share of them [J].
double energy_there(const sim::Ledger& ledger) {
    const sim::FluidLedger& fluid = ledger.fluid;
    double largest = ledger.turnover;
    for (const double energy : {ledger.kinetic, ledger.potential, ledger.external, ledger.driven, ledger.gravity_change,
                                ledger.released, fluid.kinetic, fluid.potential, fluid.internal, fluid.work_on_solids,
                                fluid.work_external, fluid.transported}) {
        largest = std::max(largest, std::abs(energy));
    }
    return largest;
}

/// Energy that lifts all water by one spacing of particles: when it is let go, its lattice settles by hundredths of
/// that [J].
double grain_of(const sim::Ledger& ledger, const sim::Model& model) {
    return ledger.fluid.mass * norm(model.gravity.value) * sim::grain(model);
}

/// Energy that lifts all water by the smallest cell of a grid, 0 without one: how its surface lies in the cells is
/// known to a share of them. Says nothing of bodies, whose residual it does not excuse [J].
double cell_grain_of(const sim::Ledger& ledger, const sim::Model& model) {
    return ledger.fluid.mass * norm(model.gravity.value) * sim::cell_width(model);
}

/// Energy of one grain of the fluid at the speed of the fastest body that is driven: a paddle has done hardly any work
/// on still water when it first touches it, and without gravity nothing else is there to compare with [J].
double energy_of_driven_grain(const sim::Model& model, const sim::State& state) {
    const double mass = sim::grain_mass(model);
    double fastest = 0;
    for (std::int32_t b = 0; mass > 0 && b < model.bodies.size(); ++b) {
        if (model.bodies.drive[at(b)] == body::Drive::driven) {
            fastest = std::max(fastest, norm_squared(state.bodies.velocity[at(b)]));
        }
    }
    return 0.5 * mass * fastest;
}

/// Energy that the artificial terms made, all taken together, below zero where they took some; or the largest rise of
/// an energy that came from nowhere, by an account that is what its balance lacks: what was lost before does not make
/// up for it [J].
double made_from_nothing(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state) {
    double artificial = 0;
    for (const sim::LedgerLine& line : sim::ledger_lines()) {
        artificial += line.is_artificial && has_line(model, line) ? value_of(line, model, ledger) : 0;
    }
    const sim::Accounts accounts = accounts_of(model);
    const std::ptrdiff_t rest = rest_account(accounts);
    const double now = rest < 0 ? 0 : -ledger.fluid.own[static_cast<std::size_t>(rest)];
    return std::max({-artificial, now, largest_rise(accounts, state.ledger)});
}

/// Share of all that there is that the first steps of methods that book over several steps may miss [-].
constexpr double most_at_first = 0.5;

/// What counts beside a residual, and what share of it the first steps may miss.
struct Scale {
    double counted;    ///< [J]
    double tolerance;  ///< [-]
};

Scale scale_of(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state, bool is_first) {
    const double kinetic = ledger.kinetic + ledger.fluid.kinetic;
    const double counted = std::max({ledger.turnover, kinetic, grain_of(ledger, model),
                                     energy_of_driven_grain(model, state), is_first ? short_fall(model, state) : 0});
    // What some methods dissipate is known over several steps only: before these are over more can be missing.
    return {counted, is_first && !sim::books_every_step(model) ? std::max(most_at_first, model.output.ledger_tolerance)
                                                               : model.output.ledger_tolerance};
}

}  // namespace

double missed_share(const sim::Ledger& ledger, std::int64_t steps) {
    constexpr double rounding = 0.5 * std::numeric_limits<double>::epsilon();
    const double round_off = static_cast<double>(steps) * rounding * energy_there(ledger);
    return std::abs(ledger.residual) <= round_off ? 0 : ledger.residual / ledger.turnover;
}

std::string ledger_problem(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state,
                           std::int64_t step) {
    constexpr double round_off = 1e-9;
    if (!ledger.has_energy) {
        return "";
    }
    if (!std::isfinite(ledger.residual) || !std::isfinite(ledger.turnover)) {
        return fmt::format(
            "the energy of the scene is no finite number at t = {:.6g} s{}; sizes, speeds, motions and "
            "loads whose squares are below 1e300",
            ledger.time, most_energetic(model, state));
    }
    const bool is_first = step <= first_steps;
    const auto [counted, tolerance] = scale_of(ledger, model, state, is_first);
    const double first = is_first ? 0 : first_residual(accounts_of(model), state.ledger);
    const double miss = ledger.residual - first, residual = std::abs(miss);
    const std::string unit = sim::unit_in("J", model.bodies.is_planar);
    if (residual <= round_off * energy_there(ledger) || residual <= tolerance * counted) {
        const double made = made_from_nothing(ledger, model, state);
        const double of_fluid = std::max(counted, cell_grain_of(ledger, model));
        return is_first || made <= most_artificial * of_fluid
                   ? ""
                   : fmt::format(
                         "the numerics made {:.3g} {} of {:.3g} {} that count as turned over at "
                         "t = {:.6g} s, more than {:.3g} % of it{}",
                         made, unit, of_fluid, unit, ledger.time, 100 * most_artificial, most_energetic(model, state));
    }
    return fmt::format(
        "the energy ledger misses {:.3g} {} of {:.3g} {} that count as turned over at t = {:.6g} s, more than "
        "output.ledger_tolerance allows ({:.3g} of it){}",
        miss, unit, counted, unit, ledger.time, tolerance, most_energetic(model, state));
}

double accepted_miss(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state) {
    const double most = model.output.ledger_tolerance * scale_of(ledger, model, state, true).counted;
    return ledger.has_energy ? std::clamp(ledger.residual, -most, most) : 0;
}

std::string artificial_text(const sim::Ledger& ledger, const sim::Model& model) {
    const double counted = std::max(ledger.turnover, grain_of(ledger, model));
    if (!ledger.has_energy || !(ledger.fluid.artificial > most_artificial * counted)) {
        return "";
    }
    std::vector<std::pair<double, std::string>> parts;
    for (const sim::LedgerLine& line : sim::ledger_lines()) {
        const double size = line.is_artificial && has_line(model, line) ? std::abs(value_of(line, model, ledger)) : 0;
        if (size > 0) {
            parts.emplace_back(size, line.name);
        }
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string text;
    for (const auto& [size, name] : parts) {
        text += fmt::format("{}{} {:.3g} %", text.empty() ? "" : ", ", name, 100 * size / counted);
    }
    return fmt::format(
        "artificial terms of the fluid took {:.3g} % of the energy turned over, more than {:.3g} % ({}): a smaller "
        "spacing has less",
        100 * ledger.fluid.artificial / counted, 100 * most_artificial, text);
}

}  // namespace riprap::run
