// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/run/folder/member_table.hpp"
#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* unreadable = "unreadable";

/// Last, least and largest value of a column, those that are missing left out of the last two.
Json figures_of(const io::CsvColumn& column, const std::vector<double>& values) {
    double low = std::numeric_limits<double>::quiet_NaN(), high = low;
    for (const double value : values) {
        low = std::fmin(low, value);  // of a number and none: the number
        high = std::fmax(high, value);
    }
    return {{"unit", column.unit}, {"last", values.back()}, {"min", low}, {"max", high}};
}

/// The figures of every column of the probes but the time. @throws FileError where they have lost rows
Json columns_of(const RunFolder& folder, bool is_finished) {
    Json columns = Json::object();
    if (!is_finished && !std::filesystem::exists(folder.probes())) {
        return columns;
    }
    const io::CsvTable table = read_probes(folder);
    for (std::size_t c = 1; c < table.columns.size() && table.row_count() > 0; ++c) {
        columns[table.columns[c].name] = figures_of(table.columns[c], table.values[c]);
    }
    return columns;
}

bool has_text(const Json& object, const char* key) { return object.contains(key) && object[key].is_string(); }

bool is_answer(const Json& answer) {
    return answer.is_object() && has_text(answer, "name") && has_text(answer, "unit") && has_text(answer, "verdict") &&
           answer.contains("value");
}

/// Tells whether a summary has what a table of runs reads of it.
bool is_whole(const Json& summary) {
    return summary.is_object() && has_text(summary, "status") && has_text(summary, "reason") &&
           summary.contains("wall_seconds") && summary["wall_seconds"].is_number() && summary.contains("expects") &&
           summary["expects"].is_array() &&
           std::all_of(summary["expects"].begin(), summary["expects"].end(), is_answer);
}

Json summary_of(const RunFolder& folder) {
    constexpr std::size_t most = std::size_t{16} << 20U;
    const std::string status = status_of(folder);
    const Json none{{"status", status}, {"reason", ""}, {"wall_seconds", 0.0}, {"expects", Json::array()}};
    if (status == "not run" || !std::filesystem::exists(folder.summary())) {
        return none;
    }
    try {
        Json summary = Json::parse(io::read_file(folder.summary(), most), nullptr, false);
        if (is_whole(summary)) {
            return summary;
        }
    } catch (const FileError&) {
        // told below
    }
    Json damaged = none;
    damaged["status"] = unreadable;
    damaged["reason"] = fmt::format("'{}' is damaged", folder.summary().string());
    return damaged;
}

Json run_of(const SweepOptions& options, const SweepPoint& point) {
    const RunFolder folder{options.out / point.name};
    Json summary = summary_of(folder), columns = Json::object();
    try {
        columns = columns_of(folder, summary["status"] == "finished");
    } catch (const FileError& error) {
        summary["status"] = unreadable;
        summary["reason"] = error.what();
    }
    Json set = Json::object();
    for (const std::string& text : point.overrides) {
        const std::size_t equals = text.find('=');
        set[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return {{"name", point.name},
            {"set", set},
            {"status", summary["status"]},
            {"reason", summary["reason"]},
            {"wall_seconds", summary["wall_seconds"]},
            {"answers", summary["expects"]},
            {"columns", columns}};
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    result += '"';
    return result;
}

std::string number(const Json& value) { return value.is_number() ? fmt::format("{}", value.get<double>()) : ""; }

/// Columns that any run has, in the order in which they first appear.
struct Heading {
    std::vector<std::string> keys, answers, columns;
};

void add_new(std::vector<std::string>& list, const std::string& word) {
    if (std::find(list.begin(), list.end(), word) == list.end()) {
        list.push_back(word);
    }
}

Heading heading_of(const Json& sweep) {
    Heading heading;
    for (const Json& run : sweep["runs"]) {
        for (const auto& [key, value] : run["set"].items()) {
            add_new(heading.keys, key);
        }
        for (const Json& answer : run["answers"]) {
            add_new(heading.answers,
                    fmt::format("{} [{}]", answer["name"].get<std::string>(), answer["unit"].get<std::string>()));
        }
        for (const auto& [name, column] : run["columns"].items()) {
            add_new(heading.columns, fmt::format("{} [{}]", name, column["unit"].get<std::string>()));
        }
    }
    return heading;
}

std::vector<std::string> row_of(const Json& run, const Heading& heading) {
    std::vector<std::string> row{run["name"], run["status"]};
    for (const std::string& key : heading.keys) {
        row.push_back(run["set"].value(key, ""));
    }
    std::map<std::string, std::vector<std::string>> found;
    for (const Json& answer : run["answers"]) {
        found[fmt::format("{} [{}]", answer["name"].get<std::string>(), answer["unit"].get<std::string>())] = {
            number(answer["value"]), answer["verdict"]};
    }
    for (const auto& [name, column] : run["columns"].items()) {
        found[fmt::format("column {} [{}]", name, column["unit"].get<std::string>())] = {
            number(column["last"]), number(column["min"]), number(column["max"])};
    }
    const auto add = [&](const std::string& name, std::size_t width) {
        const auto here = found.find(name);
        for (std::size_t i = 0; i < width; ++i) {
            row.push_back(here == found.end() ? "" : here->second[i]);
        }
    };
    for (const std::string& name : heading.answers) {
        add(name, 2);
    }
    for (const std::string& name : heading.columns) {
        add(fmt::format("column {}", name), 3);
    }
    row.push_back(number(run["wall_seconds"]));
    return row;
}

}  // namespace

std::string sweep_json(const SweepOptions& options) {
    Json runs = Json::array();
    for (const SweepPoint& point : options.points) {
        runs.push_back(run_of(options, point));
    }
    const Json json{{"case", options.case_path}, {"set", options.overrides}, {"runs", runs}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

bool any_answer_is_missed(const std::string& json) {
    const Json sweep = Json::parse(json);
    const auto is_missed = [](const Json& answer) { return answer["verdict"] == to_string(Verdict::failed); };
    return std::any_of(sweep["runs"].begin(), sweep["runs"].end(), [&](const Json& run) {
        return std::any_of(run["answers"].begin(), run["answers"].end(), is_missed);
    });
}

std::vector<std::string> unreadable_runs(const std::string& json) {
    std::vector<std::string> runs;
    const Json sweep = Json::parse(json);
    for (const Json& run : sweep["runs"]) {
        if (run["status"] == unreadable) {
            runs.push_back(
                fmt::format("{} cannot be read: {}", run["name"].get<std::string>(), run["reason"].get<std::string>()));
        }
    }
    return runs;
}

std::string sweep_csv(const std::string& json) {
    const Json sweep = Json::parse(json);
    const Heading heading = heading_of(sweep);
    std::vector<std::string> head{"run", "status"};
    head.insert(head.end(), heading.keys.begin(), heading.keys.end());
    for (const std::string& name : heading.answers) {
        head.push_back(name);
        head.push_back(fmt::format("{} verdict", name.substr(0, name.rfind(" ["))));
    }
    for (const std::string& name : heading.columns) {
        for (const char* reduced : {"last", "min", "max"}) {
            const std::size_t unit = name.rfind(" [");
            head.push_back(fmt::format("{}.{}{}", name.substr(0, unit), reduced, name.substr(unit)));
        }
    }
    head.emplace_back("wall [s]");
    std::string text;
    const auto write = [&text](const std::vector<std::string>& fields) {
        for (std::size_t i = 0; i < fields.size(); ++i) {
            text += i > 0 ? "," : "";
            text += quoted(fields[i]);
        }
        text += '\n';
    };
    write(head);
    for (const Json& run : sweep["runs"]) {
        write(row_of(run, heading));
    }
    return text;
}

}  // namespace riprap::run
