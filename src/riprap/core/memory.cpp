// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace riprap {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// The first number in a file, which may also hold a word such as "max".
double number_in(const char* path) {
    std::ifstream file(path);
    double number = 0;
    return file >> number ? number : unknown;
}

double available_to_all() {
    std::ifstream file("/proc/meminfo");
    std::string word;
    double kilobytes = 0;
    while (file >> word) {
        if (word == "MemAvailable:" && file >> kilobytes) {
            return 1024 * kilobytes;
        }
    }
    return unknown;
}

double left_by_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) {
        return unknown;
    }
    const double pages = number_in("/proc/self/statm");
    const double used = std::isfinite(pages) ? pages * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0;
    return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

/// Of the group that this process sees as the root, as in a container.
double left_by_group() {
    const double most = number_in("/sys/fs/cgroup/memory.max"), used = number_in("/sys/fs/cgroup/memory.current");
    return std::isfinite(most) && std::isfinite(used) ? std::max(0.0, most - used) : unknown;
}

}  // namespace

double available_memory() { return std::min({available_to_all(), left_by_limit(), left_by_group()}); }

}  // namespace riprap
