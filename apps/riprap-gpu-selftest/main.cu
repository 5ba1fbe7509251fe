// SPDX-License-Identifier: Apache-2.0
//
// riprap-gpu-selftest [--time]: does the CUDA back end give the host's answers on this machine, bit for bit? And how
// long does it take?
// Exit codes: 0 all equal, 1 something differs or failed, 77 there is no device to test.

#include <exception>
#include <string_view>

#include "checks.hpp"
#include "riprap/core/parallel_device.hpp"

int main(int count, char** words) {
    if (riprap::parallel::device::device_count() == 0) {
        std::printf("riprap-gpu-selftest: no CUDA device on this machine; nothing was tested\n");
        return 77;
    }
    try {
        std::printf("device: %s\n", riprap::parallel::device::device_name().c_str());
        bool ok = selftest::check_parallel();
        ok &= selftest::check_contact();
        ok &= selftest::check_sweep();
        ok &= selftest::check_steps();
        if (count > 1 && std::string_view(words[1]) == "--time") {
            selftest::time_kernels();
        }
        std::printf(ok ? "all equal\n" : "the device differs from the host\n");
        return ok ? 0 : 1;
    } catch (const std::exception& error) {
        std::printf("riprap-gpu-selftest: %s\n", error.what());
        return 1;
    }
}
