// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/cross_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "riprap/view/markdown.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::json;

/// Runs of one pair of methods in one scene.
struct Runs {
    const Json* shown{nullptr};  ///< the first that is wrong, else the first
    int right{0}, judged{0};
    std::string told;  ///< a line for each run
};

/// A row of a table, by scene and solid; the solid is empty where columns are solids.
using Rows = std::vector<std::pair<std::pair<std::string, std::string>, std::map<std::string, Runs>>>;

std::string text_of(const Json& cell, const char* key) { return cell.value(key, std::string()); }

std::string shown_value(const Json& cell) {
    const auto value = cell.find("value");
    return value == cell.end() || value->is_null() ? "ended" : fmt::format("{:.4g}", value->get<double>() + 0.0);
}

void add(Rows& rows, const Json& cell, bool is_dry) {
    const std::pair key{text_of(cell, "scene"), is_dry ? "" : text_of(cell, "solid")};
    auto row = std::ranges::find_if(rows, [&key](const auto& one) { return one.first == key; });
    if (row == rows.end()) {
        row = rows.insert(rows.end(), {key, {}});
    }
    Runs& runs = row->second[text_of(cell, is_dry ? "solid" : "fluid")];
    const std::string finding = text_of(cell, "finding"), why = text_of(cell, "why"), cause = text_of(cell, "cause");
    runs.right += finding == "right" ? 1 : 0;
    runs.judged += finding == "refused" ? 0 : 1;
    if (runs.shown == nullptr || (finding == "wrong" && text_of(*runs.shown, "finding") != "wrong")) {
        runs.shown = &cell;
    }
    const std::string variation = text_of(cell, "variation");
    runs.told += fmt::format("{}: {} {}{}{}\n", variation.empty() ? "as it is" : variation, finding,
                             finding == "refused" ? "" : shown_value(cell), why.empty() ? "" : "; " + why,
                             cause.empty() ? "" : "; " + cause);
}

std::string td_of(const Runs& runs) {
    const std::string finding = text_of(*runs.shown, "finding");
    const std::string count = runs.judged > 1 ? fmt::format(" {}/{}", runs.right, runs.judged) : "";
    const std::string text = finding == "refused" ? text_of(*runs.shown, "why") : shown_value(*runs.shown) + count;
    return fmt::format("<td class=\"cell {}\" title=\"{}\">{}</td>", finding, escape_html(runs.told),
                       escape_html(text));
}

std::string table_of(const Rows& rows) {
    std::vector<std::string> columns;
    for (const auto& [key, cells] : rows) {
        for (const auto& [column, runs] : cells) {
            if (std::ranges::find(columns, column) == columns.end()) {
                columns.push_back(column);
            }
        }
    }
    std::string text = "<table class=cross><tr><th>scene</th><th></th>";
    for (const std::string& column : columns) {
        text += fmt::format("<th>{}</th>", escape_html(column));
    }
    text += "</tr>\n";
    std::string last;
    for (const auto& [key, cells] : rows) {
        const std::string name = escape_html(key.first);
        text += fmt::format("<tr><td>{}</td><td>{}</td>",
                            key.first == last ? "" : fmt::format("<a href=\"#cross/{0}\">{0}</a>", name),
                            escape_html(key.second));
        last = key.first;
        for (const std::string& column : columns) {
            const auto runs = cells.find(column);
            text += runs == cells.end() ? "<td></td>" : td_of(runs->second);
        }
        text += "</tr>\n";
    }
    return rows.empty() ? "" : text + "</table>\n";
}

}  // namespace

std::string cross_table(const Json& cells) {
    Rows dry, wet;
    for (const Json& cell : cells) {
        if (!cell.value("is_energy", false)) {
            const bool is_dry = text_of(cell, "fluid") == "none";
            add(is_dry ? dry : wet, cell, is_dry);
        }
    }
    return table_of(dry) + table_of(wet);
}

}  // namespace riprap::view
