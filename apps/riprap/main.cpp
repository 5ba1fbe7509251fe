// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>

#include "command_line.hpp"
#include "riprap/core/device_error.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/signals.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/page_content.hpp"

namespace {

/// Returns the name that begins every refusal.
std::string program_name() { return riprap::tinted("riprap:", riprap::Tint::bad, riprap::shows_colours(stderr)); }

/// Arrays of a MiB and more go back to the system when they are freed. Left alone, the allocator comes to keep free
/// ones of up to 32 MiB: a twenty-fifth of what a run of a million particles takes.
void return_freed_arrays() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

/// Tells why the program ends, on a standard error that nobody may read any more: fmt::print would throw then.
int fail(riprap::ExitCode code, const char* message) {
    std::fputs(fmt::format("{} {}\n", program_name(), riprap::printable(message)).c_str(), stderr);
    return static_cast<int>(code);
}

int report_case_error(const riprap::CaseError& error) {
    for (const riprap::Diagnostic& problem : error.problems()) {
        fmt::print(stderr, "{}\n", to_string(problem));
    }
    const std::size_t count = error.problems().size();
    fmt::print(stderr, "{} {} problem{} with the case, nothing was run\n", program_name(), count,
               count == 1 ? "" : "s");
    if (const auto* partly = dynamic_cast<const riprap::scene::PartlySeenCaseError*>(&error)) {
        fmt::print(stderr, "{} not looked at: {}; more may be found once {} mended\n", program_name(), partly->unseen(),
                   count == 1 ? "this is" : "these are");
    }
    return static_cast<int>(riprap::ExitCode::bad_case);
}

/// Runs the command line; tells every refusal on standard error.
int guarded_command_line(int argument_count, char** arguments) {
    using riprap::ExitCode;
    try {
        return riprap::command_line(argument_count, arguments);
    } catch (const riprap::CaseError& error) {
        return report_case_error(error);
    } catch (const riprap::view::Stopped& stopped) {
        return static_cast<int>(ExitCode::signal_base) + stopped.signal();
    } catch (const riprap::view::BadRequest& error) {
        return fail(ExitCode::usage, error.what());
    } catch (const riprap::CheckpointError& error) {
        return fail(ExitCode::bad_checkpoint, error.what());
    } catch (const riprap::FileError& error) {
        return fail(ExitCode::file_system, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(ExitCode::file_system,
                    riprap::io::file_error("look at", error.path1(), error.code().value()).what());
    } catch (const riprap::DeviceError& error) {
        return fail(ExitCode::bad_case, error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::bad_case, "out of memory; `riprap check` says what a case needs");
    } catch (const std::exception& error) {
        if (std::ferror(stdout) != 0 || std::ferror(stderr) != 0) {
            return static_cast<int>(ExitCode::file_system);  // main tells it
        }
        return fail(ExitCode::internal, fmt::format("internal error, please report it: {}", error.what()).c_str());
    }
}

/// The exit code once everything printed has arrived. An answer that was lost on the way - a full disk, a reader that
/// went away - is no success.
int after_flush(int code) {
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) {
        return code;
    }
    const int lost = fail(riprap::ExitCode::file_system, "cannot write to standard output: what was printed is lost");
    return code == 0 ? lost : code;
}

}  // namespace

int main(int argument_count, char** arguments) {
    riprap::run::ignore_write_signals();
    return_freed_arrays();
    return after_flush(guarded_command_line(argument_count, arguments));
}
