// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/archive/archive_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "riprap/core/child_process.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/again/file_hash.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/folder/runs_within.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/read_run.hpp"

namespace riprap::view {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t most_bytes = std::size_t{4} << 30U;  ///< of one file

/// A hidden folder beside the archive that goes with this object.
class Staging {
 public:
    explicit Staging(const fs::path& archive)
        : path_(archive.parent_path() / fmt::format(".{}.{}", archive.filename().string(), ::getpid())) {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;
    ~Staging() {
        std::error_code error;
        fs::remove_all(path_, error);
    }
    const fs::path& path() const { return path_; }

 private:
    fs::path path_;
};

/// Files of the run in its folder, as paths within it; links are none of a run.
std::vector<fs::path> files_of(const ArchiveOptions& options) {
    std::vector<std::string> parts{"case",       "resolved.toml", "run.json", "summary.json", "probes.csv",
                                   "ledger.csv", "bodies.csv",    "run.log",  "run.jsonl",    "plot.svg"};
    if (options.has_frames) {
        parts.insert(parts.end(), {"frames", "out.pvd", "contacts.pvd"});
    }
    if (options.has_checkpoint) {
        parts.emplace_back("checkpoint");
    }
    std::vector<fs::path> files;
    for (const std::string& part : parts) {
        const fs::path place = options.folder / part;
        if (fs::is_regular_file(fs::symlink_status(place))) {
            files.emplace_back(part);
        } else if (fs::is_directory(fs::symlink_status(place))) {
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place)) {
                if (fs::is_regular_file(entry.symlink_status())) {
                    files.push_back(entry.path().lexically_relative(options.folder));
                }
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Says what of a file is in the archive.
Json entry_of(const fs::path& name, const std::string& bytes) {
    return {{"name", name.generic_string()}, {"bytes", bytes.size()}, {"xxh3", run::file_hash(bytes)}};
}

/// Copies a file with its time.
Json copied(const fs::path& from, const fs::path& to, const fs::path& name) {
    const std::string bytes = io::read_file(from, most_bytes);
    io::make_folder(to.parent_path());
    io::write_file(to, bytes, io::Durability::later);
    fs::last_write_time(to, fs::last_write_time(from));
    return entry_of(name, bytes);
}

/// The page of the run as it is now; a notice where it cannot be made.
void add_page(const ArchiveOptions& options, const fs::path& stage, Json& files, Archived& packed) {
    try {
        const std::string page = page_of(pack_run(read_run(options.folder), default_budget));
        io::write_file(stage / "index.html", page, io::Durability::later);
        files.push_back(entry_of("index.html", page));
    } catch (const FileError& error) {
        packed.notices.push_back(fmt::format("without a page: {}", error.what()));
    }
}

/// version, hash and end of the run, and the list of files.
std::string list_of(const ArchiveOptions& options, const std::string& status, const Json& files) {
    constexpr std::size_t most_summary = std::size_t{16} << 20U;
    Json hash = nullptr, build = nullptr;
    const fs::path summary = options.folder / "summary.json";
    if (fs::exists(summary)) {
        const Json read = Json::parse(io::read_file(summary, most_summary), nullptr, false);
        if (read.is_object()) {
            hash = read.value("state_hash", Json(nullptr));
            build = read.value("build", Json(nullptr));
        }
    }
    const Json list{{"format", 1},
                    {"packed_by", fmt::format("riprap {}", run::build_info().version)},
                    {"status", status},
                    {"state_hash", hash},
                    {"run_by", build},
                    {"run_again",
                     "riprap run . --out ../again   (in this folder; the same build and kind of processor "
                     "give the same state_hash)"},
                    {"files", files}};
    return list.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Runs tar. @throws FileError where it fails
void tar(std::vector<std::string> words) {
    words.insert(words.begin(), "tar");
    const std::optional<int> code = run_to_end(words, ChildOutput::error);
    if (!code) {
        throw FileError("there is no tar on this machine, which makes the archive");
    }
    if (*code != 0) {
        throw FileError(fmt::format("tar ended with exit code {}; nothing was packed", *code));
    }
}

/// Writes a file through to the disk.
void flush(const fs::path& file) {
    const int number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_flushed = number >= 0 && ::fsync(number) == 0;
    if (number >= 0) {
        ::close(number);
    }
    if (!is_flushed) {
        throw FileError(fmt::format("cannot write '{}' to the disk", file.string()));
    }
}

/// Where the archive goes. @throws BadRequest
fs::path archive_of(const ArchiveOptions& options) {
    const fs::path folder = fs::weakly_canonical(options.folder);
    const fs::path out = options.out.empty() ? folder.parent_path() / (folder.filename().string() + ".tar.gz")
                                             : fs::absolute(options.out).lexically_normal();
    const fs::path inside = fs::weakly_canonical(out).lexically_relative(folder);
    if (!inside.empty() && *inside.begin() != "..") {
        throw BadRequest(fmt::format("the archive would lie in the run folder '{}' itself", options.folder.string()));
    }
    if (fs::exists(fs::symlink_status(out)) && !options.force) {
        throw BadRequest(fmt::format("'{}' is there already; --force replaces it", out.string()));
    }
    return out;
}

}  // namespace

Archived archive_run(const ArchiveOptions& options) {
    const run::RunFolder folder{options.folder};
    if (!folder.has_run() || !folder.is_ours()) {
        const std::string within = run::runs_within(options.folder);
        throw FileError(
            fmt::format("'{}' holds no run{}{}", options.folder.string(), within.empty() ? "" : "; ", within));
    }
    if (run::is_held(folder)) {
        throw FileError(fmt::format("a run goes on in '{}': pack it once it has ended", options.folder.string()));
    }
    Archived packed{archive_of(options), 0, 0, {}};
    const std::string status = run::status_of(folder);
    if (status != "finished") {
        packed.notices.push_back(fmt::format("the run is not finished: {}", status));
    }
    const Staging staging(packed.archive);
    const std::string name = fs::weakly_canonical(options.folder).filename().string();
    const fs::path stage = staging.path() / name, hidden = staging.path() / ".archive";
    fs::create_directories(stage);
    Json files = Json::array();
    for (const fs::path& file : files_of(options)) {
        files.push_back(copied(options.folder / file, stage / file, file));
    }
    add_page(options, stage, files, packed);
    io::write_file(stage / "pack.json", list_of(options, status, files), io::Durability::later);
    packed.files = files.size() + 1;
    const std::string root = staging.path().string();
    tar({"--create", "--gzip", "--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--file=" + hidden.string(),
         "--directory=" + root, "--", "./" + name});
    tar({"--compare", "--gzip", "--file=" + hidden.string(), "--directory=" + root});
    flush(hidden);
    fs::rename(hidden, packed.archive);
    packed.bytes = fs::file_size(packed.archive);
    return packed;
}

}  // namespace riprap::view
