// SPDX-License-Identifier: Apache-2.0
#include "values.hpp"

#include <pybind11/stl.h>

#include <utility>

namespace riprap::python {

namespace py = pybind11;
using scene::Value;

std::string utf8_of(const py::handle& text, const std::string& path) {
    try {
        return text.cast<std::string>();
    } catch (const py::cast_error&) {
        throw py::value_error(path + " holds half of a surrogate pair, which is no character; a case is text in UTF-8");
    }
}

namespace {

constexpr int deepest = 32;  // a dict that holds itself has no end

Value convert(const py::handle& object, const std::string& path, int depth);

Value convert_table(const py::dict& keys, const std::string& path, int depth) {
    Value table = Value::table();
    for (const auto& [key, value] : keys) {
        if (!py::isinstance<py::str>(key)) {
            throw py::type_error((path.empty() ? "the case" : path) + " has a key that is not a text");
        }
        const std::string name = utf8_of(key, path.empty() ? "a key of the case" : "a key of " + path);
        table.set(name, convert(value, path.empty() ? name : path + "." + name, depth + 1));
    }
    return table;
}

Value convert_list(const py::handle& items, const std::string& path, int depth) {
    Value list = Value::array();
    for (const py::handle& item : items) {
        list.items.push_back(convert(item, path + "[" + std::to_string(list.items.size()) + "]", depth + 1));
    }
    return list;
}

Value convert(const py::handle& object, const std::string& path, int depth) {
    if (depth > deepest) {
        throw py::type_error(path + " is nested too deeply");
    }
    if (py::isinstance<py::bool_>(object)) {
        return Value::of(object.cast<bool>());
    }
    if (py::isinstance<py::int_>(object)) {
        try {
            return Value::of(object.cast<std::int64_t>());
        } catch (const py::cast_error&) {
            throw py::value_error(path + " does not fit into 64 bits");
        }
    }
    if (py::isinstance<py::float_>(object)) {
        return Value::of(object.cast<double>());
    }
    if (py::isinstance<py::str>(object)) {
        return Value::of(std::string_view(utf8_of(object, path)));
    }
    if (py::isinstance<py::dict>(object)) {
        return convert_table(py::reinterpret_borrow<py::dict>(object), path, depth);
    }
    if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
        return convert_list(object, path, depth);
    }
    if (py::hasattr(object, "tolist")) {  // a NumPy scalar or array
        return convert(object.attr("tolist")(), path, depth + 1);
    }
    throw py::type_error(path + " is a " + py::str(py::type::of(object).attr("__name__")).cast<std::string>() +
                         "; a case holds numbers, texts, booleans, lists and dicts");
}

}  // namespace

Value to_value(const py::dict& keys) { return convert_table(keys, "", 0); }

std::vector<std::string> to_overrides(const py::object& overrides) {
    std::vector<std::string> assignments;
    if (overrides.is_none()) {
        return assignments;
    }
    const bool is_list = py::isinstance<py::list>(overrides) || py::isinstance<py::tuple>(overrides);
    if (is_list) {
        for (const py::handle& assignment : overrides) {
            if (!py::isinstance<py::str>(assignment)) {
                throw py::type_error("overrides: a list of them holds texts, [\"end=2.0\"]");
            }
            assignments.push_back(utf8_of(assignment, "an override"));
        }
        return assignments;
    }
    if (!py::isinstance<py::dict>(overrides)) {
        throw py::type_error("overrides is a " + py::str(py::type::of(overrides).attr("__name__")).cast<std::string>() +
                             ": give a dict, {\"end\": 2.0}, or a list of texts, [\"end=2.0\"]");
    }
    for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(overrides)) {
        if (!py::isinstance<py::str>(key)) {
            throw py::type_error("overrides has a key that is not a text");
        }
        const std::string path = utf8_of(key, "a key of overrides");
        const Value converted = convert(value, path, 0);
        if (converted.is_table()) {
            throw py::type_error(path + " is a table; give its keys one by one, as \"" + path + ".key\"");
        }
        Value line = Value::table();
        line.set("v", converted);
        std::string text = scene::write_toml(line);  // v = ...
        text.erase(0, text.find('=') + 1);
        text.erase(text.find_last_not_of('\n') + 1);
        assignments.push_back(path + "=" + text);
    }
    return assignments;
}

py::object from_json(const std::string& text) { return py::module_::import("json").attr("loads")(text); }

}  // namespace riprap::python
