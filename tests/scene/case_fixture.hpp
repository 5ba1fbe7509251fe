// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::scene::test {

/// A folder that lives as long as a test.
class TemporaryFolder {
 public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "riprap-scene-XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
    }

 private:
    std::filesystem::path path_;
};

/// Tests run in the root of the tree.
inline std::filesystem::path source_folder() { return "."; }

/// The shortest useful case; tests append to it or replace lines of it.
inline const std::string minimal_case = R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
material = "rock"
shape = { box = [1.0, 1.0, 0.5] }
)";

/// `text` with the first `from` replaced by `to`.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

inline LoadedCase read(const std::string& text, const std::vector<std::string>& overrides = {},
                       const std::string& folder = "/nonexistent") {
    return read_case_text(text, "case.toml", folder, overrides);
}

/// Every problem of a case as one line each, "file:line:column: message; allowed".
inline std::vector<std::string> problems_of(const std::string& text, const std::vector<std::string>& overrides = {},
                                            const std::string& folder = "/nonexistent") {
    try {
        read(text, overrides, folder);
    } catch (const CaseError& error) {
        std::vector<std::string> lines;
        for (const Diagnostic& problem : error.problems()) {
            lines.push_back(to_string(problem));
        }
        return lines;
    }
    return {};
}

}  // namespace riprap::scene::test
