// SPDX-License-Identifier: Apache-2.0
// `riprap bench`: the program of `riprap` with the benches in it.
#include "built_in.hpp"
#include "riprap/bench/bench.hpp"

int main(int argument_count, char** arguments) {
    return riprap::run_program({argument_count, arguments}, {.bench = riprap::bench::bench_main});
}
