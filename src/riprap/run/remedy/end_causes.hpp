// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "riprap/run/remedy/refused.hpp"

namespace riprap::run {

/// A cause for which a run ends, and what is advised. A message that no row knows names no remedy.
struct EndCause {
    std::string_view name;    ///< a word for the page and the tests
    std::string_view says;    ///< part of the message, by which the cause is known
    std::string_view means;   ///< for the page
    std::string_view remedy;  ///< for the page
    /// Returns the remedy with its values, "key = value" as `--set key=value` takes it; empty where none is known.
    std::string (*advise)(const Refused& refused);
};

/// All causes, in the order of docs/reference/messages.md, which is made from them.
std::span<const EndCause> end_causes();

/// Returns the cause that a message tells; nullptr for a message that names no remedy.
const EndCause* cause_of(std::string_view message);

/// Returns the reason with the remedy that follows from its cause: the method's own where the cause adds none.
sim::StepStatus with_advice(const Refused& refused);

/// docs/reference/messages.md
std::string messages_page();

}  // namespace riprap::run
