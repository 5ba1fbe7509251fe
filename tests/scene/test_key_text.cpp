// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/key_text.hpp"

namespace riprap::scene {
namespace {

using testing::HasSubstr;

TEST(KeyTable, every_key_is_named_explained_and_has_a_form) {
    std::set<std::string_view> ids;
    for (const Table* table : all_tables()) {
        EXPECT_TRUE(ids.insert(table->id).second) << table->id;
        EXPECT_FALSE(table->help.empty()) << table->id;
        std::set<std::string_view> names;
        for (const Key& key : table->keys) {
            const auto has_name = [&key](const Key& other) { return other.name == key.name; };
            for (const std::string_view method : table->methods) {
                const Table part = table->part_of(method);
                EXPECT_LE(std::count_if(part.keys.begin(), part.keys.end(), has_name), 1) << method << " " << key.name;
            }
            EXPECT_TRUE(names.insert(key.name).second || !key.methods.empty()) << table->id << "." << key.name;
            EXPECT_GT(key.help.size(), 5U) << table->id << "." << key.name;
            EXPECT_EQ(key.help.back(), '.') << table->id << "." << key.name;
            EXPECT_FALSE(key.forms.empty()) << table->id << "." << key.name;
            EXPECT_FALSE(key.is_required && key.otherwise) << table->id << "." << key.name;
        }
        for (const Group& group : table->groups) {
            for (const std::string_view key : group.keys) {
                EXPECT_TRUE(names.contains(key)) << table->id << ": group names '" << key << "'";
            }
        }
    }
    EXPECT_GE(ids.size(), 25U);
}

TEST(KeyTable, every_default_passes_its_own_check) {
    for (const Table* table : all_tables()) {
        for (const Key& key : table->keys) {
            if (!key.otherwise || key.otherwise->is_table()) {
                continue;
            }
            // A table of this one key: whatever else it lacks, the default itself must not be refused.
            Table alone{"alone", "alone", "One key.", {key}};
            alone.keys.front().is_required = false;
            Value given = Value::table();
            given.set(key.name, *key.otherwise);
            std::vector<Diagnostic> problems;
            check_keys(given, alone, false, problems);
            EXPECT_TRUE(problems.empty()) << table->id << ": " << to_string(problems.front());
        }
    }
}

TEST(KeyTable, the_manual_page_in_the_repository_is_the_one_the_table_makes) {
    const std::string path = "docs/reference/case-file.md";  // tests run in the root of the tree
    if (std::getenv("RIPRAP_WRITE_REFERENCE") != nullptr) {
        std::ofstream(path) << case_manual();
    }
    std::stringstream page;
    page << std::ifstream(path).rdbuf();
    EXPECT_TRUE(page.str() == case_manual()) << "run test_scene with RIPRAP_WRITE_REFERENCE=1 and commit " << path;
}

TEST(KeyTable, the_listing_shows_keys_with_unit_range_and_default) {
    const std::string listing = key_listing("material.");
    EXPECT_THAT(listing, HasSubstr("density"));
    EXPECT_THAT(listing, HasSubstr("a density [kg/m^3], 0 < value; required"));
    EXPECT_THAT(listing, HasSubstr("default 0.8"));
    EXPECT_EQ(listing.find("gravity"), std::string::npos);
}

TEST(KeyTable, the_schema_names_every_table_and_key) {
    const std::string schema = case_schema();
    for (const Table* table : all_tables()) {
        for (const Key& key : table->keys) {
            EXPECT_THAT(schema, HasSubstr('"' + std::string(key.name) + '"'));
        }
        if (table->id != "case") {
            EXPECT_THAT(schema, HasSubstr('"' + std::string(table->id) + "\": {"));
        }
    }
}

}  // namespace
}  // namespace riprap::scene
