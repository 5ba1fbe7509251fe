// SPDX-License-Identifier: Apache-2.0
// Writes docs/reference/messages.md.
#include <fmt/format.h>

#include "riprap/run/remedy/end_causes.hpp"

namespace riprap::run {

std::string messages_page() {
    std::string page =
        "# Why a run ends, and what helps\n\n"
        "A run that ends with code 4 says which step was refused, why, and what helps. What it names follows from the "
        "cause, with values: `key = value` can be given as\n"
        "`--set key=value`. Each row is tried by a test: a small case that ends with the message, and the same case "
        "with its remedy, which runs to its end.\n\n"
        "This page is made from `src/riprap/run/remedy/end_causes.cpp`; `riprap check` warns of several of these "
        "causes "
        "before a run ([errors](errors.md) lists the codes).\n\n"
        "| the message says | cause | what it names |\n|---|---|---|\n";
    for (const EndCause& cause : end_causes()) {
        page += fmt::format("| ... {} ... | {} | {} |\n", cause.says, cause.means, cause.remedy);
    }
    return page;
}

}  // namespace riprap::run
