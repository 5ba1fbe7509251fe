// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

class Lists : public RunFixture {};

TEST_F(Lists, KnownCasesAreListedAndFoundByName) {
    const nlohmann::json list = nlohmann::json::parse(run({"list", "--json"}).out);
    std::map<std::string, nlohmann::json> files;
    for (const auto& known : list.at("validation")) {
        files[known.at("name")] = known.at("file");
        EXPECT_NE(known.at("title"), "") << known.at("name");
    }
    EXPECT_TRUE(files.at("zhao/incline").get<std::string>().ends_with("incline/case.toml"));
    EXPECT_TRUE(files.at("rigid/granular_round").get<std::string>().ends_with("granular_round/case.toml"));
    bool has_hello = false;
    for (const auto& known : list.at("cases")) {
        has_hello = has_hello || known.at("name") == "hello_block";
        EXPECT_NE(known.at("title"), "") << known.at("name");
    }
    EXPECT_TRUE(has_hello);
    EXPECT_EQ(run({"check", "hello_block"}).code, 0);
}

}  // namespace
}  // namespace riprap
