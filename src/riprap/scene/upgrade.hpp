// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/renamed.hpp"

namespace riprap::scene {

/// A case file with the names of today, and what was renamed in it.
struct UpgradedCase {
    std::string text;
    std::vector<OldName> renamed;  ///< in the order of the file
};

/// Writes the names of today over the old ones of a case file. Comments, layout and everything else stay to the byte.
/// @param name  of the file, for messages
/// @throws CaseError where the text is no TOML or of a newer format, and where an old name cannot be replaced: none
/// is left of it, the table has the new one already, or the old one is written with escapes
UpgradedCase upgrade_case_text(std::string_view text, const std::string& name, const Table& table = case_table(),
                               std::span<const Renamed> rows = renamed_names());

}  // namespace riprap::scene
