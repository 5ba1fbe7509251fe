// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "io/temporary_folder.hpp"

namespace riprap {
namespace {

/// What a shell command prints on both streams.
std::string said(const std::string& command) {
    std::string text;
    std::array<char, 256> part{};
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    while (fgets(part.data(), part.size(), pipe) != nullptr) {
        text += part.data();
    }
    pclose(pipe);
    return text;
}

TEST(TestScript, NamesInItsLastLineWhatWasNotRun) {
    const TemporaryFolder folder;  // with a clang++ that cannot compile, before any other
    std::ofstream(folder.path() / "clang++") << "#!/bin/sh\nexit 1\n";
    std::filesystem::permissions(folder.path() / "clang++", std::filesystem::perms::owner_all);
    const std::string text = said("PATH=" + folder.path().string() + ":$PATH scripts/test threads clang");
    const std::size_t last = text.rfind('\n', text.size() - 2);
    EXPECT_THAT(text.substr(last + 1),
                testing::AllOf(testing::HasSubstr("Not run: the program under the thread sanitizer (install clang"),
                               testing::HasSubstr("sources as clang reads them (install clang")))
        << text;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("All checks passed")));
}

}  // namespace
}  // namespace riprap
