// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace riprap::run {

/// Build of the program.
struct BuildInfo {
    std::string version;     ///< "0.3.0"
    std::string commit;      ///< of the sources, "+" behind it where they were changed; empty = not known
    std::string compiler;    ///< "GNU 12.2.0"
    std::string build_type;  ///< "Release"
    std::string march;       ///< value of -march
    std::string parallel;    ///< what loops run on: "threads"
    bool has_assertions;
};
BuildInfo build_info();

/// Machine and system that the program runs on.
struct MachineInfo {
    std::string processor;  ///< model name of the system
    int hardware_threads;   ///< that this process may use
    std::string system;     ///< kernel and release
    std::string device;     ///< that water with runs_on = "device" is computed on, or "none"
};
MachineInfo machine_info();

/// Both as JSON objects, as printed by `riprap version --json` and kept in summary.json.
std::string build_json();
std::string machine_json();

}  // namespace riprap::run
