// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/find_case.hpp"

#include <algorithm>
#include <fstream>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::run {

namespace {

namespace fs = std::filesystem;

constexpr const char* case_file_name = "case.toml";
constexpr int build_depth = 4;   // build/<preset>/apps/riprap lies this far below the source tree
constexpr int suite_depth = 3;   // validation/<suite>/<case>/case.toml
constexpr int title_lines = 50;  // a title stands near the top or nowhere

/// The text of `title = "..."`, read without parsing: a listing must not fail on a broken case.
std::string title_of(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    for (int i = 0; i < title_lines && std::getline(in, line); ++i) {
        const std::size_t equals = line.find('=');
        if (line.rfind("title", 0) == 0 && equals != std::string::npos) {
            const std::size_t open = line.find('"', equals), close = line.rfind('"');
            return open < close ? line.substr(open + 1, close - open - 1) : "";
        }
    }
    return "";
}

std::vector<fs::path>& added_roots() {
    static std::vector<fs::path> roots;
    return roots;
}

/// The known case that is most likely meant, as a question; empty when none is near.
std::string did_you_mean(const std::string& text) {
    std::vector<std::string> names;
    for (const char* collection : {"cases", "validation"}) {
        for (const KnownCase& known : known_cases(collection)) {
            names.push_back(known.name);
        }
    }
    std::string meant = scene::nearest(text, names);
    if (meant.empty()) {  // "cases/hello_blok"
        meant = scene::nearest(fs::path(text).filename().string(), names);
    }
    return meant.empty() ? "" : "; did you mean '" + meant + "'?";
}

}  // namespace

void add_case_root(const fs::path& folder) { added_roots().push_back(folder); }

std::vector<fs::path> case_roots() {
    std::error_code error;
    std::vector<fs::path> roots{"."};
    fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    roots.push_back(folder.parent_path() / "share" / "riprap");
    for (int i = 0; i < build_depth && folder.has_parent_path(); ++i) {
        folder = folder.parent_path();
        if (fs::is_directory(folder / "cases", error) && fs::is_regular_file(folder / "CMakeLists.txt", error)) {
            roots.push_back(folder);
        }
    }
    roots.insert(roots.end(), added_roots().begin(), added_roots().end());
    return roots;
}

fs::path find_case(const std::string& text) {
    std::error_code error;
    fs::path path(text);
    if (fs::is_directory(path, error)) {
        if (fs::is_regular_file(path / case_file_name, error)) {
            return path / case_file_name;
        }
        throw FileError("the folder '" + text + "' holds no case.toml");
    }
    if (fs::exists(path, error)) {
        return path;
    }
    // A name such as "hello_block" or "zhao/sliding"; a path that leads upwards is not a name.
    const bool is_name = path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
    for (const fs::path& root : is_name ? case_roots() : std::vector<fs::path>{}) {
        for (const char* collection : {"cases", "validation"}) {
            fs::path found = root / collection / path / case_file_name;
            if (fs::is_regular_file(found, error)) {
                return found;
            }
        }
    }
    throw FileError("there is no case '" + text +
                    "': neither a file, nor a folder with a case.toml, nor a name that `riprap list` knows" +
                    did_you_mean(text));
}

std::string short_name(const fs::path& case_file) {
    if (case_file.filename() != case_file_name) {
        return case_file.stem().string();
    }
    const std::string folder = fs::absolute(case_file).parent_path().filename().string();
    return folder.empty() ? "case" : folder;
}

std::vector<KnownCase> known_cases(const std::string& collection) {
    std::vector<KnownCase> cases;
    std::error_code error;
    for (const fs::path& root : case_roots()) {
        const fs::path folder = root / collection;
        if (!fs::is_directory(folder, error)) {
            continue;
        }
        for (auto entry = fs::recursive_directory_iterator(folder, error); entry != fs::end(entry); ++entry) {
            if (entry.depth() >= suite_depth) {
                entry.disable_recursion_pending();
            }
            const std::string name = entry->path().parent_path().lexically_relative(folder).generic_string();
            const auto has_name = [&name](const KnownCase& known) { return known.name == name; };
            if (entry->path().filename() == case_file_name && std::none_of(cases.begin(), cases.end(), has_name)) {
                const fs::path file = entry->path();
                cases.push_back({name, title_of(file), file.lexically_normal()});
            }
        }
    }
    std::sort(cases.begin(), cases.end(), [](const KnownCase& a, const KnownCase& b) { return a.name < b.name; });
    return cases;
}

}  // namespace riprap::run
