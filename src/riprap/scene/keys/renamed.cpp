// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/renamed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

namespace {

/// Keys that take the name of a quantity of the scene.
constexpr std::array quantity_keys{KeyPlace{"output.probe", "quantity"}, KeyPlace{"expect", "quantity"}};

/// A quantity of the scene that became an account of the ledger of the solids or of the fluid.
constexpr Renamed account(std::string_view word, std::string_view now) { return {quantity_keys, word, now, "", "0.3"}; }

constexpr std::array rows{
    Renamed{quantity_keys, "pair_count", "", "\"contact_count\", the contacts that push", "0.2"},
    // The quantity of a body kept its name, that of all bodies did not.
    Renamed{quantity_keys, "kinetic_energy", "solid.kinetic", "", "0.3", "body"},
    account("potential_energy", "solid.potential"),
    account("elastic_energy", "solid.elastic"),
    account("shear_energy", "solid.shear"),
    account("dissipated_friction", "solid.friction"),
    account("dissipated_contact", "solid.contact_damping"),
    account("dissipated_damping", "solid.damping"),
    account("work_driven", "solid.driven"),
    account("work_external", "solid.external"),
    account("work_gravity_change", "solid.gravity_change"),
    account("work_released", "solid.released"),
    account("water_kinetic_energy", "fluid.kinetic"),
    account("water_potential_energy", "fluid.potential"),
    account("water_internal_energy", "fluid.internal"),
    account("water_dissipated_viscous", "fluid.viscous"),
    account("water_dissipated_diffusion", "fluid.diffusion"),
    account("water_shifted", "fluid.shifting"),
    account("water_work_on_solids", "fluid.work_on_solids"),
    account("water_wall_exchange", "fluid.wall_exchange"),
    account("water_work_external", "fluid.external"),
    account("water_absorbed", "fluid.absorbed"),
    account("water_flow_work", "fluid.flow_work"),
    account("water_transported", "fluid.transported"),
};

/// Names that the file gives its own records: an expected answer may ask for one that is called like an old word.
std::vector<std::string> names_of_records(const Value& root) {
    std::vector<std::string> names;
    const Value* output = root.find("output");
    for (const Entry& list : output != nullptr ? output->entries : std::vector<Entry>{}) {
        for (const Value& record : list.value.items) {
            if (const Value* name = record.find("name"); name != nullptr && name->is_text()) {
                names.push_back(name->text);
            }
        }
    }
    return names;
}

class Finder {
 public:
    Finder(std::span<const Renamed> names, std::vector<std::string> own) : rows_(names), own_(std::move(own)) {}

    void look(Value& given, const Table& table) {
        for (Entry& entry : given.entries) {
            rename_key(entry, given, table);
            const auto suffixed = split_unit_suffix(entry.key);
            const Key* key = table.find(entry.key);
            if (key == nullptr && suffixed) {
                key = table.find(suffixed->base);
            }
            if (key == nullptr) {
                continue;
            }
            if (entry.value.is_text()) {
                rename_word(entry.value, key->name, given, table);
            }
            for (const Form& form : key->forms) {
                look_into(entry.value, form);
            }
        }
    }

    std::vector<OldName> found;

 private:
    std::span<const Renamed> rows_;
    std::vector<std::string> own_;

    void look_into(Value& value, const Form& form) {
        if (form.kind == FormKind::table && value.is_table()) {
            look(value, form.table());
        } else if (form.kind == FormKind::named_tables && value.is_table()) {
            for (Entry& entry : value.entries) {
                look(entry.value, form.table());
            }
        } else if (form.kind == FormKind::table_list && value.is_array()) {
            for (Value& item : value.items) {
                look(item, form.table());
            }
        }
    }

    static bool is_at(const Renamed& row, std::string_view table, std::string_view key) {
        return std::any_of(row.places.begin(), row.places.end(),
                           [&](const KeyPlace& place) { return place.table == table && place.key == key; });
    }

    void rename_key(Entry& entry, const Value& given, const Table& table) {
        const auto suffixed = split_unit_suffix(entry.key);
        for (const Renamed& row : rows_) {
            const bool is_whole = is_at(row, table.id, entry.key);
            if (!row.word.empty() || (!is_whole && !(suffixed && is_at(row, table.id, suffixed->base)))) {
                continue;
            }
            const std::string unit = is_whole ? "" : entry.key.substr(suffixed->base.size());
            std::string now = row.now.empty() ? "" : std::string(row.now) + unit;
            if (given.find(row.now) != nullptr || given.find(now) != nullptr) {
                now.clear();
            }
            found.push_back({&row, entry.place, entry.key, now});
            entry.key = now.empty() ? entry.key : now;
            return;
        }
    }

    void rename_word(Value& value, std::string_view key, const Value& given, const Table& table) {
        if (table.id == "expect" && std::find(own_.begin(), own_.end(), value.text) != own_.end()) {
            return;
        }
        for (const Renamed& row : rows_) {
            if (row.word.empty() || row.word != value.text || !is_at(row, table.id, key) ||
                (!row.alone.empty() && given.find(row.alone) != nullptr)) {
                continue;
            }
            found.push_back({&row, value.place, value.text, std::string(row.now)});
            value.text = row.now.empty() ? value.text : std::string(row.now);
            return;
        }
    }
};

}  // namespace

std::span<const Renamed> renamed_names() { return rows; }

std::vector<OldName> rename_old(Value& root, const Table& table, std::span<const Renamed> names) {
    Finder finder(names, names_of_records(root));
    finder.look(root, table);
    return finder.found;
}

Diagnostic problem_of(const OldName& old) {
    const Renamed& row = *old.row;
    const std::string key(row.places.front().key);
    if (!old.now.empty()) {
        return {
            old.place,
            fmt::format(
                "{} is called {} since version {}",
                row.word.empty() ? fmt::format("key '{}'", old.before) : fmt::format("{} = \"{}\"", key, old.before),
                row.word.empty() ? fmt::format("'{}'", old.now) : fmt::format("\"{}\"", old.now), row.since),
            "`riprap upgrade` writes the new name into the file"};
    }
    return {old.place,
            fmt::format("{} '{}' is not read since version {}", row.word.empty() ? "key" : key, old.before, row.since),
            row.now.empty() ? std::string(row.advice)
                            : fmt::format("'{}' replaces it and is there already; leave one of them out", row.now)};
}

void check_format(const Value& root, std::vector<Diagnostic>& problems) {
    const Value* format = root.find("format");
    if (format != nullptr && format->kind == ValueKind::integer && format->integer > newest_format) {
        problems.push_back({format->place,
                            fmt::format("format = {} is newer than this program, which reads case files of format {}",
                                        format->integer, newest_format),
                            fmt::format("a newer Riprap, or a case file of format {}", newest_format)});
    }
}

}  // namespace riprap::scene
