// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "riprap/core/error.hpp"
#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/scene/text/value.hpp"

// Reads bytes as a case file up to the resolved values, which must read back to the same text. Building the Model is
// left out: a valid case may ask for a million blocks, which says nothing about the reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace riprap;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const bool is_planar : {false, true}) {
        std::vector<Diagnostic> problems;
        const scene::Value root = scene::parse_toml(text, "fuzz", problems);
        const scene::Value resolved = scene::check_keys(root, scene::case_table(), is_planar, problems);
        const std::string written = scene::write_toml(resolved);
        if (!problems.empty()) {
            continue;
        }
        const scene::Value again = scene::parse_toml(written, "resolved", problems);
        if (scene::write_toml(scene::check_keys(again, scene::case_table(), is_planar, problems)) != written ||
            !problems.empty()) {
            std::abort();
        }
    }
    return 0;
}
