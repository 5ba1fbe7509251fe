// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/again/stored_run.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::json;

constexpr std::size_t most_bytes = std::size_t{16} << 20U;

Json json_of(const std::filesystem::path& file) {
    Json json = Json::parse(io::read_file(file, most_bytes), nullptr, false);
    if (!json.is_object()) {
        throw FileError(fmt::format("'{}' is damaged: it is no JSON", file.string()));
    }
    return json;
}

/// A text of an object, empty where there is none.
std::string text_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// What bits depend on: build and processor.
std::string build_of(const Json& summary) {
    const auto part = [&](const char* object, const char* key) {
        const auto found = summary.find(object);
        return found != summary.end() && found->is_object() ? text_at(*found, key) : std::string();
    };
    return fmt::format("riprap {} {}, {}, {}", part("build", "version"), part("build", "commit"),
                       part("build", "compiler"), part("machine", "processor"));
}

void read_summary(const RunFolder& folder, StoredRun& run) {
    run.status = status_of(folder);
    if (!std::filesystem::exists(folder.summary())) {
        return;
    }
    const Json summary = json_of(folder.summary());
    run.state_hash = text_at(summary, "state_hash");
    run.build = build_of(summary);
    const auto time = summary.find("time");
    run.time = time != summary.end() && time->is_number() ? time->get<double>() : 0;
}

}  // namespace

std::optional<StoredRun> stored_run(const std::filesystem::path& folder) {
    const RunFolder run{folder};
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error) || !std::filesystem::exists(run.ticket(), error) ||
        std::filesystem::exists(folder / "case.toml", error)) {
        return std::nullopt;
    }
    if (!std::filesystem::is_regular_file(run.case_file(), error)) {
        throw FileError(fmt::format("the run in '{}' has lost its case: there is no '{}'", folder.string(),
                                    run.case_file().string()));
    }
    StoredRun stored;
    stored.case_file = run.case_file();
    stored.name = std::filesystem::weakly_canonical(folder).filename().string();
    try {
        stored.overrides = json_of(run.ticket()).at("set").get<std::vector<std::string>>();
    } catch (const Json::exception& problem) {
        throw FileError(fmt::format("'{}' is damaged: {}", run.ticket().string(), problem.what()));
    }
    read_summary(run, stored);
    return stored;
}

Comparison compare(const StoredRun& first, const std::filesystem::path& again) {
    StoredRun other;
    read_summary(RunFolder{again}, other);
    if (first.state_hash.empty() || other.state_hash.empty()) {
        return {true, fmt::format("'{}' has no State at its end to compare with", first.name)};
    }
    if (first.time != other.time) {
        return {true, fmt::format("'{}' went to {:.6g} s, this run to {:.6g} s: their States are not compared",
                                  first.name, first.time, other.time)};
    }
    if (first.state_hash == other.state_hash) {
        return {true, fmt::format("the same State as in '{}': {}", first.name, first.state_hash)};
    }
    return {false, fmt::format("another State than in '{}': {} there, {} here; there {}, here {}", first.name,
                               first.state_hash, other.state_hash, first.build,
                               first.build == other.build ? "the same" : other.build)};
}

}  // namespace riprap::run
