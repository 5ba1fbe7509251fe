// SPDX-License-Identifier: Apache-2.0
// The runs of a study as processes.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/signals.hpp"
#include "riprap/run/sweep.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::ordered_json;

/// Text of what the study asks for; the same text means that it may be continued.
std::string plan_of(const SweepOptions& options) {
    Json runs = Json::array();
    for (const SweepPoint& point : options.points) {
        runs.push_back({{"name", point.name}, {"set", point.overrides}});
    }
    const Json plan{{"case", std::filesystem::absolute(options.case_path).lexically_normal().string()},
                    {"set", options.overrides},
                    {"runs", runs}};
    return plan.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// A slip that every run of the study shares, such as the name of a key, is told before anything is written.
/// @throws CaseError of the first run where the case of none can be read
void require_a_case(const SweepOptions& options) {
    std::optional<CaseError> first;
    for (const SweepPoint& point : options.points) {
        std::vector<std::string> overrides = options.overrides;
        overrides.insert(overrides.end(), point.overrides.begin(), point.overrides.end());
        try {
            scene::read_case(options.case_path, overrides);
            return;
        } catch (const CaseError& error) {
            first = first ? first : error;
        }
    }
    if (first) {
        throw CaseError(*first);
    }
}

void claim_folder(const SweepOptions& options) {
    constexpr std::size_t most = std::size_t{16} << 20U;
    const std::filesystem::path file = options.out / "sweep_plan.json";
    if (std::filesystem::exists(file)) {
        if (io::read_file(file, most) != plan_of(options)) {
            throw FileError(fmt::format("'{}' holds another study; --out writes elsewhere", options.out.string()));
        }
        return;
    }
    if (std::filesystem::exists(options.out) && !std::filesystem::is_empty(options.out)) {
        throw FileError(
            fmt::format("'{}' is not empty and holds no study; --out writes elsewhere", options.out.string()));
    }
    require_a_case(options);
    std::filesystem::create_directories(options.out);
    io::write_file(file, plan_of(options));
}

bool is_finished(const SweepOptions& options, const SweepPoint& point) {
    constexpr std::size_t most = std::size_t{16} << 20U;
    const RunFolder folder{options.out / point.name};
    if (!std::filesystem::exists(folder.summary())) {
        return false;
    }
    return Json::parse(io::read_file(folder.summary(), most), nullptr, false).value("status", "") == "finished";
}

/// Starts `riprap run` on one point, its words going into a file beside the folder of the run.
pid_t start(const SweepOptions& options, const SweepPoint& point) {
    std::vector<std::string> words{"riprap",
                                   "run",
                                   options.case_path,
                                   "--out",
                                   (options.out / point.name).string(),
                                   "--threads",
                                   std::to_string(std::max(1, options.threads)),
                                   "--resume"};
    for (const auto* list : {&options.overrides, &point.overrides}) {
        for (const std::string& text : *list) {
            words.emplace_back("--set");
            words.push_back(text);
        }
    }
    std::vector<char*> arguments;
    for (std::string& word : words) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    const std::string log = (options.out / (point.name + ".log")).string();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    pid_t process = -1;
    const int error = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw io::file_error("start a run in", options.out / point.name, error);
    }
    return process;
}

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitCode::signal_base) + WTERMSIG(status);
}

void tell(const SweepOptions& options, const SweepPoint& point, std::size_t done, const std::string& words) {
    if (!options.quiet) {
        fmt::print("{:>{}}/{}  {}  {}  {}\n", done, std::to_string(options.points.size()).size(), options.points.size(),
                   point.name, fmt::join(point.overrides, " "), words);
        std::fflush(stdout);
    }
}

/// All runs that are not finished; the exit code of the study.
int run_all(const SweepOptions& options, int jobs) {
    const StopRequest stop;
    std::map<pid_t, const SweepPoint*> running;
    std::size_t next = 0, done = 0;
    int result = 0;
    bool has_told = false;
    while (next < options.points.size() || !running.empty()) {
        while (next < options.points.size() && static_cast<int>(running.size()) < jobs && stop.signal() == 0) {
            const SweepPoint& point = options.points[next++];
            if (is_finished(options, point)) {
                tell(options, point, ++done, "finished before");
            } else {
                running.emplace(start(options, point), &point);
            }
        }
        if (stop.signal() != 0) {
            for (const auto& [process, point] : has_told ? std::map<pid_t, const SweepPoint*>{} : running) {
                kill(process, stop.signal());  // they write checkpoints and end
            }
            has_told = true;
            next = options.points.size();
        }
        if (running.empty()) {
            continue;
        }
        int status = 0;
        const pid_t ended = waitpid(-1, &status, 0);
        const auto found = running.find(ended);
        if (ended < 0 && errno != EINTR) {
            break;
        }
        if (found == running.end()) {
            continue;
        }
        const int code = exit_code_of(status);
        tell(options, *found->second, ++done,
             code == 0   ? "finished"
             : code == 1 ? "finished, an expected answer was missed"
                         : fmt::format("exit code {}, see {}.log", code, found->second->name));
        result = result == 0 ? code : result;
        running.erase(found);
    }
    return stop.signal() != 0 ? static_cast<int>(ExitCode::signal_base) + stop.signal() : result;
}

}  // namespace

int run_sweep(const SweepOptions& options) {
    claim_folder(options);
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const int jobs = options.jobs > 0 ? options.jobs : std::max(1, cores / std::max(1, options.threads));
    const int code = run_all(options, jobs);
    const std::string json = sweep_json(options);
    io::write_file(options.out / "sweep.json", json);
    io::write_file(options.out / "sweep.csv", sweep_csv(json));
    return code;
}

}  // namespace riprap::run
