// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/tint.hpp"

#include <unistd.h>

#include <cstdlib>

namespace riprap {

bool shows_colours(std::FILE* out) {
    const char* const forbidden = std::getenv("NO_COLOR");
    const char* const terminal = std::getenv("TERM");
    const bool is_forbidden = forbidden != nullptr && *forbidden != '\0';
    return !is_forbidden && terminal != nullptr && std::string_view(terminal) != "dumb" && isatty(fileno(out)) != 0;
}

std::string tinted(std::string_view text, Tint tint, bool is_coloured) {
    if (!is_coloured) {
        return std::string(text);
    }
    const char* const code = tint == Tint::good ? "32" : tint == Tint::bad ? "31" : "33";
    return std::string("\033[") + code + 'm' + std::string(text) + "\033[0m";
}

}  // namespace riprap
