// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/validation/result.hpp"

namespace riprap::validation::cross {

inline constexpr std::string_view suite = "cross";

/// A run of a scene, as the table of all methods shows it.
struct Cell {
    std::string scene;
    std::string solid, fluid;  ///< words of the case; fluid "none" where there is no water
    std::string variation;     ///< what differs from the case; empty: nothing
    bool is_energy{false};     ///< about what the ledger misses, not about the answers
    std::string finding;       ///< "right", "wrong" or "refused"
    std::string quantity, unit;
    double value{0};  ///< NaN where there is none
    double low{0}, high{0};
    std::string why;       ///< missing physics, how the run ended, or what was missed
    std::string cause{};   ///< of a wrong cell, where it was found
    bool is_stale{false};  ///< right, and listed as wrong
    double seconds{0};     ///< processor time of the run [s]
};

/// The cell as a line of the results: a wrong one with a known cause is "close", as it is not news.
Result result_of(const Cell& cell);

}  // namespace riprap::validation::cross
