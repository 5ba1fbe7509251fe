// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <limits>
#include <memory>

#include "case.hpp"
#include "field_views.hpp"
#include "riprap/run/simulate/schedule.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::python {

/// A run::Simulation as Python holds it: stepped without the interpreter's lock, read with it. Either its own, or that
/// of a run with a folder, lent to the callbacks of that run.
class Simulation {
 public:
    explicit Simulation(const Case& of);
    /// Nothing can be read of it until it is lent.
    Simulation() : rows_(1) {}
    /// `seconds` since its run began [s].
    void lend(run::Simulation& simulation, double seconds) {
        simulation_ = &simulation;
        seconds_ = seconds;
    }
    /// Arrays that were asked of it stay good.
    void give_back();

    /// Takes up to `count` steps, ending early at the first step at or after `until` [s] and at the end of the case.
    /// @returns the steps taken  @throws NumericalError; the State is then the last good one
    std::int64_t step(std::int64_t count, bool with_energy, double until);

    /// For reading. @throws std::runtime_error while another thread steps it, or where it is not lent
    run::Simulation& read() const;
    bool is_readable() const { return simulation_ != nullptr && !is_stepping_; }
    FieldViews& views() { return views_; }
    void set_end(double end);
    double seconds() const { return seconds_; }  ///< spent in step() [s]; of a lent one, since its run began

 private:
    run::Simulation& own() const;
    bool is_due() const;

    std::unique_ptr<run::Simulation> owned_;
    run::Simulation* simulation_{nullptr};  ///< null where it is not lent
    run::Schedule rows_;                    ///< when the ledger is measured whole, as for the rows of ledger.csv
    FieldViews views_;
    std::atomic<bool> is_stepping_{false};
    double seconds_{0};
};

/// A callback answered False, Python's or NumPy's; anything else, None and 0 included, goes on.
bool says_stop(const pybind11::object& answer);

void define_simulation(pybind11::module_& module);
/// Defines the views of bodies, water and contacts of a Simulation.
void define_views(pybind11::module_& module, pybind11::class_<Simulation>& simulation);
/// The run folder: riprap.run.
void define_run(pybind11::module_& module);
void define_waves(pybind11::module_& module);

}  // namespace riprap::python

template <>
struct pybind11::detail::type_caster<riprap::python::Simulation>
    : riprap::python::MadeCaster<riprap::python::Simulation> {};
