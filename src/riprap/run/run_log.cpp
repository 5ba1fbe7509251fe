// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/run_log.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <nlohmann/json.hpp>

namespace riprap::run {

namespace {

io::FileDescriptor open_to_append(const std::filesystem::path& path) {
    io::FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
    if (!file.is_open()) {
        throw io::file_error("write", path, errno);
    }
    return file;
}

}  // namespace

RunLog::RunLog(const RunFolder& folder)
    : log_path_(folder.log()),
      events_path_(folder.events()),
      log_(open_to_append(log_path_)),
      events_(open_to_append(events_path_)) {}

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
}

}  // namespace riprap::run
