// SPDX-License-Identifier: Apache-2.0
// The key table as a manual page and as a listing for a terminal.
#include "riprap/scene/keys/key_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/scene/keys/check_value.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/renamed.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::scene {

namespace {

std::string forms_text(const Key& key) {
    std::string text;
    for (const Form& form : key.forms) {
        text += text.empty() ? "" : "; or ";
        text += describe_form(form);
    }
    return text;
}

/// Default as it would be written in a case; "required" or "-" where there is none.
std::string default_text(const Key& key) {
    if (key.is_required) {
        return "required";
    }
    if (!key.otherwise || key.otherwise->is_table() || (key.otherwise->is_array() && key.otherwise->items.empty())) {
        return "-";
    }
    return excerpt(*key.otherwise);
}

std::string group_text(const Group& group) {
    std::string names;
    for (const std::string_view key : group.keys) {
        names += fmt::format("{}`{}`", names.empty() ? "" : ", ", key);
    }
    switch (group.rule) {
        case GroupRule::exactly_one:
            return "Exactly one of " + names + ".";
        case GroupRule::at_most_one:
            return "At most one of " + names + ".";
        case GroupRule::all_or_none:
            return "All or none of " + names + ".";
    }
    return "";
}

/// Escapes what Markdown would read in a table cell.
std::string cell(std::string text) {
    std::string out;
    for (const char c : text) {
        out += c == '|' ? "\\|" : c == '<' ? "&lt;" : std::string(1, c);
    }
    return out;
}

/// "sph, wcmps": the methods that have or read the key; "all" where every one does.
std::string methods_text(const Key& key) {
    return key.methods.empty() ? "all" : fmt::format("{}", fmt::join(key.methods, ", "));
}

std::string manual_of(const Table& table) {
    const bool has_methods = std::ranges::any_of(table.keys, [](const Key& key) { return !key.methods.empty(); });
    std::string page = fmt::format("\n## `{}`\n\n{}\n\n", table.header, table.help);
    page += has_methods ? "| key | value | default | methods | meaning |\n| --- | --- | --- | --- | --- |\n"
                        : "| key | value | default | meaning |\n| --- | --- | --- | --- |\n";
    for (const Key& key : table.keys) {
        page += fmt::format("| `{}` | {} | {} | {}{} |\n", key.name, cell(forms_text(key)), cell(default_text(key)),
                            has_methods ? methods_text(key) + " | " : "", cell(key.help));
    }
    for (const Group& group : table.groups) {
        page += fmt::format("\n{}\n", group_text(group));
    }
    return page;
}

constexpr std::string_view preface = R"(# The case file

<!-- Made by `riprap schema --manual` from the key table in src/riprap/scene/keys. Do not edit by hand. -->

A case is one TOML file that describes an experiment. Unknown keys, wrong units and values out of range are errors
with file, line and column; all of them are reported in one run.

Quantities: a bare number is in SI. A text may carry its unit, `"2.5 cm"`, `"26 deg"`, `"0.4 MPa"`, `"9.81 m/s^2"`,
`"30 t"`; so may the name of a key, `friction_angle_deg = 26.0`, `spacing_mm = 50`. Units are checked: `"26 deg"` is
refused where a length is wanted. Known units: um mm cm m km, mg g kg t, us ms s min h, Hz, rad mrad deg rev rpm,
N kN MN, Pa kPa MPa GPa, J kJ, W, and products, quotients and powers of them.

Vectors have three components. In a planar scene (`dimension = 2`) they have two, or three with the last one zero.

Other files are named by a path within the folder of the case; a path that leaves it is refused.
)";

std::string limits_text() {
    return fmt::format(R"(
## Limits

A case that asks for more is refused before anything is allocated.

| what | at most |
| --- | --- |
| size of a case file | {} bytes |
| brackets within brackets | {} |
| values in a case file | {} |
| materials | {} |
| bodies in a scene | {} |
| convex parts in a scene | {} |
| cells of one Voronoi pack | {} |
| blocks of one rock mass | {} |
| size of a surface file | {} bytes |
| rows of a table file | {} |
)",
                       limits::case_bytes, limits::nesting, limits::values, limits::materials, limits::bodies,
                       limits::parts, limits::cells, limits::rock_blocks, limits::surface_bytes, limits::table_rows);
}

std::string quantities_text() {
    std::string page =
        "\n## Quantities\n\nWhat probes record and [[expect]] checks. Vectors have the components `.x`, `.y` and "
        "`.z`. Write `BODY.QUANTITY` for a quantity of a body.\n\n"
        "| quantity | unit | of | meaning |\n| --- | --- | --- | --- |\n";
    for (const sim::QuantityInfo& quantity : sim::quantities()) {
        page += fmt::format("| `{}`{} | {} | {} | {} |\n", quantity.name, quantity.components > 1 ? " (vector)" : "",
                            quantity.unit, quantity.is_of_body ? "a body" : "the scene", quantity.help);
    }
    return page;
}

std::string old_names_text() {
    std::string page =
        "\n## Names of older versions\n\nA file that has one of these is refused with the name of today; `riprap "
        "upgrade CASE` writes it in.\n\n| before | key | now | since |\n| --- | --- | --- | --- |\n";
    for (const Renamed& row : renamed_names()) {
        std::string keys;
        for (const KeyPlace& place : row.places) {
            keys += fmt::format("{}`{}.{}`", keys.empty() ? "" : ", ", place.table, place.key);
        }
        page += fmt::format("| {} | {}{} | {} | {} |\n", row.word.empty() ? "the key" : fmt::format("`{}`", row.word),
                            keys, row.alone.empty() ? "" : fmt::format(" without `{}`", row.alone),
                            row.now.empty() ? std::string(row.advice) : fmt::format("`{}`", row.now), row.since);
    }
    return page;
}

}  // namespace

std::string case_manual() {
    std::string page(preface);
    for (const Table* table : all_tables()) {
        page += manual_of(*table);
    }
    return page + quantities_text() + old_names_text() + limits_text();
}

std::string key_listing(const std::string& prefix) {
    std::string text;
    for (const Table* table : all_tables()) {
        const std::string id = table->id == "case" ? "" : std::string(table->id) + ".";
        bool has_header = false;
        for (const Key& key : table->keys) {
            const std::string name = id + std::string(key.name);
            if (name.rfind(prefix, 0) != 0) {
                continue;
            }
            if (!has_header) {
                text += fmt::format("{}{}\n", text.empty() ? "" : "\n", table->header);
                has_header = true;
            }
            text += fmt::format("  {:<24} {}\n", key.name, key.help);
            text += fmt::format("  {:<24} {}; {}{}\n", "", forms_text(key),
                                key.is_required ? "required" : "default " + default_text(key),
                                key.methods.empty() ? "" : "; method " + methods_text(key));
        }
    }
    return text;
}

}  // namespace riprap::scene
