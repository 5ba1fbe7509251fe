// SPDX-License-Identifier: Apache-2.0
#pragma once

// Studies: one case run many times, with other values of some keys each time.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace riprap::run {

/// One run of a study.
struct SweepPoint {
    std::string name;                    ///< of its folder: "run_003"
    std::vector<std::string> overrides;  ///< "key=value" each, in the order of the keys
};

/// "key=a,b,c" as the key and its values. Commas within brackets or quotes do not part values: "g=[0,-9],[0,-4]".
/// @throws CaseError when there is no key or no value
struct Variation {
    std::string key;
    std::vector<std::string> values;
};
Variation read_variation(const std::string& text);

/// Every combination of the values, the last key running fastest. @throws CaseError for a key that is varied twice
std::vector<SweepPoint> grid_of(const std::vector<Variation>& variations);

/// One run per line of a table: keys in the first line, values below, parted by commas as in a variation, or by what
/// the first line has instead: semicolons or tabs. Lines end in LF, CRLF or CR; a byte order mark is passed over.
/// @throws CaseError with the place, also for a key that stands twice and a value that is missing
std::vector<SweepPoint> list_of(const std::string& text, const std::string& file);

struct SweepOptions {
    std::string case_path;  ///< the case file
    std::vector<SweepPoint> points;
    std::vector<std::string> overrides{};  ///< of all runs
    std::filesystem::path out;             ///< one folder per run in it, and sweep.csv, sweep.json, index.html
    int jobs{0};                           ///< runs at a time; 0 = as many as there are cores for their threads
    int threads{1};                        ///< of each run
    bool quiet{false};
};

/// @throws CaseError where a key is set in all runs and varied, too: one of both would go unread
void refuse_set_and_varied(const SweepOptions& options);

/// Runs what is not finished yet, each by a process of its own, several at a time, and writes the tables. A study that
/// was stopped goes on where it was, by the same call: finished runs stay, others continue from their checkpoints. A
/// run that fails does not stop the others; where the case of none can be read, nothing is written.
/// @returns the exit code: that of the first run that did not succeed, or 128 + a signal
/// @throws FileError when the folder holds another study; CaseError of the first run where no case can be read
int run_sweep(const SweepOptions& options);

/// Runs one point of a study, by its number from 1, as run_sweep does, and writes no table: several processes on
/// several machines may do so at a time. @throws FileError where there is no such run
int run_point(SweepOptions options, std::size_t number);

/// Gathers the answers of all runs from their folders.
/// @returns the text of sweep.json: {"case", "keys", "runs": [{"name", "set", "status", "wall_seconds", "answers",
/// "columns"}]}, of each probe column its last, least and largest value
std::string sweep_json(const SweepOptions& options);
/// Tells whether an expected answer was missed in any run of a sweep.json.
bool any_answer_is_missed(const std::string& json);
/// Names the runs of a sweep.json whose files cannot be read, each with the reason.
std::vector<std::string> unreadable_runs(const std::string& json);
/// Returns sweep.json as a table, a row per run.
std::string sweep_csv(const std::string& json);

}  // namespace riprap::run
