// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/build/paddle_wave.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::io {
struct OutputChoices;
}

namespace riprap::scene {

/// A case with problems of which not everything could be looked at for these problems.
class PartlySeenCaseError : public CaseError {
 public:
    /// @param unseen  what was not looked at, in words
    PartlySeenCaseError(std::vector<Diagnostic> problems, std::string unseen)
        : CaseError(std::move(problems)), unseen_(std::move(unseen)) {}
    const std::string& unseen() const { return unseen_; }

 private:
    std::string unseen_;
};

/// A file that the case reads besides itself (a surface, a table), with the path as the case writes it.
struct InputFile {
    std::string path;       ///< relative to the folder of the case, no "..", no links out of it
    std::uint64_t hash{0};  ///< of the bytes
};

/// A case ready to run.
struct LoadedCase {
    sim::Model model;
    sim::State state;                            ///< at t = 0; sim::initialise has not been called
    std::string folder;                          ///< of the case file; relative paths start here
    std::string source_text;                     ///< the case file as read
    std::string resolved_toml;                   ///< every key with its value in SI, defaults and overrides included
    std::string resolved_json;                   ///< the same as JSON
    std::vector<InputFile> inputs;               ///< other files read, sorted by path
    std::vector<std::string> warnings;           ///< worth knowing, no reason to stop
    std::vector<std::string> notes;              ///< what was read from other programs' files
    std::vector<std::string> overrides;          ///< as they were given
    std::vector<PaddleWave> waves;               ///< that paddles are to make
    std::shared_ptr<io::OutputChoices> outputs;  ///< files of a run
};

/// Reads a case file (docs/reference/case-file.md) into Model and State.
///
/// Strict: an unknown key, a wrong type, unit or range, an option that is not implemented, a missing or broken file,
/// a path that leaves the folder of the case or a request above limits.hpp is a problem with file:line:column; all
/// problems found are reported together. Nothing is allocated for counts that are refused.
///
/// @param overrides  "path.to.key=value" each, the value as TOML; entries of lists by name or number:
///                   "body.block.position=[0,0,1]". A value that is not TOML is taken as a text ("time_step=1 ms").
/// @throws PartlySeenCaseError  with every problem that can be seen; @throws FileError when the case file itself cannot
/// be read.
LoadedCase read_case(const std::string& path, std::span<const std::string> overrides = {});

/// Reads a case from a text. `name` is used in messages; relative paths start at `folder`.
LoadedCase read_case_text(std::string_view text, const std::string& name, const std::string& folder,
                          std::span<const std::string> overrides = {});

}  // namespace riprap::scene
