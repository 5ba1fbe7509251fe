// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/validation_report.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/view/cross_table.hpp"
#include "riprap/view/markdown.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t text_limit = std::size_t{64} << 20U;  // bytes of a README

constexpr std::string_view style = R"(
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 1180px; margin: 0 auto; padding: 16px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 8px; border-bottom: 1px solid #8886; vertical-align: top; }
td.number { text-align: right; white-space: nowrap; }
b { font-weight: 600; }
b.reproduced { color: #1f8a5b; } b.close { color: #b07800; } b.not_reproduced { color: #c8410f; }
table.overview { width: auto; }
dl { display: grid; grid-template-columns: auto 1fr; gap: 2px 12px; font-size: 13px; } dd { margin: 0; }
table.cross { width: auto; } td.cell.right { color: #1f8a5b; } td.cell.refused { color: #888; }
td.cell.wrong { background: #c8410f; color: #fff; }
h3 { margin: 28px 0 6px; }
details table { width: auto; } details p, details li { max-width: 90ch; } summary { cursor: pointer; }
code { font: 0.9em ui-monospace, "DejaVu Sans Mono", monospace; }
pre { white-space: pre-wrap; font: 13px/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
)";

std::string html(const std::string& text) { return escape_html(text); }

/// A value of a result: a number, words, or nothing.
std::string shown(const Json& result, const char* key) {
    const auto found = result.find(key);
    if (found == result.end() || found->is_null()) {
        return "";
    }
    return found->is_number()   ? fmt::format("{:.6g}", found->get<double>() + 0.0)  // no minus before zero
           : found->is_string() ? html(found->get<std::string>())
                                : html(found->dump());
}

std::string band(const Json& result) {
    const std::string low = shown(result, "low"), high = shown(result, "high");
    if (low == high && !low.empty() && result["low"] != result["high"]) {  // a band that six digits do not show
        const double from = result["low"].get<double>(), to = result["high"].get<double>();
        return fmt::format("{} \u00b1 {:.2g}", low, (to - from) / 2);
    }
    return low.empty() && high.empty() ? "" : fmt::format("{} to {}", low, high);
}

/// "not_reproduced" as it is read.
std::string words_of(std::string verdict) {
    std::replace(verdict.begin(), verdict.end(), '_', verdict == "under_specified" ? '-' : ' ');
    return verdict;
}

std::string row(const Json& result) {
    const std::string verdict = shown(result, "verdict");
    return fmt::format(
        "<tr><td>{}</td><td class=number>{}</td><td class=number>{}</td><td class=number>{}</td>"
        "<td class=number>{}</td><td>{}</td><td><b class=\"{}\">{}</b></td><td>{}</td></tr>\n",
        shown(result, "quantity"), shown(result, "paper"), shown(result, "exact"), shown(result, "value"), band(result),
        shown(result, "unit"), verdict, words_of(verdict), shown(result, "note"));
}

/// A case and what it gave, or a suite and its cases, in the order in which they were run.
template <class T>
using Named = std::vector<std::pair<std::string, T>>;

template <class T>
T& entry_of(Named<T>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; });
    return found != list.end() ? found->second : list.emplace_back(name, T{}).second;
}

using Cases = Named<std::vector<Json>>;

Named<Cases> by_suite(const Json& document) {
    const std::string all = document.at("suite").get<std::string>();
    Named<Cases> suites;
    for (const Json& result : document.at("results")) {
        const std::string name = result.at("case").get<std::string>();
        const std::size_t slash = all == "all" ? name.find('/') : std::string::npos;
        const bool names_suite = slash != std::string::npos;
        Cases& cases = entry_of(suites, names_suite ? name.substr(0, slash) : all);
        entry_of(cases, names_suite ? name.substr(slash + 1) : name).push_back(result);
    }
    return suites;
}

std::string folded(const std::string& heading, const fs::path& readme) {
    if (!fs::is_regular_file(readme)) {
        return "";
    }
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", heading,
                       html_of_markdown(io::read_file(readme, text_limit)));
}

struct Meaning {
    const char *verdict, *words;
};

/// Meanings of the verdicts, as in validation/README.md.
constexpr std::array<Meaning, 4> meanings{{
    {"reproduced", "inside the accepted band"},
    {"close", "outside it, inside a wider band that the case states with its reason; the note says which"},
    {"not_reproduced", "outside both, or the case could not be run"},
    {"under_specified", "the source gives no number to compare with: ours is reported"},
}};

std::string glossary() {
    std::string text = "<dl>\n";
    for (const Meaning& meaning : meanings) {
        text += fmt::format("<dt><b class={}>{}</b></dt><dd>{}</dd>\n", meaning.verdict, words_of(meaning.verdict),
                            meaning.words);
    }
    return text + "</dl>\n";
}

/// When, with what and on what: a verdict belongs to a build and a machine.
std::string provenance() {
    const Json build = Json::parse(run::build_json()), machine = Json::parse(run::machine_json());
    const std::string commit = shown(build, "commit");
    return fmt::format("<p>{:%Y-%m-%d %H:%M} UTC. Riprap {}{}, {}, {}, -march={}, {}. {}, {} {}, {}.</p>\n",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())),
                       shown(build, "version"), commit.empty() ? "" : ", commit " + commit, shown(build, "compiler"),
                       shown(build, "build_type"), shown(build, "march"), shown(build, "parallel"),
                       shown(machine, "processor"), shown(machine, "hardware_threads"),
                       shown(machine, "hardware_threads") == "1" ? "thread" : "threads", shown(machine, "system"));
}

/// "physics" or "bookkeeping"
std::string kind_of(const Json& result) { return result.value("kind", "physics"); }

/// "physics: 12 reproduced, 1 close, 3 not reproduced; bookkeeping: 4 reproduced"
template <class Results>
std::string counts_of(const Results& results) {
    std::map<std::string, std::map<std::string, int>> counts;
    for (const Json& result : results) {
        ++counts[kind_of(result)][result.at("verdict").template get<std::string>()];
    }
    std::string text;
    for (const char* kind : {"physics", "bookkeeping"}) {
        std::string part;
        for (const Meaning& meaning : meanings) {
            const int count = counts[kind][meaning.verdict];
            if (count > 0) {
                part += fmt::format("{}<b class={} title=\"{}\">{} {}</b>", part.empty() ? "" : ", ", meaning.verdict,
                                    meaning.words, count, words_of(meaning.verdict));
            }
        }
        text += part.empty() ? "" : fmt::format("{}{}: {}", text.empty() ? "" : "; ", kind, part);
    }
    return text;
}

/// Every case with its counts, so that reds are found before anything is scrolled.
std::string overview(const Named<Cases>& suites) {
    std::string text = "<table class=overview>\n";
    for (const auto& [suite, cases] : suites) {
        for (const auto& [name, results] : cases) {
            text += fmt::format("<tr><td><a href=\"#{0}/{1}\">{0}/{1}</a></td><td>{2}</td></tr>\n", html(suite),
                                html(name), counts_of(results));
        }
    }
    return text + "</table>\n";
}

std::string section(const std::string& suite, const std::string& name, const std::vector<Json>& results,
                    const fs::path& readme) {
    std::string text = fmt::format(
        "<h3 id=\"{0}/{1}\">{0}/{1}</h3>\n<table><tr><th>quantity</th><th>paper</th><th>exact</th><th>ours</th>"
        "<th>band</th><th>unit</th><th>verdict</th><th>note</th></tr>\n",
        html(suite), html(name));
    for (const char* kind : {"physics", "bookkeeping"}) {
        std::string rows;
        for (const Json& result : results) {
            rows += kind_of(result) == kind ? row(result) : "";
        }
        const bool is_account = !rows.empty() && kind == std::string_view("bookkeeping");
        text += (is_account ? "<tr><th colspan=8>bookkeeping</th></tr>\n" : "") + rows;
    }
    return text + "</table>\n" + folded("source, choices, bands", readme);
}

}  // namespace

fs::path write_validation_report(const fs::path& folder, const std::string& results_json, const fs::path& words,
                                 bool is_whole) {
    const Json document = Json::parse(results_json);
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=en><meta charset=utf-8><title>Validation of Riprap</title><style>{}</style>\n"
        "<h1>Validation</h1>\n<p>{}.</p>\n{}{}",
        style, counts_of(document.at("results")), provenance(), glossary());
    const Named<Cases> suites = by_suite(document);
    if (!is_whole) {
        page +=
            "<p><b class=not_reproduced>The validation goes on, or was stopped: these are the cases so far.</b></p>\n";
    }
    page += overview(suites);
    for (const auto& [suite, cases] : suites) {
        page += fmt::format("<h2>{}</h2>\n", html(suite)) +
                folded("sources, assumptions, and what is not reached", words / suite / "README.md") +
                (suite == "cross" ? cross_table(document.value("cells", Json::array())) : "");
        for (const auto& [name, results] : cases) {
            page += section(suite, name, results, words / suite / name / "README.md");
        }
    }
    page += "</html>\n";
    io::make_folder(folder);
    io::write_file(folder / "index.html", page);
    return folder / "index.html";
}

}  // namespace riprap::view
