// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "riprap/material/property_keys.hpp"
#include "riprap/scene/keys/methods.hpp"

namespace riprap::scene {
namespace {

/// The sources that read a resolved case.
std::string reader_sources() {
    std::string text;
    const auto append = [&text](const std::filesystem::path& path) {
        std::ifstream file(path);
        text.append(std::istreambuf_iterator<char>(file), {});
    };
    for (const char* folder : {"src/riprap/scene/build", "src/riprap/scene/warnings"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            append(entry.path());
        }
    }
    append("src/riprap/scene/read_case.cpp");
    append("src/riprap/run/ensemble.cpp");           // [[spread]]
    append("src/riprap/run/settle.cpp");             // settle_static and others
    append("src/riprap/validation/case_files.cpp");  // published, close, bookkeeping
    return text;
}

TEST(KeyTable, no_key_is_left_that_the_reader_does_not_name) {
    std::set<std::string_view> bound{"method"};  // read by the list that makes them
    for (const auto& methods : {SolidMethods::all(), FluidMethods::all()}) {
        for (const Method& method : methods) {
            for (const Key& key : method.keys) {
                bound.insert(key.name);
            }
        }
    }
    for (const auto& rows : {rows_of(fluid_model_keys()), rows_of(output_keys()), rows_of(time_keys())}) {
        for (const Key& key : rows) {
            bound.insert(key.name);
        }
    }
    for (const auto& key : material::material_keys()) {
        bound.insert(key.key.row.name);
    }
    for (const auto& key : material::pair_keys()) {
        bound.insert(key.key.row.name);
    }
    const std::string sources = reader_sources();
    ASSERT_GT(sources.size(), 10000U);
    for (const Table* table : all_tables()) {
        for (const Key& key : table->keys) {
            const std::string literal = '"' + std::string(key.name) + '"';
            EXPECT_TRUE(bound.contains(key.name) || sources.find(literal) != std::string::npos)
                << table->id << "." << key.name << " is accepted and nothing reads it";
        }
    }
}

}  // namespace
}  // namespace riprap::scene
