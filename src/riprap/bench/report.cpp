// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "riprap/bench/bench.hpp"
#include "riprap/run/folder/provenance.hpp"

namespace riprap::bench {

namespace {

using Json = nlohmann::ordered_json;

/// Breaks a note into lines of at most `width` columns, at blanks.
std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
    std::string lines;
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = std::min(text.size(), begin + width);
        if (end < text.size()) {
            const std::size_t blank = text.rfind(' ', end);
            end = blank != std::string::npos && blank > begin ? blank : end;
        }
        lines += indent + text.substr(begin, end - begin) + '\n';
        begin = end < text.size() && text[end] == ' ' ? end + 1 : end;
    }
    return lines;
}

}  // namespace

std::string to_json(const MachineLimits& machine, const std::vector<Result>& results) {
    Json limits = Json::array();
    for (const ThreadLimits& t : machine.by_threads) {
        limits.push_back(
            {{"threads", t.threads}, {"triad", t.triad}, {"fma_double", t.fma_double}, {"fma_single", t.fma_single}});
    }
    Json about = Json::parse(run::machine_json());
    about["build"] = Json::parse(run::build_json());
    about["limits"] = std::move(limits);
    about["core_speed"] = core_speed(machine);
    Json rows = Json::array();
    for (const Result& r : results) {
        rows.push_back(
            {{"name", r.name}, {"threads", r.threads}, {"value", r.value}, {"unit", r.unit}, {"note", r.note}});
    }
    return Json{{"machine", std::move(about)}, {"results", std::move(rows)}}.dump(2) + '\n';
}

std::string to_table(const MachineLimits& machine, const std::vector<Result>& results) {
    const run::MachineInfo info = run::machine_info();
    std::string text = fmt::format(
        "{}, {} threads; single-core speed relative to the reference machine (docs/howto/benchmarks.md): {:.2f}\n\n",
        info.processor, info.hardware_threads, core_speed(machine));
    std::size_t width = 4;
    for (const Result& r : results) {
        width = std::max(width, r.name.size());
    }
    text += fmt::format("{:<{}}  threads  {:>12}  unit\n", "name", width, "value");
    for (const Result& r : results) {
        text += fmt::format("{:<{}}  {:>7}  {:>12.6g}  {}\n", r.name, width, r.threads, r.value, r.unit);
        text += wrapped(r.note, 100, "    ");
    }
    return text;
}

}  // namespace riprap::bench
