// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/machine_kernels.hpp"

namespace riprap::bench {

namespace {

#if defined(__AVX512F__)
constexpr int vector_bytes = 64;
#elif defined(__AVX__)
constexpr int vector_bytes = 32;
#else
constexpr int vector_bytes = 16;
#endif
typedef double DoublePack __attribute__((vector_size(vector_bytes)));
typedef float SinglePack __attribute__((vector_size(vector_bytes)));

/// Chains: two units with a latency of four or five cycles need ten; they fit sixteen registers with the factors.
constexpr int chain_count = 12;

template <class Pack, class Number>
double run_fma(std::int64_t rounds, double& sink) {
    constexpr int lanes = vector_bytes / static_cast<int>(sizeof(Number));
    Pack chain[chain_count];
    for (int k = 0; k < chain_count; ++k) {
        chain[k] = Pack{} + static_cast<Number>(0.1 * (k + 1));
    }
    // x <- x f + g tends to g/(1 - f) = 1: no overflow, no denormals.
    Pack factor = Pack{} + static_cast<Number>(0.75), term = Pack{} + static_cast<Number>(0.25);
    asm volatile("" : "+x"(factor), "+x"(term));  // their values are not known when this is compiled
    for (std::int64_t round = 0; round < rounds; ++round) {
        for (int k = 0; k < chain_count; ++k) {
            chain[k] = chain[k] * factor + term;
        }
    }
    Pack sum{};
    for (const Pack& x : chain) {
        sum += x;
    }
    for (int lane = 0; lane < lanes; ++lane) {
        sink += static_cast<double>(sum[lane]);
    }
    return 2.0 * lanes * chain_count * static_cast<double>(rounds);
}

}  // namespace

void triad(double* a, const double* b, const double* c, double factor, std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
        a[i] = b[i] + factor * c[i];
    }
}

double run_fma_double(std::int64_t rounds, double& sink) { return run_fma<DoublePack, double>(rounds, sink); }
double run_fma_single(std::int64_t rounds, double& sink) { return run_fma<SinglePack, float>(rounds, sink); }

}  // namespace riprap::bench
