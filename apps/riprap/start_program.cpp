// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "built_in.hpp"
#include "riprap/core/child_process.hpp"
#include "riprap/core/error.hpp"

namespace riprap {

namespace {

std::filesystem::path own_folder() { return std::filesystem::read_symlink("/proc/self/exe").parent_path(); }

/// Lets CMake build one program in the folder of a build; what it prints goes to standard error.
bool build(const std::filesystem::path& folder, const std::string& name) {
    fmt::print(stderr, "riprap: building {}, some minutes the first time\n", name);
    return run_to_end({"cmake", "--build", folder.string(), "--target", name}, ChildOutput::error) == 0;
}

}  // namespace

bool has_program(const std::string& name) { return std::filesystem::exists(own_folder() / name); }

int start_program(const std::string& name, const Words& words) {
    const std::filesystem::path folder = own_folder(), program = folder / name;
    const bool is_build = std::filesystem::exists(folder.parent_path() / "CMakeCache.txt");
    if (!has_program(name) && (!is_build || !build(folder.parent_path(), name))) {
        throw FileError(fmt::format("'{}' is missing, the program of this command; {}", program.string(),
                                    is_build ? std::string("it could not be built, see above")
                                             : fmt::format("build the target {} and install again", name)));
    }
    std::fflush(stdout);
    std::signal(SIGPIPE, SIG_DFL);  // the program chooses for itself, as when it is started by hand
    execv(program.c_str(), words.words);
    throw FileError(fmt::format("cannot start '{}': {}", program.string(), std::generic_category().message(errno)));
}

}  // namespace riprap
