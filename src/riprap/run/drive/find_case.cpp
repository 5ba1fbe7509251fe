// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/find_case.hpp"

#include <algorithm>
#include <array>
#include <fstream>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::run {

namespace {

namespace fs = std::filesystem;

constexpr const char* case_file_name = "case.toml";
constexpr std::array<const char*, 2> collections{"cases", "validation"};
constexpr int build_depth = 4;   // build/<preset>/apps/riprap lies this far below the source tree
constexpr int suite_depth = 3;   // validation/<suite>/<case>/case.toml
constexpr int title_lines = 50;  // a title stands near the top or nowhere
constexpr std::size_t most_meant = 3;

/// Title and source of a case file, read without parsing: a listing must not fail on a broken case.
KnownCase headed(KnownCase known) {
    std::ifstream in(known.file);
    std::string line;
    for (int i = 0; i < title_lines && std::getline(in, line); ++i) {
        const std::size_t open = line.find('"'), close = line.rfind('"');
        const std::string key = line.substr(0, line.find_first_of(" ="));
        if ((key == "title" || key == "source") && open < close) {
            (key == "title" ? known.title : known.source) = line.substr(open + 1, close - open - 1);
        }
        if (line.starts_with('[')) {
            break;
        }
    }
    return known;
}

std::vector<fs::path>& added_roots() {
    static std::vector<fs::path> roots;
    return roots;
}

/// A path below `cases/` or `validation/` without that folder: "validation/ding/arch" is "ding/arch".
fs::path below_collection(const fs::path& path) {
    const auto& known = collections;
    const bool has_folder = !path.empty() && std::find(known.begin(), known.end(), *path.begin()) != known.end();
    return has_folder ? path.lexically_relative(*path.begin()) : path;
}

/// Names of cases in the suite of `name`, or in any where it has none, that contain its last part or that are
/// misspelt by it: at most `most_meant`, the nearest first.
std::vector<std::string> nearest_names(const fs::path& name) {
    const std::string suite = name.parent_path().generic_string(), last = name.filename().string();
    std::vector<std::string> all, meant;
    for (const char* collection : collections) {
        for (const KnownCase& known : known_cases(collection)) {
            const fs::path path(known.name);
            all.push_back(known.name);
            const bool is_part = last.size() >= 3 && path.filename().string().find(last) != std::string::npos;
            if (is_part && (suite.empty() || path.parent_path() == suite)) {
                meant.push_back(known.name);
            }
        }
    }
    const auto distance = [&name](const std::string& known) {
        return scene::edit_distance(name.generic_string(), known);
    };
    std::stable_sort(meant.begin(), meant.end(),
                     [&distance](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
    for (const std::string& word : {name.generic_string(), last}) {
        const std::string near = meant.empty() ? scene::nearest(word, all) : "";
        if (!near.empty()) {
            meant.push_back(near);
        }
    }
    meant.resize(std::min(meant.size(), most_meant));
    return meant;
}

/// Known cases that are most likely meant, as a question; empty when none is near.
std::string did_you_mean(const std::string& text) {
    const std::vector<std::string> names = nearest_names(below_collection(text));
    std::string question;
    for (std::size_t i = 0; i < names.size(); ++i) {
        question += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + ("'" + names[i] + "'");
    }
    return question.empty() ? "" : "; did you mean " + question + "?";
}

/// The file of a case below one root, by its name or by its path from there; empty where there is none.
fs::path file_below(const fs::path& root, const fs::path& name) {
    std::error_code error;
    std::vector<fs::path> places;
    for (const char* collection : collections) {
        places.push_back(root / collection / name);
    }
    if (below_collection(name) != name) {  // "validation/ding/planar_arch", outside of that root
        places.push_back(root / name);
    }
    for (const fs::path& place : places) {
        for (const fs::path& file : {place / case_file_name, place}) {
            if (file.filename() == case_file_name && fs::is_regular_file(file, error)) {
                return file;
            }
        }
    }
    return {};
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
        fs::path found = file_below(root, path);
        if (!found.empty()) {
            return found;
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
                cases.push_back(headed({name, "", "", entry->path().lexically_normal()}));
            }
        }
    }
    std::sort(cases.begin(), cases.end(), [](const KnownCase& a, const KnownCase& b) { return a.name < b.name; });
    return cases;
}

}  // namespace riprap::run
