// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/error.hpp"

#include "riprap/core/printable.hpp"

namespace riprap {

namespace {
std::string join(const std::vector<Diagnostic>& problems) {
    std::string text;
    for (const Diagnostic& problem : problems) {
        if (!text.empty()) {
            text += '\n';
        }
        text += to_string(problem);
    }
    return text;
}
}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
    std::string text = diagnostic.place.file;
    if (diagnostic.place.line > 0) {
        text += ':' + std::to_string(diagnostic.place.line) + ':' + std::to_string(diagnostic.place.column);
    }
    if (!text.empty()) {
        text += ": ";
    }
    text += diagnostic.message;
    if (!diagnostic.allowed.empty()) {
        text += (text.ends_with('?') ? " " : "; ") + diagnostic.allowed;
    }
    return printable(text);
}

CaseError::CaseError(std::vector<Diagnostic> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

void assertion_failed(const char* expression, const char* file, int line, const std::string& values) {
    throw InternalError(std::string(file) + ':' + std::to_string(line) + ": assertion failed: " + expression + " (" +
                        values + ')');
}

}  // namespace riprap
