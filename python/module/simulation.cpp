// SPDX-License-Identifier: Apache-2.0
#include "simulation.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <optional>

#include "errors.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/io/output/output_kinds.hpp"
#include "riprap/run/simulate/outputs.hpp"
#include "riprap/run/simulate/state_hash.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double seconds_between_looks = 0.05;  // at Ctrl-C; after the last step Python looks itself

/// Marks a simulation as busy for its lifetime.
class Busy {
 public:
    explicit Busy(std::atomic<bool>& flag) : flag_(flag) {
        if (flag_.exchange(true)) {
            throw std::runtime_error("this simulation is being stepped by another thread");
        }
    }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
    ~Busy() { flag_ = false; }

 private:
    std::atomic<bool>& flag_;
};

/// Lets Python's signal handlers run; what they raise (KeyboardInterrupt) goes on as a C++ exception.
void look_at_signals() {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
}

bool has_reached(const run::Simulation& simulation, double time) {
    return simulation.state().time >= time - 1e-9 * simulation.state().previous_dt;
}

}  // namespace

Simulation::Simulation(const Case& of)
    : owned_(std::make_unique<run::Simulation>(of.loaded)),
      simulation_(owned_.get()),
      rows_(run::row_interval(of.loaded.model), 1) {}

run::Simulation& Simulation::read() const {
    if (simulation_ == nullptr) {
        throw std::runtime_error(
            "this simulation belongs to a run and can be read while that calls back; copy what is needed later");
    }
    if (is_stepping_) {
        throw std::runtime_error("this simulation is being stepped by another thread");
    }
    return *simulation_;
}

run::Simulation& Simulation::own() const {
    run::Simulation& simulation = read();
    if (owned_ == nullptr) {
        throw std::runtime_error("this simulation belongs to the run that called back, which steps it");
    }
    return simulation;
}

bool Simulation::is_due() const {
    const double dt = simulation_->next_dt();
    return rows_.is_due(simulation_->state().time + dt, dt);
}

std::int64_t Simulation::step(std::int64_t count, bool with_energy, double until) {
    run::Simulation& simulation = own();
    if (count < 0) {
        throw py::value_error("the number of steps is negative");
    }
    const Busy busy(is_stepping_);
    views_.let_go();
    std::int64_t taken = 0;
    const py::gil_scoped_release unlocked;
    const ScopedTimer timer(seconds_);
    std::optional<Timer> since_look;  // reading the clock costs as much as a small part of a small step
    while (taken < count && simulation.steps_left() > 0 && !has_reached(simulation, until)) {
        const double dt = simulation.next_dt();
        const bool ends = taken + 1 == count || has_reached(simulation, until - dt);
        const bool is_record = is_due();
        const bool is_whole = is_record || simulation.next_is_last() || (with_energy && ends);
        const run::StepOutcome outcome = simulation.step(is_whole ? sim::Measure::energy : sim::Measure::flow,
                                                         is_record ? run::Use::record : run::Use::look);
        if (outcome.kind == run::StepOutcome::Kind::refused) {
            throw NumericalError(outcome.why.with_remedy());
        }
        if (outcome.is_accepted()) {
            ++taken;
            rows_.meet(simulation.state().time, simulation.state().previous_dt);
        }
        if (taken < count && !since_look) {
            since_look.emplace();
        } else if (taken < count && since_look->seconds() > seconds_between_looks) {
            look_at_signals();
            since_look->restart();
        }
    }
    return taken;
}

void Simulation::set_end(double end) {
    run::Simulation& simulation = own();
    if (!(end > 0) || !std::isfinite(end)) {
        throw py::value_error("the end is a positive time [s]");
    }
    simulation.set_end(end, simulation.max_steps());
}

bool says_stop(const py::object& answer) {
    py::detail::make_caster<bool> truth;
    return truth.load(answer, false) && !static_cast<bool>(truth);
}

void Simulation::give_back() {
    views_.let_go();
    simulation_ = nullptr;
}

namespace {

double or_never(const std::optional<double>& until) { return until.value_or(never); }

/// Steps and calls back until there is nothing left to do or the callback says False.
std::int64_t run_on(const py::object& self, std::optional<double> until, const py::object& callback, std::int64_t every,
                    bool with_energy) {
    auto& simulation = self.cast<Simulation&>();
    const double end = simulation.read().end();
    constexpr double slack = 1e-9;  // of the end: 3 * 0.1 > 0.3
    if (until && !(*until <= (1 + slack) * end)) {
        throw py::value_error("until = " + py::repr(py::float_(*until)).cast<std::string>() +
                              " s lies beyond the end of the case, " + py::repr(py::float_(end)).cast<std::string>() +
                              " s; set `end` first");
    }
    if (callback.is_none()) {
        return simulation.step(std::numeric_limits<std::int64_t>::max(), with_energy, or_never(until));
    }
    if (every < 1) {
        throw py::value_error("every: call back after every so many steps, 1 or more");
    }
    std::int64_t taken = 0;
    while (const std::int64_t now = simulation.step(every, with_energy, or_never(until))) {
        taken += now;
        const py::object answer = callback(self);
        if (says_stop(answer)) {
            break;
        }
    }
    return taken;
}

/// Refuses a quantity of a step before the first step: its NaN would go on unseen.
void refuse_before_first_step(const run::Simulation& simulation, const sim::Column& column, double value) {
    const auto has = [&column](const char* word) { return column.name.find(word) != std::string::npos; };
    const bool is_of_water = has("water") || has("fluid");  // a case without has none after a step either
    const bool is_of_face =
        column.gauge >= 0 && simulation.model().output.gauges[static_cast<std::size_t>(column.gauge)].face >= 0;
    const bool is_of_a_step =
        is_of_face || (column.gauge < 0 && (simulation.model().particles() != nullptr || !is_of_water));
    if (std::isnan(value) && simulation.state().step == 0 && is_of_a_step) {
        throw std::runtime_error("'" + column.name + "' is that of a step, and none has been taken yet: step() first");
    }
}

py::object value(const Simulation& self, const std::string& name) {
    const run::Simulation& simulation = self.read();
    if (const auto column = sim::find_column(simulation.model(), name)) {
        const double number = evaluate(*column, simulation.now());
        refuse_before_first_step(simulation, *column, number);
        return py::float_(number);
    }
    py::array_t<double> vector(3);
    constexpr std::array axes{".x", ".y", ".z"};
    for (py::ssize_t i = 0; i < 3; ++i) {
        const auto column = sim::find_column(simulation.model(), name + axes[static_cast<std::size_t>(i)]);
        if (!column) {
            throw py::key_error(
                "there is no quantity '" + name +
                "': a quantity of the scene, 'body.quantity', or the name of a probe or gauge of the case");
        }
        vector.mutable_at(i) = evaluate(*column, simulation.now());
        refuse_before_first_step(simulation, *column, vector.at(i));
    }
    return vector;
}

py::dict ledger(const Simulation& self) {
    const run::Simulation& simulation = self.read();
    py::dict values;
    for (const sim::Column& column : io::scene_columns(simulation.model())) {
        values[py::str(column.name)] = evaluate(column, simulation.now());
    }
    return values;
}

py::object summary(const Simulation& self) {
    const run::Simulation& simulation = self.read();
    run::Summary summary = simulation.summary();
    const std::int64_t bodies = summary.body_count * summary.steps;
    summary.status = simulation.is_at_end() ? "finished" : "interrupted";
    summary.wall_seconds = self.seconds();
    summary.cost = bodies > 0 ? 1e9 * self.seconds() / static_cast<double>(bodies) : 0;
    return from_json(run::summary_json(summary));
}

std::string repr(const Simulation& self) {
    if (!self.is_readable()) {
        return "<riprap.Simulation of a run, readable while that calls back>";
    }
    const run::Simulation& simulation = self.read();
    const sim::State& state = simulation.state();
    const std::int64_t particles = state.fluid.size();
    const auto number = [](double value) { return py::repr(py::float_(value)).cast<std::string>(); };
    return "<riprap.Simulation '" + simulation.model().title + "': t = " + number(state.time) + " of " +
           number(simulation.end()) + " s, step " + std::to_string(state.step) + ", " +
           std::to_string(simulation.model().bodies.size()) + " bodies" +
           (particles > 0 ? ", " + std::to_string(particles) + " particles of water" : "") + ">";
}

constexpr const char* step_help = R"(Takes `count` steps and returns how many were taken: fewer at the end of the case.

energy  measure the energy ledger whole at the last of them; else it is where the case wants a row of ledger.csv
until   stop at the first step at or after this time [s]

The bits of the State do not depend on how its steps are portioned. Other Python threads run meanwhile. Raises
NumericalError when a step is refused, KeyboardInterrupt on Ctrl-C; the State is then that after the last good step.)";

constexpr const char* run_help = R"(Steps to the end of the case, or to the first step at or after `until` [s].

until     at most the end of the case, which may be moved (`end`); ValueError else
callback  called with the simulation after every `every` steps, and after the last; returning False stops
energy    measure the energy ledger whole before every call

Returns the number of steps taken. What the callback raises comes out; the run can be continued.)";

template <class F>
void property(py::class_<Simulation>& type, const char* name, F read, const char* help) {
    type.def_property_readonly(
        name, [read](const Simulation& self) { return read(self.read()); }, help);
}

}  // namespace

void define_simulation(py::module_& module) {
    using namespace py::literals;
    py::class_<Simulation> type(module, "Simulation",
                                "A case that is stepped in memory; writes no file. Simulation(case) is at time 0.");
    type.def(py::init<const Case&>(), "case"_a, py::call_guard<py::gil_scoped_release>())
        .def(
            "step", [](Simulation& self) { return self.step(1, false, never); }, "One step: 1, or 0 at the end.")
        .def(
            "step",
            [](Simulation& self, std::int64_t count, bool energy, std::optional<double> until) {
                return self.step(count, energy, or_never(until));
            },
            step_help, "count"_a = 1, py::kw_only(), "energy"_a = false, "until"_a = py::none())
        .def("run", &run_on, run_help, "until"_a = py::none(), "callback"_a = py::none(), "every"_a = 1, py::kw_only(),
             "energy"_a = false)
        .def("value", &value,
             "A quantity as probes and expected answers name it: 'solid.kinetic', 'block.position.z' (float), "
             "'block.position' (array of 3), a gauge of the case. RuntimeError for what exists only of a step, such as "
             "a contact force, before the first; NaN for an energy that the last step did not measure, and after a "
             "refused step. KeyError for others.",
             "name"_a)
        .def_property_readonly("ledger", &ledger,
                               "Every quantity of the scene by the names of ledger.csv, in SI (dict). Energies of "
                               "contacts and the residual "
                               "are NaN where the last step did not measure them, see step(energy=True).")
        .def("__repr__", &repr)
        .def("summary", &summary, "What summary.json would hold (dict): state_hash, time, ledger, stages, expects.")
        .def_property(
            "end", [](const Simulation& self) { return self.read().end(); }, &Simulation::set_end,
            "Where it ends [s]; may be moved. Automatic steps are chosen to meet it.");
    property(
        type, "time", [](const run::Simulation& s) { return s.state().time; }, "[s]");
    property(
        type, "steps", [](const run::Simulation& s) { return s.state().step; }, "Steps taken since time 0.");
    property(
        type, "steps_left", [](const run::Simulation& s) { return s.steps_left(); },
        "To the end, if all are like the next one.");
    property(
        type, "is_finished", [](const run::Simulation& s) { return s.steps_left() == 0; }, "No step is left.");
    property(
        type, "dt", [](const run::Simulation& s) { return s.state().previous_dt; }, "Of the last step [s].");
    property(
        type, "next_dt", [](const run::Simulation& s) { return s.next_dt(); }, "Of the next step [s].");
    property(
        type, "state_hash",
        [](const run::Simulation& s) {
            std::array<char, 17> text{};
            std::snprintf(text.data(), text.size(), "%016llx",
                          static_cast<unsigned long long>(run::xxh3_of(s.state())));
            return std::string(text.data());
        },
        "Of every bit of the State, 16 digits: that of summary.json after the same steps of `riprap run`.");
    define_views(module, type);
}

}  // namespace riprap::python
