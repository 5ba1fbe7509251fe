// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/key_unit.hpp"

#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/text/override_paths.hpp"

namespace riprap::scene {

namespace {

/// Returns the unit of the first form that has one.
std::string unit_among(const std::vector<Form>& forms) {
    for (const Form& form : forms) {
        if ((form.kind == FormKind::number || form.kind == FormKind::vector) && !form.dimension.is_plain()) {
            return si_unit(form.dimension);
        }
        if (const std::string inner = unit_among(form.item); !inner.empty()) {
            return inner;
        }
    }
    return "";
}

/// Looks for the key that the steps from `next` on name in a table.
std::string unit_below(const Table& table, const std::vector<std::string>& steps, std::size_t next) {
    const Key* key = next < steps.size() ? table.find(base_of_key(steps[next])) : nullptr;
    if (key == nullptr) {
        return "";
    }
    for (const Form& form : key->forms) {
        if (form.table != nullptr) {
            const std::size_t named = form.kind == FormKind::table ? 0 : 1;  // a name or number before the key
            if (std::string unit = unit_below(form.table(), steps, next + 1 + named); !unit.empty()) {
                return unit;
            }
        }
    }
    return unit_among(key->forms);
}

}  // namespace

std::string unit_of_key(std::string_view path) {
    const std::vector<std::string> steps = split_path(path);
    const std::string_view last = steps.empty() ? std::string_view() : steps.back(), base = base_of_key(last);
    const std::string unit = unit_below(case_table(), steps, 0);
    return unit.empty() || base.size() == last.size() ? unit : std::string(last.substr(base.size() + 1));
}

}  // namespace riprap::scene
