// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/validation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/provenance.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t text_limit = std::size_t{64} << 20U;  // bytes of a plot or a README

constexpr std::string_view style = R"(
:root { color-scheme: light dark; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 1180px; margin: 0 auto; padding: 16px; }
table { border-collapse: collapse; width: 100%; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 3px 8px; border-bottom: 1px solid #8886; vertical-align: top; }
td.number { text-align: right; white-space: nowrap; }
b.reproduced { color: #1f8a5b; } b.close { color: #b07800; } b.not_reproduced { color: #c8410f; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(440px, 1fr)); gap: 12px; margin: 12px 0; }
.plots svg { width: 100%; height: auto; background: #fff; border-radius: 4px; }
pre { white-space: pre-wrap; font: 13px/1.45 ui-monospace, "DejaVu Sans Mono", monospace; }
)";

std::string html(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return out;
}

/// A value of a result: a number, words, or nothing.
std::string shown(const Json& result, const char* key) {
    const auto found = result.find(key);
    if (found == result.end() || found->is_null()) {
        return "";
    }
    return found->is_number()   ? fmt::format("{:.6g}", found->get<double>())
           : found->is_string() ? html(found->get<std::string>())
                                : html(found->dump());
}

std::string band(const Json& result) {
    const std::string low = shown(result, "low"), high = shown(result, "high");
    return low.empty() && high.empty() ? "" : fmt::format("{} to {}", low, high);
}

std::string row(const Json& result) {
    const std::string verdict = shown(result, "verdict");
    std::string words = verdict;
    std::replace(words.begin(), words.end(), '_', ' ');
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=number>{}</td><td class=number>{}</td><td class=number>{}</td>"
        "<td class=number>{}</td><td>{}</td><td><b class=\"{}\">{}</b></td><td>{}</td></tr>\n",
        shown(result, "case"), shown(result, "quantity"), shown(result, "paper"), shown(result, "exact"),
        shown(result, "value"), band(result), shown(result, "unit"), verdict, words, shown(result, "note"));
}

std::string plots_of(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() == ".svg") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::string text;
    for (const fs::path& file : files) {
        std::string svg = io::read_file(file, text_limit);
        svg.erase(0, std::min(svg.find("<svg"), svg.size()));  // what stands before it is for files of their own
        text += fmt::format("<figure>{}</figure>\n", svg);
    }
    return text.empty() ? "" : "<div class=plots>\n" + text + "</div>\n";
}

std::string words_of(const fs::path& readme) {
    if (!fs::is_regular_file(readme)) {
        return "";
    }
    return fmt::format(
        "<details><summary>sources, assumptions, and what is not reached</summary><pre>{}</pre></details>\n",
        html(io::read_file(readme, text_limit)));
}

/// Results by suite, in the order in which they were run.
using Suites = std::vector<std::pair<std::string, std::vector<Json>>>;

Suites by_suite(const Json& document) {
    const std::string all = document.at("suite").get<std::string>();
    Suites suites;
    for (Json result : document.at("results")) {
        const std::string name = result.at("case").get<std::string>();
        const std::size_t slash = name.find('/');
        const bool names_suite = all == "all" && slash != std::string::npos;
        const std::string suite = names_suite ? name.substr(0, slash) : all;
        if (names_suite) {
            result["case"] = name.substr(slash + 1);
        }
        if (suites.empty() || suites.back().first != suite) {
            suites.push_back({suite, {}});
        }
        suites.back().second.push_back(std::move(result));
    }
    return suites;
}

/// "12 reproduced, 1 close, 3 not reproduced"
std::string counts_of(const Json& results) {
    std::map<std::string, int> counts;
    for (const Json& result : results) {
        ++counts[result.at("verdict").get<std::string>()];
    }
    std::string text;
    for (const char* verdict : {"reproduced", "close", "not_reproduced", "under_specified"}) {
        if (counts[verdict] > 0) {
            std::string words = verdict;
            std::replace(words.begin(), words.end(), '_', ' ');
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[verdict], words);
        }
    }
    return text;
}

}  // namespace

fs::path write_validation_report(const fs::path& folder, const std::string& results_json, const fs::path& suites) {
    const Json document = Json::parse(results_json);
    const run::BuildInfo build = run::build_info();
    std::string page = fmt::format(
        "<!doctype html>\n<html lang=en><meta charset=utf-8><title>Validation of Riprap</title><style>{}</style>\n"
        "<h1>Validation</h1>\n<p>{}. Riprap {}, {}, -march={}.</p>\n",
        style, counts_of(document.at("results")), html(build.version), html(build.compiler), html(build.march));
    for (const auto& [suite, results] : by_suite(document)) {
        page += fmt::format(
            "<h2>{}</h2>\n<table><tr><th>case</th><th>quantity</th><th>paper</th><th>exact</th><th>ours</th><th>band</"
            "th>"
            "<th>unit</th><th>verdict</th><th>note</th></tr>\n",
            html(suite));
        for (const Json& result : results) {
            page += row(result);
        }
        page += "</table>\n" + plots_of(folder / suite) + words_of(suites / suite / "README.md");
    }
    page += "</html>\n";
    io::make_folder(folder);
    io::write_file(folder / "index.html", page);
    return folder / "index.html";
}

}  // namespace riprap::view
