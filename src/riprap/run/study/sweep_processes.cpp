// SPDX-License-Identifier: Apache-2.0
// The runs of a study as processes.
#include "riprap/run/study/sweep_processes.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <list>
#include <map>
#include <thread>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/own_file.hpp"
#include "riprap/run/drive/progress.hpp"
#include "riprap/run/drive/signals.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/study/sweep_plan.hpp"

namespace riprap::run {

namespace {

/// The words of the command that runs one point.
std::vector<std::string> command_of(const SweepOptions& options, const SweepPoint& point, bool force) {
    std::vector<std::string> words{"riprap",
                                   "run",
                                   options.case_path,
                                   "--out",
                                   (options.out / point.name).string(),
                                   "--threads",
                                   std::to_string(std::max(1, options.threads)),
                                   force ? "--force" : "--resume"};
    for (const auto* list : {&options.overrides, &point.overrides}) {
        for (const std::string& text : *list) {
            words.emplace_back("--set");
            words.push_back(text);
        }
    }
    return words;
}

/// Holds the signals that stop a run back for its lifetime: between fork and exec one would meet the handler of the
/// sweep, and be forgotten.
class HeldSignals {
 public:
    HeldSignals() {
        sigset_t stops;
        sigemptyset(&stops);
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            sigaddset(&stops, number);
        }
        ::pthread_sigmask(SIG_BLOCK, &stops, &before_);
    }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;
    ~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    /// In the new process: those that came end it, those that are ignored stay so.
    void let_end() const {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            struct sigaction action {};
            ::sigaction(number, nullptr, &action);
            if (action.sa_handler != SIG_IGN) {
                ::signal(number, SIG_DFL);
            }
        }
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

 private:
    sigset_t before_{};
};

/// In the new process: becomes `riprap run` in a group of its own, so that Ctrl-C reaches it through the sweep alone;
/// when the sweep dies, whatever ends it, the run is asked to stop.
[[noreturn]] void become_run(char* const* arguments, int log, pid_t sweep, const HeldSignals& held) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != sweep) {
        ::_exit(static_cast<int>(ExitCode::signal_base) + SIGTERM);  // it died before that was asked for
    }
    held.let_end();
    ::dup2(log, STDOUT_FILENO);
    ::dup2(log, STDERR_FILENO);
    ::execv("/proc/self/exe", arguments);
    ::_exit(static_cast<int>(ExitCode::internal));
}

/// Starts `riprap run` on one point, its words going into a file beside the folder of the run.
pid_t start(const SweepOptions& options, const SweepPoint& point, bool force) {
    std::vector<std::string> words = command_of(options, point, force);
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const io::FileDescriptor log = io::create_own(options.out / (point.name + ".log"));
    const HeldSignals held;
    const pid_t sweep = ::getpid(), process = ::fork();
    if (process == 0) {
        become_run(arguments.data(), log.number(), sweep, held);
    }
    if (process < 0) {
        throw io::file_error("start a run in", options.out / point.name, errno);
    }
    return process;
}

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitCode::signal_base) + WTERMSIG(status);
}

/// All runs of a study that are not finished, several at a time.
class Crowd {
 public:
    Crowd(const SweepOptions& options, int jobs, bool force, const RunEnded& ended)
        : options_(options), jobs_(jobs), force_(force), ended_(ended) {
        for (const SweepPoint& point : options.points) {
            waiting_.push_back(&point);
        }
    }
    Crowd(const Crowd&) = delete;
    Crowd& operator=(const Crowd&) = delete;
    /// Leaves no run behind, however the sweep ends.
    ~Crowd() {
        for (const auto& [process, point] : running_) {
            ::kill(process, SIGKILL);
            ::waitpid(process, nullptr, 0);
        }
    }

    /// @returns the exit code of the study
    int run() {
        // A wait for children would not end with a signal, and they are to have it at once.
        constexpr std::chrono::milliseconds pause{20};
        int told = 0;
        while (!waiting_.empty() || !running_.empty()) {
            if (const int signal = stop_.signal(); signal != told) {
                told = signal;
                waiting_.clear();
                for (const auto& [process, point] : running_) {
                    ::kill(process, signal);  // they write checkpoints and end
                }
            }
            start_more();
            gather();
            std::this_thread::sleep_for(pause);
        }
        return told != 0 ? static_cast<int>(ExitCode::signal_base) + told : result_;
    }

 private:
    /// Starts runs as long as there is room. Those that another process holds are left for later: a run that outlived
    /// its sweep is about to end.
    void start_more() {
        for (auto next = waiting_.begin(); next != waiting_.end() && std::ssize(running_) < jobs_;) {
            const SweepPoint& point = **next;
            if (is_held(RunFolder{options_.out / point.name})) {
                if (std::find(held_.begin(), held_.end(), &point) == held_.end()) {
                    held_.push_back(&point);
                    tell(point, "waits: another riprap writes there");
                }
                ++next;
                continue;
            }
            next = waiting_.erase(next);
            if (!force_ && is_finished(options_, point)) {
                ++done_;
                ++done_before_;
                tell(point, "finished before");
            } else {
                running_.emplace(start(options_, point, force_), &point);
            }
        }
    }

    void gather() {
        for (auto one = running_.begin(); one != running_.end();) {
            int status = 0;
            const pid_t ended = ::waitpid(one->first, &status, WNOHANG);
            if (ended == 0 || (ended < 0 && errno == EINTR)) {
                ++one;
                continue;
            }
            finish(*one->second, ended < 0 ? static_cast<int>(ExitCode::internal) : exit_code_of(status));
            one = running_.erase(one);
        }
    }

    void finish(const SweepPoint& point, int code) {
        ++done_;
        tell(point,
             code == 0   ? "finished"
             : code == 1 ? "finished, an expected answer was missed"
                         : fmt::format("exit code {}, see {}.log", code, point.name),
             time_left());
        result_ = std::max(result_, code);  // of the worst, whichever ended first
        ended_(point, code);
    }

    /// Says how long the others take, if they take as long as those that ended; nothing after the last one.
    std::string time_left() const {
        using Seconds = std::chrono::duration<double>;
        const std::size_t left = options_.points.size() - done_, ran = done_ - done_before_;
        const double so_far = Seconds(std::chrono::steady_clock::now() - begin_).count();
        return left == 0 || ran == 0
                   ? ""
                   : fmt::format(", about {} left",
                                 duration_text(so_far / static_cast<double>(ran) * static_cast<double>(left)));
    }

    void tell(const SweepPoint& point, const std::string& words, const std::string& left = "") const {
        if (!options_.quiet) {
            fmt::print("{:>{}}/{}  {}  {}  {}{}\n", done_, std::to_string(options_.points.size()).size(),
                       options_.points.size(), point.name, fmt::join(point.overrides, " "), words, left);
            std::fflush(stdout);
        }
    }

    const SweepOptions& options_;
    const int jobs_;
    const bool force_;
    const RunEnded& ended_;
    const StopRequest stop_;
    const std::chrono::steady_clock::time_point begin_{std::chrono::steady_clock::now()};
    std::list<const SweepPoint*> waiting_;
    std::vector<const SweepPoint*> held_;  ///< of which it was told
    std::map<pid_t, const SweepPoint*> running_;
    std::size_t done_{0}, done_before_{0};
    int result_{0};
};

}  // namespace

int usual_jobs(int threads) {
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return std::max(1, cores / std::max(1, threads));
}

int run_processes(const SweepOptions& options, int jobs, bool force, const RunEnded& ended) {
    return Crowd(options, jobs, force, ended).run();
}

int run_sweep(const SweepOptions& options) {
    claim_study(options);
    const int jobs = options.jobs > 0 ? options.jobs : usual_jobs(options.threads);
    const int code = run_processes(options, jobs, false, [](const SweepPoint&, int) {});
    const int gathered = write_tables(options);
    return code == 0 ? gathered : code;
}

int run_point(SweepOptions options, std::size_t number) {
    if (number < 1 || number > options.points.size()) {
        throw FileError(
            fmt::format("'{}' has runs 1 to {}, not {}", options.out.string(), options.points.size(), number));
    }
    options.points = {options.points[number - 1]};
    if (is_held(RunFolder{options.out / options.points[0].name})) {
        throw FileError(
            fmt::format("another riprap writes into '{}'", (options.out / options.points[0].name).string()));
    }
    return run_processes(options, 1, false, [](const SweepPoint&, int) {});
}

}  // namespace riprap::run
