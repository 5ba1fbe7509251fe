// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/folder/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

#include "riprap/io/output/output_kinds.hpp"
#include "riprap/io/own_file.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/run/folder/runs_within.hpp"
#include "riprap/scene/text/limits.hpp"

namespace riprap::run {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t ticket_limit = std::size_t{1} << 24;

/// Everything a run writes, so that --force removes that and nothing else; the ticket first.
const std::vector<std::string_view>& own_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all{"run.json",  "case",      "resolved.toml", "checkpoint", "frames",
                                          "run.log",   "run.jsonl", "summary.json",  "index.html", "picture.png",
                                          "movie.mp4", "movie",     "plot.svg"};
        const std::vector<std::string_view> files = io::output_files();
        all.insert(all.end(), files.begin(), files.end());
        return all;
    }();
    return names;
}

bool is_own(const std::string& name) { return std::ranges::find(own_names(), name) != own_names().end(); }

/// Names in a folder, without the hidden ones (locks, partial files).
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        std::string name = entry.path().filename().string();
        if (name.front() != '.') {
            names.push_back(std::move(name));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

void refuse_run_there(const RunFolder& folder) {
    if (folder.has_run() && folder.is_ours()) {
        throw FileError("'" + folder.root.string() +
                        "' holds a run already; --resume continues it, --force replaces it, --out writes elsewhere");
    }
}

void refuse_other_files(const RunFolder& folder) {
    const bool is_ours = folder.is_ours();
    for (const std::string& name : names_in(folder.root)) {
        if (!is_ours || !is_own(name)) {
            throw FileError("'" + folder.root.string() + "' is not empty and holds no run (it holds '" + name +
                            "'); --out writes elsewhere, --force puts the run beside what is there");
        }
    }
}

/// --force replaces a run and nothing else: a name of a run that no run of ours wrote stays.
void refuse_names_in_the_way(const RunFolder& folder) {
    for (const std::string& name : names_in(folder.root)) {
        if (is_own(name) && !folder.is_ours()) {
            throw FileError("'" + (folder.root / name).string() +
                            "' is in the way, and no run wrote it: the folder has no run.json of Riprap's; move it "
                            "away, or choose another folder with --out");
        }
    }
}

}  // namespace

FolderLock::FolderLock(const RunFolder& folder) : file_(io::open_plain(folder.lock(), O_RDWR | O_CREAT)) {
    if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) {
            throw FileError("another riprap is writing to '" + folder.root.string() +
                            "'; wait for it or choose another folder with --out");
        }
        throw io::file_error("lock", folder.lock(), errno);
    }
    for (const fs::path& inside : {folder.case_folder(), folder.frames(), folder.checkpoint_latest().parent_path()}) {
        io::refuse_linked_folder(inside);
    }
}

bool is_held(const RunFolder& folder) {
    const io::FileDescriptor file(::open(folder.lock().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    return file.is_open() && ::flock(file.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

std::string status_of(const RunFolder& folder) {
    std::error_code error;
    if (!fs::exists(folder.summary(), error)) {
        return folder.has_run() ? "interrupted" : "not run";
    }
    try {
        const auto summary = nlohmann::json::parse(io::read_file(folder.summary(), ticket_limit), nullptr, false);
        if (summary.is_object() && summary.contains("status") && summary["status"].is_string()) {
            return summary["status"].get<std::string>();
        }
    } catch (const FileError&) {
        // told by its status
    }
    return "unreadable";
}

bool RunFolder::is_ours() const {
    if (fs::exists(marker())) {
        return true;
    }
    if (!fs::is_regular_file(ticket())) {
        return false;
    }
    const auto content = nlohmann::json::parse(io::read_file(ticket(), ticket_limit), nullptr, false);
    return content.is_object() && content.contains("case_hash") && content.contains("riprap");
}

bool claim(const RunFolder& folder, Existing existing) {
    std::error_code error;
    if (fs::exists(folder.root, error) && !fs::is_directory(folder.root, error)) {
        throw FileError("'" + folder.root.string() + "' is a file; choose another folder with --out");
    }
    io::make_folder(folder.root);
    switch (existing) {
        case Existing::resume:
            if (folder.has_run() && folder.is_ours()) {
                return true;
            }
            refuse_other_files(folder);
            break;
        case Existing::refuse:
            refuse_run_there(folder);
            refuse_other_files(folder);
            break;
        case Existing::replace:
            refuse_names_in_the_way(folder);
            break;
    }
    return false;
}

void make_room(const RunFolder& folder) {
    const bool has_leftovers = folder.is_ours();
    io::write_file(folder.marker(), "a run is being put here\n");
    if (!has_leftovers) {
        return;
    }
    for (const std::string_view name : own_names()) {  // the ticket goes first: from then on there is no run here
        std::error_code error;
        fs::remove_all(folder.root / name, error);
        if (error) {
            throw io::file_error("remove", folder.root / name, error.value());
        }
    }
}

void end_marking(const RunFolder& folder) {
    std::error_code error;
    fs::remove(folder.marker(), error);
    if (error) {
        throw io::file_error("remove", folder.marker(), error.value());
    }
}

void make_output_folders(const RunFolder& folder) {
    io::make_folder(folder.frames());
    io::make_folder(folder.checkpoint_latest().parent_path());
}

void store_case(const RunFolder& folder, const scene::LoadedCase& loaded, const std::vector<std::string>& overrides) {
    io::make_folder(folder.case_folder());
    make_output_folders(folder);
    for (const scene::InputFile& input : loaded.inputs) {
        const fs::path copy = folder.case_folder() / input.path;
        io::make_folder(copy.parent_path());
        io::write_file(copy, io::read_file(fs::path(loaded.folder) / input.path, scene::limits::surface_bytes));
    }
    io::write_file(folder.case_file(), loaded.source_text);
    io::write_file(folder.resolved_case(), loaded.resolved_toml);
    const nlohmann::ordered_json ticket{{"case", "case/case.toml"},
                                        {"set", overrides},
                                        {"case_hash", fmt::format("{:016x}", loaded.model.case_hash)},
                                        {"riprap", build_info().version}};
    io::write_file(folder.ticket(), ticket.dump(2) + '\n');
    end_marking(folder);
}

scene::LoadedCase load_stored_case(const RunFolder& folder) {
    if (!folder.has_run()) {
        const std::string within = runs_within(folder.root);
        throw FileError(fmt::format(
            "'{}' holds no run: there is no run.json; {}", folder.root.string(),
            within.empty() ? fmt::format("start one with `riprap run CASE --out {}`", folder.root.string()) : within));
    }
    std::vector<std::string> overrides;
    try {
        const auto ticket = nlohmann::json::parse(io::read_file(folder.ticket(), ticket_limit));
        overrides = ticket.at("set").get<std::vector<std::string>>();
    } catch (const nlohmann::json::exception& error) {
        throw FileError("'" + folder.ticket().string() + "' is damaged: " + error.what() +
                        "; put the file back, or copy 'resolved.toml', which has all values, into '" +
                        folder.case_file().parent_path().string() + "' and run it there with another --out");
    }
    return scene::read_case(folder.case_file().string(), overrides);
}

}  // namespace riprap::run
