// SPDX-License-Identifier: Apache-2.0
// usage: write_stirred_run FOLDER PARTICLES_PER_SIDE FRAMES
// A run folder of any size to measure `riprap view` and its page with; page/test/play_rate.js does.

#include <cstdio>
#include <cstdlib>

#include "view/stirred_run.hpp"

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("usage: write_stirred_run FOLDER PARTICLES_PER_SIDE FRAMES\n", stderr);
        return 2;
    }
    riprap::view::write_stirred_run(argv[1], std::atoi(argv[2]), std::atoi(argv[3]));
}
