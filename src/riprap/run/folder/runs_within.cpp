// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/folder/runs_within.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "riprap/run/folder/run_folder.hpp"

namespace riprap::run {

namespace fs = std::filesystem;

std::string runs_within(const fs::path& folder) {
    std::error_code error;
    fs::path first;
    std::size_t count = 0;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (fs::exists(RunFolder{entry->path()}.ticket(), ignored)) {
            first = count == 0 ? entry->path() : std::min(first, entry->path());
            ++count;
        }
    }
    return count == 0 ? ""
                      : fmt::format("it holds {} run{}; give one of them, such as {}", count, count == 1 ? "" : "s",
                                    first.string());
}

}  // namespace riprap::run
