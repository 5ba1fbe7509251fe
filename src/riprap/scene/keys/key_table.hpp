// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/key.hpp"
#include "riprap/scene/text/units.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

// The one declarative table of the case file. It drives checking (check_keys.hpp), the listing on the terminal, the
// JSON Schema and the manual page (key_text.hpp). Keys of methods come from the methods (methods.hpp); any other key is
// one row here and one line where it is used.

struct Table;

/// Kind of value that a key takes.
enum class FormKind {
    boolean,
    integer,
    number,       ///< with a dimension; text such as "2.5 cm" is converted
    text,         ///< free text of at most limits::text_bytes
    name,         ///< letters, digits, '_', '-' and '.': safe in file and column names
    path,         ///< a file in the folder of the case
    choice,       ///< one of a few words
    vector,       ///< 3 numbers (2 or 3 in a planar scene)
    list,         ///< array of `item`
    table,        ///< one table
    table_list,   ///< array of tables: [[key]]
    named_tables  ///< table of tables with free names: [key.NAME]
};

/// One way to write the value of a key.
struct Form {
    FormKind kind{FormKind::number};
    Dimension dimension{};                  ///< of numbers and components
    Range range{};                          ///< of a number, integer or component
    std::vector<std::string_view> words{};  ///< of a choice
    std::vector<Form> item{};               ///< of a list: one entry
    std::int64_t min_count{0};              ///< entries of a list
    std::int64_t max_count{std::numeric_limits<std::int64_t>::max()};
    bool is_nonzero{false};            ///< a vector that gives a direction
    bool is_axial{false};              ///< a vector about which something turns: along z in a planar scene
    const Table& (*table)(){nullptr};  ///< of tables; a function, because tables may contain themselves
    friend bool operator==(const Form&, const Form&) = default;
};

/// One row of the table.
struct Key {
    std::string_view name;
    std::vector<Form> forms;  ///< the first whose kind of value fits is used
    std::string help;
    std::optional<Value> otherwise;  ///< default
    bool is_required{false};
    /// Words of the methods that have the key, in a table that chooses a method; in any other table, of the solid
    /// methods that read it. Every one when empty.
    std::vector<std::string_view> methods{};
    std::vector<KeyCondition> conditions{};  ///< the key does nothing unless all hold
    bool is_of(std::string_view word) const;
};

/// Number of keys of a group that may be given.
enum class GroupRule { exactly_one, at_most_one, all_or_none };
struct Group {
    GroupRule rule;
    std::vector<std::string_view> keys;
};

/// A table of the case file: its keys and the rules between them.
struct Table {
    std::string_view id;      ///< unique, for links: "body", "shape.hull"
    std::string_view header;  ///< as written in a case: "[[body]]", "shape = { hull = { ... } }"
    std::string_view help;
    std::vector<Key> keys;
    std::vector<Group> groups{};
    std::vector<std::string_view> methods{};  ///< words of its key "method", the default first; none without the key
    const Table* whole{nullptr};              ///< of a part: the table with the keys of all methods
    std::string_view method{};                ///< of a part: its method

    const Key* find(std::string_view name) const;
    /// The keys that a case with this method may give.
    Table part_of(std::string_view word) const;
};

/// The top of the case file.
const Table& case_table();

/// Every table reachable from case_table(), each once, in reading order.
std::vector<const Table*> all_tables();

// Rows are written with these.
namespace form {
using key::above, key::below, key::between, key::non_negative, key::positive;
Form boolean();
Form integer(double low, double high);
Form number(const Dimension& dimension, const Range& range = {});
Form text();
Form name();
Form path();
Form choice(std::vector<std::string_view> words);
Form vector(const Dimension& dimension, const Range& range = {});
Form direction();
Form axis();
Form spin(const Dimension& dimension);
Form list(Form item, std::int64_t min_count, std::int64_t max_count);
Form table(const Table& (*table)());
Form table_list(const Table& (*table)(), std::int64_t min_count = 0);
Form named_tables(const Table& (*table)(), std::int64_t max_count);

// And rows: of a key without a default, of one that a case has to give, and of one with a default.
Key optional_key(std::string_view name, std::vector<Form> forms, std::string help);
Key required_key(std::string_view name, std::vector<Form> forms, std::string help);
Key key_or(std::string_view name, std::vector<Form> forms, Value otherwise, std::string help);
}  // namespace form

// Tables that live in files of their own.
const Table& gravity_table();
const Table& material_table();
const Table& contact_table();
const Table& solid_table();
const Table& body_table();
const Table& spheres_table();
const Table& shape_table();
const Table& orientation_table();
const Table& motion_table();
const Table& load_data_table();
const Table& load_table();
const Table& repeat_table();
const Table& pack_table();
const Table& rock_mass_table();
const Table& section_table();
const Table& fluid_table();
const Table& output_table();
const Table& expect_table();

}  // namespace riprap::scene
