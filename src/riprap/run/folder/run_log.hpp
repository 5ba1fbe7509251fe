// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

/// Records events of a run with their time: run.log for people, run.jsonl (one JSON object per line) for programs. A
/// resumed run appends to both.
class RunLog {
 public:
    using Numbers = std::initializer_list<std::pair<std::string_view, double>>;

    /// Takes the warnings of earlier processes over. @throws FileError
    explicit RunLog(const RunFolder& folder);

    /// One event: its kind ("start", "frame", "checkpoint", ...), a sentence, and the numbers a program may want.
    void add(std::string_view kind, const std::string& text, Numbers numbers = {});

    /// Texts of the events of kind "warning" in the order in which they came, over all processes that ran it, each
    /// once.
    const std::vector<std::string>& warnings() const { return warnings_; }

 private:
    void keep_warning(const std::string& text);

    std::filesystem::path log_path_, events_path_;
    io::FileDescriptor log_, events_;
    std::vector<std::string> warnings_;
};

}  // namespace riprap::run
