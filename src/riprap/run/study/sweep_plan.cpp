// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/sweep_plan.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = std::size_t{16} << 20U;

std::filesystem::path plan_file(const std::filesystem::path& out) { return out / "sweep_plan.json"; }

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

/// One run of a plan. @throws nlohmann::json::exception where it is none
SweepPoint point_of(const Json& run) {
    return {run.at("name").get<std::string>(), run.at("set").get<std::vector<std::string>>()};
}

}  // namespace

void claim_study(const SweepOptions& options) {
    const std::filesystem::path file = plan_file(options.out);
    if (std::filesystem::exists(file)) {
        if (io::read_file(file, most_bytes) != plan_of(options)) {
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

SweepOptions read_plan(const std::filesystem::path& out) {
    const std::filesystem::path file = plan_file(out);
    if (!std::filesystem::exists(file)) {
        throw FileError(
            fmt::format("'{}' holds no study: it has no {}; `riprap sweep CASE --vary ... --submit slurm` makes one",
                        out.string(), file.filename().string()));
    }
    try {
        const Json plan = Json::parse(io::read_file(file, most_bytes));
        SweepOptions options;
        options.case_path = plan.at("case").get<std::string>();
        options.overrides = plan.at("set").get<std::vector<std::string>>();
        for (const Json& run : plan.at("runs")) {
            options.points.push_back(point_of(run));
        }
        options.out = out;
        return options;
    } catch (const Json::exception& error) {
        throw FileError(
            fmt::format("'{}' is damaged: {}; the command that began the study writes it again once it is removed",
                        file.string(), error.what()));
    }
}

bool is_finished(const SweepOptions& options, const SweepPoint& point) {
    return status_of(RunFolder{options.out / point.name}) == "finished";
}

namespace {

/// Writes both tables. @returns the text of sweep.json
std::string write_both(const SweepOptions& options) {
    std::string json = sweep_json(options);
    io::write_file(options.out / "sweep.json", json);
    io::write_file(options.out / "sweep.csv", sweep_csv(json));
    return json;
}

int tell_unreadable(const std::string& json) {
    const std::vector<std::string> unreadable = unreadable_runs(json);
    for (const std::string& text : unreadable) {
        fmt::print(stderr, "riprap: {}; remove the folder to run it again\n", printable(text));
    }
    return static_cast<int>(unreadable.empty() ? ExitCode::success : ExitCode::file_system);
}

}  // namespace

int write_tables(const SweepOptions& options) { return tell_unreadable(write_both(options)); }

void write_plan(const SweepOptions& options) { io::write_file(plan_file(options.out), plan_of(options)); }

int gather_study(const SweepOptions& options) { return tell_unfinished(options, write_both(options)); }

int tell_unfinished(const SweepOptions& options, const std::string& json) {
    const int code = tell_unreadable(json);
    std::size_t unfinished = 0;
    const Json study = Json::parse(json);
    for (const Json& one : study.at("runs")) {  // a summary that says "finished" and no more is damaged
        const auto status = one.at("status").get<std::string>();
        if (status != "finished") {
            ++unfinished;
            fmt::print(stderr, "riprap: {} is {}\n", one.at("name").get<std::string>(), printable(status));
        }
    }
    if (!options.quiet) {
        fmt::print("{} of {} runs are finished\n", options.points.size() - unfinished, options.points.size());
    }
    const bool is_missed = any_answer_is_missed(json);
    return code != 0 ? code : static_cast<int>(unfinished > 0 || is_missed ? ExitCode::failed : ExitCode::success);
}

}  // namespace riprap::run
