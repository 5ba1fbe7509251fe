// SPDX-License-Identifier: Apache-2.0
// riprap.run: what `riprap run` does, with a callback.
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <csignal>
#include <memory>
#include <optional>
#include <stdexcept>

#include "errors.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "simulation.hpp"
#include "values.hpp"

namespace riprap::python {

namespace py = pybind11;

namespace {

/// Calls back after every so many steps of a run that another part of the library drives.
class Caller {
 public:
    Caller(py::object callback, std::int64_t every) : callback_(std::move(callback)), every_(every) {}

    /// Called without the interpreter's lock. False stops the run.
    bool operator()(run::Simulation& simulation) {
        if (++steps_ % every_ != 0 && simulation.steps_left() > 0) {
            return true;
        }
        const py::gil_scoped_acquire locked;
        if (view_.is_none()) {
            view_ = py::cast(std::make_unique<Simulation>());
        }
        const Loan loan(view_.cast<Simulation&>(), simulation, since_begin_.seconds());
        try {
            return !says_stop(callback_(view_));
        } catch (py::error_already_set& error) {
            failure_ = std::move(error);
            return false;
        }
    }
    void rethrow() {
        if (failure_) {
            throw py::error_already_set(std::move(*failure_));
        }
    }

 private:
    /// Outside of its calls nothing of the simulation can be read: it is being stepped then, or gone.
    struct Loan {
        Simulation& view;
        Loan(Simulation& to, run::Simulation& simulation, double seconds) : view(to) { view.lend(simulation, seconds); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;
        ~Loan() { view.give_back(); }
    };

    py::object callback_;
    std::int64_t every_, steps_{0};
    Timer since_begin_;
    py::object view_{py::none()};
    std::optional<py::error_already_set> failure_;
};

/// Raises the exception that the exit code of a run means in Python; nothing for success.
void raise_for(int code, const py::object& summary) {
    constexpr int signal_base = static_cast<int>(ExitCode::signal_base);
    if (code == static_cast<int>(ExitCode::numerical)) {
        throw NumericalError(summary["reason"].cast<std::string>());
    }
    if (code == signal_base + SIGINT) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
        throw py::error_already_set();
    }
    if (code > signal_base) {
        std::raise(code - signal_base);  // a SIGTERM was held back for the checkpoint; now it takes its course
    }
}

py::object run_folder(const Case& of, const std::filesystem::path& out, bool resume, bool force, bool quiet,
                      const py::object& callback, std::int64_t every) {
    if (every < 1) {
        throw py::value_error("every: call back after every so many steps, 1 or more");
    }
    if (resume && force) {
        throw py::value_error("resume continues the run in the folder, force replaces it: give one of the two");
    }
    run::RunOptions options;
    options.overrides = of.overrides;
    options.out = out;
    options.threads = parallel::thread_count();
    options.resume = resume;
    options.force = force;
    options.silent = quiet;
    static std::atomic_flag is_running;  // the signals of a process can be caught once
    if (is_running.test_and_set()) {
        throw std::runtime_error("another riprap.run is under way in this process: one at a time");
    }
    const std::unique_ptr<std::atomic_flag, void (*)(std::atomic_flag*)> clear(
        &is_running, [](std::atomic_flag* flag) { flag->clear(); });
    Caller caller(callback, every);
    if (!callback.is_none()) {
        options.watch = [&caller](run::Simulation& simulation) { return caller(simulation); };
    }
    int code = 0;
    {
        const py::gil_scoped_release unlocked;
        code = run::run_loaded(of.loaded, options);
    }
    caller.rethrow();
    constexpr std::size_t limit = std::size_t{1} << 24;
    py::object summary = from_json(io::read_file(run::RunFolder{out}.summary(), limit));
    raise_for(code, summary);
    return summary;
}

constexpr const char* run_help =
    R"(Runs a case into a folder, as `riprap run` does: frames, tables, checkpoints, summary.

out       the run folder
resume    continue the run in the folder, if any
force     replace the run in the folder, if any; not with resume
quiet     print nothing
callback  called with the Simulation after every `every` steps and after the last; returning False stops the run, with a
          checkpoint. It may read the simulation while it is called, not step it

Returns what summary.json holds (dict); missed expected answers are in its `expects`. Raises FileError where the folder is
refused, NumericalError when a step is refused for good. Ctrl-C lets the step at hand finish, writes a checkpoint and
raises KeyboardInterrupt; so does what the callback raises.)";

}  // namespace

void define_run(py::module_& module) {
    using namespace py::literals;
    module.def("run", &run_folder, run_help, "case"_a, "out"_a, py::kw_only(), "resume"_a = false, "force"_a = false,
               "quiet"_a = true, "callback"_a = py::none(), "every"_a = 1);
}

}  // namespace riprap::python
