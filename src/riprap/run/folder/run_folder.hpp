// SPDX-License-Identifier: Apache-2.0
#pragma once

// The folder of one run: where everything lies, who may write into it, and how it is found again.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "riprap/io/atomic_file.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {

/// Names inside a run folder (docs/howto/output-files.md).
struct RunFolder {
    std::filesystem::path root;

    std::filesystem::path ticket() const { return root / "run.json"; }
    std::filesystem::path case_folder() const { return root / "case"; }
    std::filesystem::path case_file() const { return case_folder() / "case.toml"; }
    std::filesystem::path resolved_case() const { return root / "resolved.toml"; }
    std::filesystem::path checkpoint_latest() const { return root / "checkpoint" / "latest"; }
    std::filesystem::path checkpoint_previous() const { return root / "checkpoint" / "previous"; }
    std::filesystem::path checkpoint_damaged() const { return root / "checkpoint" / "damaged"; }
    std::filesystem::path frames() const { return root / "frames"; }
    std::filesystem::path log() const { return root / "run.log"; }
    std::filesystem::path events() const { return root / "run.jsonl"; }
    std::filesystem::path probes() const { return root / "probes.csv"; }
    std::filesystem::path ledger() const { return root / "ledger.csv"; }
    std::filesystem::path bodies() const { return root / "bodies.csv"; }
    std::filesystem::path summary() const { return root / "summary.json"; }
    std::filesystem::path lock() const { return root / ".lock"; }
    /// Stands while a run is being put here, from before the first file of it to after the ticket.
    std::filesystem::path marker() const { return root / ".riprap_starting"; }

    /// A run was started here: its case is complete.
    bool has_run() const { return std::filesystem::exists(ticket()); }
    /// Tells whether Riprap wrote the files that lie here under the names of a run: there is its ticket, or a run was
    /// killed while it was being put here.
    bool is_ours() const;
    bool has_checkpoint() const {
        return std::filesystem::exists(checkpoint_latest()) || std::filesystem::exists(checkpoint_previous());
    }
};

/// Holds a run folder for this process; goes with it, however it ends.
class FolderLock {
 public:
    /// @throws FileError when another process holds the folder, or one of its own folders is a link
    explicit FolderLock(const RunFolder& folder);

 private:
    io::FileDescriptor file_;
};

/// Tells whether another process holds a run folder now. Touches nothing.
bool is_held(const RunFolder& folder);

/// Status that summary.json tells: "finished", "interrupted" or "failed". "not run" where no run was started,
/// "interrupted" where one was killed before it could tell, "unreadable" where the file is damaged.
std::string status_of(const RunFolder& folder);

/// Contents that a run folder may hold already.
enum class Existing {
    refuse,   ///< nothing
    replace,  ///< a run, which is removed first, and other files, which stay
    resume,   ///< a run, which is continued
};

/// Makes the folder or takes an existing one. Without a run of ours in it every file counts as the user's, whatever its
/// name: `replace` then takes the folder only where no name is in the way.
/// @returns true when a run that was started there is to be continued
/// @throws FileError when the folder is refused, with the options that would take it
bool claim(const RunFolder& folder, Existing existing);

/// Marks the folder as one where a run begins and removes what an earlier run of ours left, by name; nothing else. The
/// mark comes first, so that after a kill at any moment the leftovers are still known as ours.
void make_room(const RunFolder& folder);

/// Takes the mark of make_room away: the ticket says the same from now on.
void end_marking(const RunFolder& folder);

/// Makes the folders of frames and checkpoints where they are missing: who needs room removes frames. @throws FileError
void make_output_folders(const RunFolder& folder);

/// Copies the case with every file it reads, the resolved case and, last, the ticket that makes it a run; then ends the
/// marking. @throws FileError
void store_case(const RunFolder& folder, const scene::LoadedCase& loaded, const std::vector<std::string>& overrides);

/// The case of a run folder as it was first read. @throws FileError, CaseError
scene::LoadedCase load_stored_case(const RunFolder& folder);

}  // namespace riprap::run
