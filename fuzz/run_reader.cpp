// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "riprap/core/error.hpp"
#include "riprap/view/read_run.hpp"

namespace {

namespace fs = std::filesystem;

/// A folder for all inputs of one program.
const fs::path& folder() {
    static const fs::path path = [] {
        std::string name = (fs::temp_directory_path() / "riprap-fuzz-XXXXXX").string();
        return fs::path(mkdtemp(name.data()));
    }();
    return path;
}

constexpr std::array<const char*, 7> files{"run.json", "probes.csv",    "ledger.csv",  "bodies.csv",
                                           "run.log",  "resolved.toml", "summary.json"};

}  // namespace

// Reads bytes as the files of a run folder, cut at its zero bytes. A folder is read with
// notices on what is damaged, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string all(reinterpret_cast<const char*>(data), size);
    std::size_t at = 0;
    for (const char* file : files) {
        const std::size_t end = std::min(all.find('\0', at), all.size());
        std::ofstream(folder() / file, std::ios::binary) << all.substr(at, end - at);
        at = std::min(end + 1, all.size());
    }
    try {
        riprap::view::read_run(folder());
    } catch (const riprap::FileError&) {
    } catch (const riprap::CaseError&) {
    }
    return 0;
}
