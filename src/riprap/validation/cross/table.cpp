// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/cross/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace riprap::validation::cross {

namespace {

/// Runs of one pair of methods in one scene.
struct Runs {
    const Cell* shown{nullptr};  ///< the first that is wrong, else the first
    int right{0}, judged{0};
};

/// Words in the order in which they first come.
void note_word(std::vector<std::string>& words, const std::string& word) {
    if (std::ranges::find(words, word) == words.end()) {
        words.push_back(word);
    }
}

/// A line of a table: of a scene, and of a solid where columns are fluids.
struct Line {
    std::string scene, solid;
    std::map<std::string, Runs> cells;
};

struct Table {
    std::vector<std::string> columns;
    std::vector<Line> lines;
};

Line& line_of(Table& table, const std::string& scene, const std::string& solid) {
    const auto found =
        std::ranges::find_if(table.lines, [&](const Line& line) { return line.scene == scene && line.solid == solid; });
    return found != table.lines.end() ? *found : table.lines.emplace_back(Line{scene, solid, {}});
}

void add(Table& table, const Cell& cell, bool is_dry) {
    const std::string& column = is_dry ? cell.solid : cell.fluid;
    note_word(table.columns, column);
    Runs& runs = line_of(table, cell.scene, is_dry ? "" : cell.solid).cells[column];
    runs.right += cell.finding == "right" ? 1 : 0;
    runs.judged += cell.finding == "refused" ? 0 : 1;
    const bool is_first_wrong = cell.finding == "wrong" && (runs.shown == nullptr || runs.shown->finding != "wrong");
    runs.shown = runs.shown == nullptr || is_first_wrong ? &cell : runs.shown;
}

std::string text_of(const Runs& runs) {
    if (runs.shown == nullptr) {
        return "";
    }
    if (runs.shown->finding == "refused") {
        return "(" + runs.shown->why + ")";
    }
    const std::string value = std::isfinite(runs.shown->value) ? fmt::format("{:.4g}", runs.shown->value) : "ended";
    const std::string count = runs.judged > 1 ? fmt::format(" {}/{}", runs.right, runs.judged) : "";
    return (runs.shown->finding == "wrong" ? "WRONG " : "") + value + count;
}

std::string print(const Table& table) {
    if (table.lines.empty()) {
        return "";
    }
    std::vector<std::vector<std::string>> rows{{"scene", ""}};
    rows.front().insert(rows.front().end(), table.columns.begin(), table.columns.end());
    std::string last;
    for (const Line& line : table.lines) {
        std::vector<std::string>& row = rows.emplace_back();
        row = {line.scene == last ? "" : line.scene, line.solid};
        last = line.scene;
        for (const std::string& column : table.columns) {
            const auto cell = line.cells.find(column);
            row.push_back(cell == line.cells.end() ? "" : text_of(cell->second));
        }
    }
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], row[i].size());
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += widths[i] == 0 ? "" : fmt::format("{:<{}}  ", row[i], widths[i]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text + "\n";
}

/// "answers: 243 judged: 240 right, 3 wrong, of which 2 with a known cause; 20 refused"
std::string counts_of(const std::vector<Cell>& cells, bool is_energy, std::string_view name) {
    int right = 0, wrong = 0, known = 0, refused = 0;
    for (const Cell& cell : cells) {
        if (cell.is_energy == is_energy) {
            right += cell.finding == "right" ? 1 : 0;
            wrong += cell.finding == "wrong" ? 1 : 0;
            known += cell.finding == "wrong" && !cell.cause.empty() ? 1 : 0;
            refused += cell.finding == "refused" ? 1 : 0;
        }
    }
    return fmt::format("{}: {} judged: {} right, {} wrong, of which {} with a known cause; {} refused\n", name,
                       right + wrong, right, wrong, known, refused);
}

std::string wrong_cells(const std::vector<Cell>& cells) {
    std::string text;
    for (const Cell& cell : cells) {
        if (cell.finding == "wrong" || cell.is_stale) {
            const Result result = result_of(cell);
            text += fmt::format("  {}: {}: {}\n", cell.scene, result.quantity,
                                cell.is_energy
                                    ? fmt::format("{:.2e} for at most {:.0e}; {}", cell.value, cell.high, result.note)
                                    : result.note);
        }
    }
    return text.empty() ? "" : "wrong:\n" + text;
}

/// Seconds of each scene, the dearest first.
std::string costs_of(const std::vector<Cell>& cells) {
    std::map<std::string, double> seconds;
    double all = 0;
    for (const Cell& cell : cells) {
        if (!cell.is_energy) {
            seconds[cell.scene] += cell.seconds;
            all += cell.seconds;
        }
    }
    std::vector<std::pair<std::string, double>> sorted(seconds.begin(), seconds.end());
    std::ranges::sort(sorted, [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text = fmt::format("computed for {:.0f} s:", all);
    for (const auto& [name, time] : sorted) {
        text += fmt::format(" {} {:.1f},", name, time);
    }
    text.back() = '\n';
    return text;
}

}  // namespace

std::string table_of(const std::vector<Cell>& cells) {
    Table dry, wet;
    for (const Cell& cell : cells) {
        if (!cell.is_energy) {
            const bool is_dry = cell.fluid == "none";
            add(is_dry ? dry : wet, cell, is_dry);
        }
    }
    return print(dry) + print(wet) + wrong_cells(cells) + counts_of(cells, false, "answers") +
           counts_of(cells, true, "energy") + costs_of(cells);
}

std::string with_cells(const std::string& results_json, const std::vector<Cell>& cells) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json document = Json::parse(results_json);
    Json& list = document["cells"] = Json::array();
    for (const Cell& cell : cells) {
        list.push_back({{"scene", cell.scene},
                        {"solid", cell.solid},
                        {"fluid", cell.fluid},
                        {"variation", cell.variation},
                        {"is_energy", cell.is_energy},
                        {"finding", cell.finding},
                        {"quantity", cell.quantity},
                        {"unit", cell.unit},
                        {"value", number(cell.value)},
                        {"low", number(cell.low)},
                        {"high", number(cell.high)},
                        {"why", cell.why},
                        {"cause", cell.cause},
                        {"seconds", number(cell.seconds)}});
    }
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace riprap::validation::cross
