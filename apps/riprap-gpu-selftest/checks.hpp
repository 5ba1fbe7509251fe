// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace selftest {

/// Prints one line and returns whether host and device agree in every bit.
template <class T>
bool same_bits(const char* what, const std::vector<T>& host, const std::vector<T>& device) {
    std::size_t differing = host.size() == device.size() ? 0 : host.size() + device.size();
    for (std::size_t i = 0; i < host.size() && host.size() == device.size(); ++i) {
        differing += std::memcmp(&host[i], &device[i], sizeof(T)) != 0 ? 1 : 0;
    }
    std::printf("%-58s %s", what, differing == 0 ? "same bits\n" : "DIFFERS");
    if (differing > 0) {
        std::printf(" in %zu of %zu entries\n", differing, host.size());
    }
    return differing == 0;
}

/// for_each, reduce, exclusive_scan and sort_by_key against the host's.
bool check_parallel();

/// The plain distance-potential kernel on many pairs of blocks against the host's.
bool check_contact();

/// Sums over neighbours of particles against the host's.
bool check_sweep();

/// Whole steps of water against the host's.
bool check_steps();

/// Prints how long the device needs, for water and for contacts.
void time_kernels();
void time_contacts();

}  // namespace selftest
