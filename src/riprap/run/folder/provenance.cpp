// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/folder/provenance.hpp"

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "commit.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"

namespace riprap::run {

namespace {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

}  // namespace

BuildInfo build_info() {
#if defined(RIPRAP_ASSERTIONS)
    const bool has_assertions = true;
#else
    const bool has_assertions = false;
#endif
    return {.version = RIPRAP_VERSION,
            .commit = RIPRAP_COMMIT,
            .compiler = RIPRAP_COMPILER,
            .build_type = RIPRAP_BUILD_TYPE,
            .march = RIPRAP_MARCH,
            .parallel = parallel::backend_name(),
            .has_assertions = has_assertions};
}

MachineInfo machine_info() {
    utsname system{};
    uname(&system);
    return {.processor = processor_name(),
            .hardware_threads = static_cast<int>(std::thread::hardware_concurrency()),
            .system = std::string(system.sysname) + ' ' + system.release,
            .device = fluid::device_name()};
}

std::string build_json() {
    const BuildInfo info = build_info();
    return nlohmann::ordered_json{
        {"version", info.version},          {"commit", info.commit}, {"compiler", info.compiler},
        {"build_type", info.build_type},    {"march", info.march},   {"parallel", info.parallel},
        {"assertions", info.has_assertions}}
        .dump();
}

std::string machine_json() {
    const MachineInfo info = machine_info();
    return nlohmann::ordered_json{{"processor", info.processor},
                                  {"hardware_threads", info.hardware_threads},
                                  {"system", info.system},
                                  {"device", info.device}}
        .dump();
}

}  // namespace riprap::run
