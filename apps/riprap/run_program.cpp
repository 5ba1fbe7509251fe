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

#include "built_in.hpp"
#include "command_line.hpp"
#include "riprap/core/device_error.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/signals.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/stopped.hpp"

namespace riprap {

namespace {

/// Returns the name that begins every refusal.
std::string program_name() { return tinted("riprap:", Tint::bad, shows_colours(stderr)); }

/// Arrays of a MiB and more go back to the system when they are freed. Left alone, the allocator comes to keep free
/// ones of up to 32 MiB: a twenty-fifth of what a run of a million particles takes.
void return_freed_arrays() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

/// Tells why the program ends, on a standard error that nobody may read any more: fmt::print would throw then.
int fail(ExitCode code, const char* message) {
    std::fputs(fmt::format("{} {}\n", program_name(), printable(message)).c_str(), stderr);
    return static_cast<int>(code);
}

int report_case_error(const CaseError& error) {
    for (const Diagnostic& problem : error.problems()) {
        fmt::print(stderr, "{}\n", to_string(problem));
    }
    const std::size_t count = error.problems().size();
    fmt::print(stderr, "{} {} problem{} with the case, nothing was run\n", program_name(), count,
               count == 1 ? "" : "s");
    if (const auto* partly = dynamic_cast<const scene::PartlySeenCaseError*>(&error)) {
        fmt::print(stderr, "{} not looked at: {}; more may be found once {} mended\n", program_name(), partly->unseen(),
                   count == 1 ? "this is" : "these are");
    }
    return static_cast<int>(ExitCode::bad_case);
}

/// Runs the command line; tells every refusal on standard error.
int guarded_command_line(const Words& words, const BuiltIn& built_in) {
    try {
        return command_line(words, built_in);
    } catch (const CaseError& error) {
        return report_case_error(error);
    } catch (const view::Stopped& stopped) {
        return static_cast<int>(ExitCode::signal_base) + stopped.signal();
    } catch (const view::BadRequest& error) {
        return fail(ExitCode::usage, error.what());
    } catch (const CheckpointError& error) {
        return fail(ExitCode::bad_checkpoint, error.what());
    } catch (const FileError& error) {
        return fail(ExitCode::file_system, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return fail(ExitCode::file_system, io::file_error("look at", error.path1(), error.code().value()).what());
    } catch (const DeviceError& error) {
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
    const int lost = fail(ExitCode::file_system, "cannot write to standard output: what was printed is lost");
    return code == 0 ? lost : code;
}

}  // namespace

int run_program(const Words& words, const BuiltIn& built_in) {
    run::ignore_write_signals();
    return_freed_arrays();
    return after_flush(guarded_command_line(words, built_in));
}

}  // namespace riprap
