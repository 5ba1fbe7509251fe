// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/folder/run_log.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "riprap/io/continued_file.hpp"
#include "riprap/io/own_file.hpp"

namespace riprap::run {

namespace {

constexpr std::string_view warning_kind = "warning";

io::FileDescriptor open_to_append(const std::filesystem::path& path) {
    return io::open_own(path, O_WRONLY | O_CREAT | O_APPEND);
}

}  // namespace

RunLog::RunLog(const RunFolder& folder)
    : log_path_(folder.log()),
      events_path_(folder.events()),
      log_(open_to_append(log_path_)),
      events_(open_to_append(events_path_)) {
    std::ifstream earlier(events_path_);
    for (std::string line; std::getline(earlier, line);) {
        const auto event = nlohmann::json::parse(line, nullptr, false);  // the last line of a killed process may be cut
        if (event.is_object() && event.value("event", nlohmann::json()) == warning_kind && event.contains("text") &&
            event["text"].is_string()) {
            keep_warning(event["text"].get<std::string>());
        }
    }
}

void RunLog::keep_warning(const std::string& text) {
    if (std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end()) {
        warnings_.push_back(text);
    }
}

void RunLog::add(std::string_view kind, const std::string& text, Numbers numbers) {
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    const std::string when = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    const std::string line = fmt::format("{}  {:<10}  {}\n", when, kind, text);
    write_all(log_, line.data(), line.size(), log_path_);
    nlohmann::ordered_json event{{"when", when}, {"event", kind}, {"text", text}};
    for (const auto& [name, value] : numbers) {
        event[std::string(name)] = value;
    }
    const std::string event_line = event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
    write_all(events_, event_line.data(), event_line.size(), events_path_);
    if (kind == warning_kind) {
        keep_warning(text);
    }
}

}  // namespace riprap::run
