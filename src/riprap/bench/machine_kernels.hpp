// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace riprap::bench {

/// a[i] = b[i] + factor * c[i] for i in [begin, end).
void triad(double* a, const double* b, const double* c, double factor, std::int64_t begin, std::int64_t end);

/// Fused multiply-adds in the widest vectors, in enough independent chains to hide their latency.
/// @param sink  receives a value that depends on all of them
/// @returns the number of floating-point operations, two per lane and multiply-add
double run_fma_double(std::int64_t rounds, double& sink);
double run_fma_single(std::int64_t rounds, double& sink);

}  // namespace riprap::bench
