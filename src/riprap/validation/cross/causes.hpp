// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "riprap/validation/cross/cell.hpp"

namespace riprap::validation::cross {

/// Cells that are known to be wrong, each with its cause: entries [[red]] of a file with `scenes`, `cause` and, where
/// they are not about all cells of these, `solids`, `fluids`, `variations` ("as it is": none) and `energy` (true: about
/// what the ledger misses). Every cell that an entry names has to be wrong.
class Causes {
 public:
    /// No cell is known to be wrong where there is no such file. @throws CaseError
    explicit Causes(const std::filesystem::path& file);

    /// Notes the cause of a wrong cell, and a cell that is right but listed as wrong: who mends one takes it off the
    /// list.
    void note(Cell& cell) const;

 private:
    struct Red {
        std::vector<std::string> scenes, solids, fluids, variations;  ///< of which a cell is one; any when empty
        std::string cause;
        bool is_energy{false};
    };
    static bool is_about(const Red& red, const Cell& cell);

    std::vector<Red> reds_;
};

}  // namespace riprap::validation::cross
