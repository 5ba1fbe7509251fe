// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/run_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <thread>

#include "riprap/core/parallel.hpp"
#include "riprap/run/drive/driver.hpp"

namespace riprap::run {

namespace {

/// --force would remove the case before it is copied.
void refuse_case_inside(const RunFolder& folder, const std::string& case_folder) {
    namespace fs = std::filesystem;
    const fs::path inside = fs::weakly_canonical(case_folder.empty() ? "." : case_folder);
    const fs::path root = fs::weakly_canonical(folder.root);
    const fs::path relative = inside.lexically_relative(root);
    if (!relative.empty() && *relative.begin() != "..") {
        throw FileError("the case lies in the run folder '" + folder.root.string() +
                        "' itself; choose another folder with --out, or continue with `riprap resume`");
    }
}

/// A trial run, which the same run without the limit goes on with: `run --max-steps N`, then `run`.
bool was_stopped_by_max_steps(const RunFolder& folder) {
    constexpr std::size_t most = std::size_t{16} << 20U;
    if (!folder.has_run() || !folder.is_ours() || !std::filesystem::exists(folder.summary())) {
        return false;
    }
    const auto summary = nlohmann::json::parse(io::read_file(folder.summary(), most), nullptr, false);
    return summary.is_object() && summary.contains("reason") && summary["reason"] == "stopped by max_steps";
}

/// The first number of OMP_NUM_THREADS, which queues of clusters set; 0 where it holds none.
int threads_of_environment() {
    const char* text = std::getenv("OMP_NUM_THREADS");
    int count = 0;
    if (text != nullptr) {
        std::from_chars(text, text + std::strlen(text), count);
    }
    constexpr int most = 1024;  // as --threads
    return std::clamp(count, 0, most);
}

}  // namespace

void use_threads(int threads) {
    if (threads <= 0) {
        threads = threads_of_environment();
    }
    parallel::set_thread_count(threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency()));
}

int run_case(const RunOptions& options) {
    use_threads(options.threads);
    return run_loaded(scene::read_case(options.case_path, options.overrides), options);
}

int run_loaded(scene::LoadedCase loaded, const RunOptions& options) {
    use_threads(options.threads);
    const RunFolder folder{options.out};
    refuse_case_inside(folder, loaded.folder);
    const bool is_resumed = options.resume || (!options.force && was_stopped_by_max_steps(folder));
    const Existing existing = is_resumed ? Existing::resume : options.force ? Existing::replace : Existing::refuse;
    const Voice voice = options.silent ? Voice::none : options.quiet ? Voice::verdicts : Voice::all;
    Driver driver(folder, std::move(loaded), voice);  // refuses a bad case before any file is touched
    claim(folder, existing);
    const FolderLock lock(folder);
    // Looked at again now that it is ours alone: another process may have run there in between.
    const bool is_continued = claim(folder, existing) && folder.has_checkpoint();
    if (is_continued) {
        end_marking(folder);
        make_output_folders(folder);
        driver.resume_case();
    } else {
        make_room(folder);
        driver.store_case(options.overrides);
        driver.start();
    }
    return driver.run(options.watch);
}

int resume_run(const ResumeOptions& options) {
    use_threads(options.threads);
    const RunFolder folder{options.folder};
    Driver driver(folder, load_stored_case(folder), options.quiet ? Voice::verdicts : Voice::all);
    const FolderLock lock(folder);
    end_marking(folder);
    make_output_folders(folder);
    if (folder.has_checkpoint()) {
        driver.resume(options.end, options.max_steps);
    } else {
        driver.start(options.end, options.max_steps);  // stopped before its first checkpoint: nothing is lost
    }
    return driver.run();
}

}  // namespace riprap::run
