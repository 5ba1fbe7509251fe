// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.hpp"
#include "io/temporary_folder.hpp"
#include "run/falling_blocks.hpp"

namespace riprap {

inline void limit_file_size(rlim_t bytes) {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
}

/// Runs of one small case in a temporary folder.
class RunFixture : public ::testing::Test {
 protected:
    static constexpr int full_steps = 400;

    /// Results that must not depend on how often a run was stopped: the hash of its State, and its files.
    struct Whole {
        std::string hash;
        std::map<std::string, std::string> files;
    };

    RunFixture() { case_file_ = write_case("case.toml", case_text()); }

    /// Short steps of a round length, frequent output and a checkpoint every few milliseconds.
    static std::string case_text() {
        std::string text = falling_blocks_text();
        const std::string end = "end     = 0.5";
        text.replace(text.find(end), end.size(), "end = 0.1\ntime_step = 0.00025");
        const std::string probe = "[[output.probe]]";
        return text.insert(text.find(probe),
                           "[output]\ninterval = 0.01\nprobe_interval = 0.0005\ncheckpoint_interval = 0.005\n\n");
    }
    std::string write_case(const std::string& name, const std::string& text) const {
        write_file(name, text);
        return folder / name;
    }
    void write_file(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
    const std::string& case_file() const { return case_file_; }
    std::string out(const std::string& name) const { return folder / name; }
    /// A file of a run folder.
    std::string in(const std::string& run, const std::string& name) const { return folder.path() / run / name; }
    Ending run(const std::vector<std::string>& arguments) const { return run_program(folder.path(), arguments); }
    nlohmann::json summary_of(const std::string& name) const {
        return nlohmann::json::parse(text_of(in(name, "summary.json")));
    }
    /// Waits until a run has written its first checkpoint and some rows.
    void wait_for_steps(const std::string& name) const {
        for (int i = 0; i < 2000 && text_of(in(name, "run.log")).find("checkpoint") == std::string::npos; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }
    Whole files_of(const std::string& name) const {
        Whole whole{summary_of(name).at("state_hash"), {}};
        for (const auto& entry : std::filesystem::recursive_directory_iterator(out(name))) {
            const std::string extension = entry.path().extension().string();
            if (extension == ".csv" || extension == ".vtp" || extension == ".pvd") {
                whole.files[entry.path().lexically_relative(out(name)).string()] = text_of(entry.path());
            }
        }
        return whole;
    }
    Whole whole_run(const std::string& threads) const {
        const Ending ending = run({"run", case_file(), "--out", out("whole"), "--threads", threads});
        EXPECT_EQ(ending.code, 0) << ending.err;
        return files_of("whole");
    }
    void expect_same(const Whole& whole, const std::string& name) const {
        const Whole other = files_of(name);
        EXPECT_EQ(other.hash, whole.hash) << name;
        for (const auto& [file, text] : whole.files) {
            const auto found = other.files.find(file);
            ASSERT_NE(found, other.files.end()) << file;
            EXPECT_TRUE(found->second == text) << name << "/" << file << " differs";
        }
    }

    const TemporaryFolder folder;

 private:
    std::string case_file_;
};

}  // namespace riprap
