// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/sweep_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "riprap/io/atomic_file.hpp"
#include "riprap/run/study/sweep.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/override_paths.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::run {

void refuse_study(const SourcePlace& place, std::string message, std::string allowed) {
    throw CaseError(Diagnostic{place, std::move(message), std::move(allowed)});
}

std::string same_of(const std::string& key, const std::vector<std::string>& keys) {
    const std::size_t dot = key.rfind('.') + 1;  // 0 without a dot
    for (const std::string& other : keys) {
        if (other.substr(0, other.rfind('.') + 1) == key.substr(0, dot) &&
            scene::gives_the_same(std::string_view(key).substr(dot),
                                  std::string_view(other).substr(other.rfind('.') + 1))) {
            return other;
        }
    }
    return "";
}

std::string stands_twice(const std::string& key, const std::string& other) {
    return key == other ? fmt::format("'{}' stands twice", key)
                        : fmt::format("'{}' and '{}' give one value", other, key);
}

namespace {

std::string key_of(const std::string& assignment) {
    const std::string key = assignment.substr(0, assignment.find('='));
    const std::size_t first = key.find_first_not_of(" \t\r"), last = key.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : key.substr(first, last - first + 1);
}

/// The case as it is written; empty where that cannot be read, which is told when it is.
scene::Value tree_of(const std::string& path) {
    try {
        std::vector<Diagnostic> problems;
        return scene::parse_toml(io::read_file(path, scene::limits::case_bytes), path, problems);
    } catch (const FileError&) {
        return {};
    }
}

}  // namespace

void refuse_set_and_varied(const SweepOptions& options) {
    const scene::Value tree = tree_of(options.case_path);
    std::vector<std::string> varied, plain;
    for (const std::string& text : options.points.front().overrides) {
        varied.push_back(key_of(text));
        plain.push_back(scene::plain_path(tree, varied.back()));
    }
    for (std::size_t k = 0; k < plain.size(); ++k) {
        if (const auto other = std::find(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(k), plain[k]);
            other != plain.begin() + static_cast<std::ptrdiff_t>(k)) {
            refuse_study({"--vary"}, stands_twice(varied[k], varied[static_cast<std::size_t>(other - plain.begin())]),
                         "all its values behind one --vary");
        }
    }
    for (const std::string& set : options.overrides) {
        const auto found = std::find(plain.begin(), plain.end(), scene::plain_path(tree, key_of(set)));
        if (found != plain.end()) {
            refuse_study({fmt::format("--set {}", set)},
                         fmt::format("'{}' is varied, too", varied[static_cast<std::size_t>(found - plain.begin())]),
                         "a key that is set in all runs, or one that is varied");
        }
    }
}

}  // namespace riprap::run
