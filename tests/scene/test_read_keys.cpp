// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "riprap/body/prescribed_motion.hpp"
#include "riprap/fluid/flow/flows.hpp"
#include "riprap/io/output/output_kinds.hpp"
#include "riprap/material/property_keys.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/shapes/shape_kind.hpp"

namespace riprap::scene {
namespace {

/// The sources that read a resolved case, without the rows of the key table that stand among them. A key that is bound
/// to a member stays: whoever names it reads it.
std::string reader_sources() {
    std::string text;
    const auto append = [&text](const std::filesystem::path& path) {
        std::ifstream file(path);
        text.append(std::istreambuf_iterator<char>(file), {});
    };
    for (const char* folder : {"src/riprap/scene/assemble", "src/riprap/scene/case", "src/riprap/scene/motions",
                               "src/riprap/scene/shapes", "src/riprap/scene/warnings"}) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            append(entry.path());
        }
    }
    append("src/riprap/scene/read_case.cpp");
    append("src/riprap/run/ensemble/members.cpp");   // [[spread]]
    append("src/riprap/run/simulate/settle.cpp");    // settle_static and others
    append("src/riprap/validation/case_files.cpp");  // published, close, bookkeeping
    static const std::regex row("(optional_key|required_key|key_or)\\(\\s*\"[a-z_]+\"");
    return std::regex_replace(text, row, "");
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
    for (const auto& rows :
         {rows_of(fluid_model_keys()), rows_of(output_keys()), rows_of(io::output_keys()), rows_of(time_keys())}) {
        for (const Key& key : rows) {
            bound.insert(key.name);
        }
    }
    for (const ShapeKind& kind : shape_kinds()) {  // made by the list
        bound.insert(kind.row.name);
    }
    body::MotionLaws::for_each([&bound]<class Law>() {
        bound.insert(Law::word);
        if constexpr (requires { Law::keys(); }) {
            for (const auto& key : Law::keys()) {
                bound.insert(key.row.name);
            }
        }
    });
    fluid::FlowLaws::for_each([&bound]<class Law>() {
        bound.insert(Law::word);
        for (const auto& key : Law::keys()) {
            bound.insert(key.row.name);
        }
    });
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
