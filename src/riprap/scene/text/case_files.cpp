// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/case_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "riprap/core/fields.hpp"
#include "riprap/scene/text/file_kinds.hpp"

namespace riprap::scene {

namespace fs = std::filesystem;

namespace {

/// Returns the reason why a path is refused; empty when it stays in the folder.
std::string path_problem(const fs::path& folder, const std::string& path) {
    const fs::path relative(path);
    if (path.find('\0') != std::string::npos || path.size() > 1024) {
        return "is not a usable path";
    }
    if (relative.is_absolute() || path.find('\\') != std::string::npos) {
        return "is not a plain relative path";
    }
    if (std::find(relative.begin(), relative.end(), fs::path("..")) != relative.end()) {
        return "leaves the folder of the case";
    }
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) {
        return fmt::format("cannot be read: the folder of the case is not accessible ({})", error.message());
    }
    const fs::path real = fs::canonical(root / relative, error);
    if (error) {
        return fmt::format("cannot be read: {}", error.message());
    }
    const auto [at_root, at_real] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    if (at_root != root.end()) {
        return "is a link that leaves the folder of the case";
    }
    return fs::is_regular_file(real, error) ? "" : "is not a regular file";
}

}  // namespace

std::optional<std::string> CaseFiles::read(const std::string& path, std::size_t max_bytes, const SourcePlace& place,
                                           std::vector<Diagnostic>& problems) {
    const auto refuse = [&](const std::string& why, std::string allowed) {
        problems.push_back({place, fmt::format("file \"{}\" {}", path.substr(0, 200), why), std::move(allowed)});
        return std::nullopt;
    };
    if (const std::string why = path_problem(folder_, path); !why.empty()) {
        return refuse(why, "a file in the folder of the case, given by a path without \"..\"");
    }
    const fs::path full = folder_ / path;
    std::error_code error;
    const auto size = fs::file_size(full, error);
    if (error || size > max_bytes) {
        return error ? refuse(fmt::format("cannot be read: {}", error.message()), "")
                     : refuse(fmt::format("has {} bytes", size), fmt::format("at most {} are accepted", max_bytes));
    }
    std::ifstream stream(full, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (!stream) {
        return refuse("cannot be read", "check its permissions");
    }
    if (const std::optional<OtherKind> kind = other_kind(text)) {
        return refuse(kind->what, kind->allowed);
    }
    Hasher hasher;
    hasher.add(text.data(), text.size());
    inputs_[path] = hasher.value();
    return text;
}

std::vector<InputFile> CaseFiles::inputs() const {
    std::vector<InputFile> files;
    for (const auto& [path, hash] : inputs_) {
        files.push_back({path, hash});
    }
    return files;
}

}  // namespace riprap::scene
