// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/loaded_case.hpp"

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
