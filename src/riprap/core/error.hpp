// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace riprap {

/// Exit codes of the command line; documented in docs/howto/command-line.md and kept stable.
enum class ExitCode : int {
    success = 0,
    failed = 1,          ///< an [[expect]] or a validation verdict failed
    usage = 2,           ///< bad command line
    bad_case = 3,        ///< the case file or an input file is wrong
    numerical = 4,       ///< the state became non-finite or absurd
    file_system = 5,     ///< cannot read or write
    bad_checkpoint = 6,  ///< truncated, corrupt or foreign checkpoint
    internal = 70,       ///< a bug in Riprap
    signal_base = 128,   ///< 128 + signal number after a checkpoint
};

/// A place in an input text; line and column count from 1, 0 = unknown.
struct SourcePlace {
    std::string file;
    std::uint32_t line{0};
    std::uint32_t column{0};
};

/// One problem with an input: where, what was read, what is allowed.
struct Diagnostic {
    SourcePlace place;
    std::string message;  ///< what was read and why it is refused
    std::string allowed;  ///< what is allowed, or the remedy; may be empty
};

/// `file:line:column: message; allowed`
std::string to_string(const Diagnostic& diagnostic);

/// The user's input is wrong. Carries every problem found, not only the first.
class CaseError : public std::runtime_error {
 public:
    explicit CaseError(std::vector<Diagnostic> problems);
    explicit CaseError(Diagnostic problem) : CaseError(std::vector<Diagnostic>{std::move(problem)}) {}
    const std::vector<Diagnostic>& problems() const { return problems_; }

 private:
    std::vector<Diagnostic> problems_;
};

/// A file could not be read or written; the message names the file, the cause and the remedy.
class FileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A checkpoint is truncated, corrupt or belongs to another case.
class CheckpointError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A broken promise between functions of Riprap; see RIPRAP_ASSERT.
class InternalError : public std::logic_error {
    using std::logic_error::logic_error;
};

[[noreturn]] void assertion_failed(const char* expression, const char* file, int line, const std::string& values);

}  // namespace riprap

/// Checks a promise of the programmer in debug and CI builds: RIPRAP_ASSERT(r > 0, fmt::format("r = {}", r)).
#if defined(RIPRAP_ASSERTIONS)
#define RIPRAP_ASSERT(expression, values) \
    ((expression) ? void(0) : ::riprap::assertion_failed(#expression, __FILE__, __LINE__, (values)))
#else
#define RIPRAP_ASSERT(expression, values) void(0)
#endif
