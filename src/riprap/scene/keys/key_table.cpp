// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/key_table.hpp"

#include <algorithm>
#include <iterator>

namespace riprap::scene {

const Key* Table::find(std::string_view name) const {
    const auto it = std::find_if(keys.begin(), keys.end(), [name](const Key& key) { return key.name == name; });
    return it == keys.end() ? nullptr : &*it;
}

bool Key::is_of(std::string_view word) const {
    return methods.empty() || std::find(methods.begin(), methods.end(), word) != methods.end();
}

Table Table::part_of(std::string_view word) const {
    Table part{id, header, help, {}, groups, methods, this, word};
    std::copy_if(keys.begin(), keys.end(), std::back_inserter(part.keys),
                 [word](const Key& key) { return key.is_of(word); });
    return part;
}

namespace {

void collect_form(const Form& form, std::vector<const Table*>& found);

void collect(const Table& table, std::vector<const Table*>& found) {
    if (std::find(found.begin(), found.end(), &table) != found.end()) {
        return;
    }
    found.push_back(&table);
    for (const Key& key : table.keys) {
        for (const Form& form : key.forms) {
            collect_form(form, found);
        }
    }
}

void collect_form(const Form& form, std::vector<const Table*>& found) {
    if (form.table != nullptr) {
        collect(form.table(), found);
    }
    for (const Form& item : form.item) {
        collect_form(item, found);
    }
}

}  // namespace

std::vector<const Table*> all_tables() {
    std::vector<const Table*> found;
    collect(case_table(), found);
    return found;
}

namespace form {
Form boolean() { return {.kind = FormKind::boolean}; }
Form integer(double low, double high) { return {.kind = FormKind::integer, .range = {.low = low, .high = high}}; }
Form number(const Dimension& dimension, const Range& range) {
    return {.kind = FormKind::number, .dimension = dimension, .range = range};
}
Form text() { return {.kind = FormKind::text}; }
Form name() { return {.kind = FormKind::name}; }
Form path() { return {.kind = FormKind::path}; }
Form choice(std::vector<std::string_view> words) { return {.kind = FormKind::choice, .words = std::move(words)}; }
Form vector(const Dimension& dimension, const Range& range) {
    return {.kind = FormKind::vector, .dimension = dimension, .range = range};
}
Form direction() { return {.kind = FormKind::vector, .is_nonzero = true}; }
Form axis() { return {.kind = FormKind::vector, .is_nonzero = true, .is_axial = true}; }
Form spin(const Dimension& dimension) { return {.kind = FormKind::vector, .dimension = dimension, .is_axial = true}; }
Form list(Form item, std::int64_t min_count, std::int64_t max_count) {
    return {.kind = FormKind::list, .item = {std::move(item)}, .min_count = min_count, .max_count = max_count};
}
Form table(const Table& (*table)()) { return {.kind = FormKind::table, .table = table}; }
Form table_list(const Table& (*table)(), std::int64_t min_count) {
    return {.kind = FormKind::table_list, .min_count = min_count, .table = table};
}
Form named_tables(const Table& (*table)(), std::int64_t max_count) {
    return {.kind = FormKind::named_tables, .max_count = max_count, .table = table};
}
Key optional_key(std::string_view name, std::vector<Form> forms, std::string help) {
    return {name, std::move(forms), std::move(help), std::nullopt};
}
Key required_key(std::string_view name, std::vector<Form> forms, std::string help) {
    return {name, std::move(forms), std::move(help), std::nullopt, true};
}
Key key_or(std::string_view name, std::vector<Form> forms, Value otherwise, std::string help) {
    return {name, std::move(forms), std::move(help), std::move(otherwise)};
}
}  // namespace form

}  // namespace riprap::scene
