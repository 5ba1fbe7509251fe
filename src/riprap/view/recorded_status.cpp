// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "riprap/view/recorded_parts.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t json_depth = 64;  // what a run writes has about five

/// A text of an object; empty where it has none of that name.
std::string text_of(const Json& object, const char* key) {
    const bool has = object.is_object() && object.contains(key) && object[key].is_string();
    return has ? object[key].get<std::string>() : "";
}

/// Returns the largest number of brackets open at once, outside of texts.
std::size_t depth_of(std::string_view json) {
    std::size_t depth = 0, most = 0;
    bool is_quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (is_quoted) {
            i += c == '\\' ? 1 : 0;
            is_quoted = c != '"';
        } else if (c == '"') {
            is_quoted = true;
        } else if (c == '[' || c == '{') {
            most = std::max(most, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return most;
}

/// Events in the log of the run, used where the summary lacks them.
struct Events {
    bool goes_on{false};  ///< begun and not ended
    std::vector<std::string> warnings;
    std::string end;  ///< of the last sitting; empty when it did not come to one
};

/// A line of the log that is cut or not ours says nothing.
Events read_events(const fs::path& log) {
    Events events;
    const std::string text = io::read_file(log, text_limit);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        const auto event = depth_of(line) > json_depth ? Json() : Json::parse(line, nullptr, false);
        if (!event.is_object()) {
            continue;
        }
        const std::string kind = text_of(event, "event"), words = text_of(event, "text");
        if (kind == "start") {
            events.end.clear();
            events.goes_on = true;
        } else if (kind == "end") {
            events.end = words;
            events.goes_on = false;
        } else if (kind == "warning" &&
                   std::find(events.warnings.begin(), events.warnings.end(), words) == events.warnings.end()) {
            events.warnings.push_back(words);  // a resumed run says it again
        }
    }
    return events;
}

void read_summary(RecordedRun& run, const fs::path& path) {
    run.summary_json = json_text(path);
    const auto summary = Json::parse(run.summary_json);
    if (const std::string status = text_of(summary, "status"); !status.empty()) {
        run.status = status;
    }
    if (!summary.is_object() || !summary.contains("warnings") || !summary["warnings"].is_array()) {
        return;
    }
    run.warnings.clear();
    for (const Json& warning : summary["warnings"]) {
        run.warnings.push_back(warning.is_string() ? warning.get<std::string>() : warning.dump());
    }
}

}  // namespace

std::string json_text(const fs::path& path) {
    std::string text = io::read_file(path, text_limit);
    if (depth_of(text) > json_depth) {  // writing JSON goes down one call per bracket
        throw FileError(
            fmt::format("cannot read '{}': its brackets are nested more than {} deep", path.string(), json_depth));
    }
    if (!Json::accept(text)) {
        throw FileError(fmt::format("cannot read '{}': it is no JSON, or ends in the middle", path.string()));
    }
    return text;
}

void read_status(RecordedRun& run, const run::RunFolder& folder) {
    run.status = "not finished";
    Events events;
    if (is_there(folder.events())) {
        attempt(run, [&] { events = read_events(folder.events()); });
    }
    run.warnings = events.warnings;
    if (is_there(folder.summary())) {
        attempt(run, [&] { read_summary(run, folder.summary()); });
        run.status = events.goes_on ? "not finished" : run.status;  // taken up since the summary was written
    } else if (!events.end.empty()) {
        run.status = events.end.starts_with("finished") ? "finished"
                     : events.end.starts_with("failed") ? "failed"
                                                        : "interrupted";
        run.notices.push_back(
            fmt::format("'{}' is missing, though the run ended: {}", folder.summary().string(), events.end));
    }
}

}  // namespace riprap::view
