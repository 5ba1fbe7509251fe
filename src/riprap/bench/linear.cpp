// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"
#include "riprap/linear/pcg.hpp"

namespace riprap::bench {

namespace {

using linear::BlockCsr;

/// Springs between the cells of a cubic lattice and all cells within `reach` cells of them, lattice order: positive
/// definite, neighbours about as far apart in memory as those of particles sorted by place.
template <int B>
BlockCsr<B> lattice_springs(std::int32_t side, double reach) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    const auto far = static_cast<std::int32_t>(reach);
    const auto is_inside = [&](std::int32_t k) { return k >= 0 && k < side; };
    for (std::int32_t cell = 0; cell < side * side * side; ++cell) {
        const std::int32_t x = cell % side, y = cell / side % side, z = cell / (side * side);
        for (std::int32_t offset = 0; offset < (2 * far + 1) * (2 * far + 1) * (2 * far + 1); ++offset) {
            const std::int32_t dx = offset % (2 * far + 1) - far, dy = offset / (2 * far + 1) % (2 * far + 1) - far,
                               dz = offset / ((2 * far + 1) * (2 * far + 1)) - far;
            const std::int32_t other = cell + dx + side * (dy + side * dz);
            const bool is_near = dx * dx + dy * dy + dz * dz <= reach * reach;
            if (other < cell && is_near && is_inside(x + dx) && is_inside(y + dy) && is_inside(z + dz)) {
                pairs.push_back({cell, other});
            }
        }
    }
    BlockCsr<B> a(linear::symmetric_pattern(std::int64_t{side} * side * side, pairs));
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        const std::int64_t first = a.pattern().first(row), end = a.pattern().end(row);
        for (std::int64_t e = first; e < end; ++e) {
            const bool is_diagonal = a.pattern().column_of(e) == row;
            for (int k = 0; k < B; ++k) {
                a.at(e, k, k) = is_diagonal ? 1e-3 + static_cast<double>(end - first - 1) : -1;
            }
        }
    }
    return a;
}

template <int B>
void measure_product(const Setting& setting, const std::string& name, std::int32_t side, double reach,
                     std::vector<Result>& results) {
    const auto a = lattice_springs<B>(side, reach);
    std::vector<double> x(a.size(), 1.0), y(a.size(), 0.0);
    for (std::size_t t = 0; t < setting.thread_counts.size(); ++t) {
        const ThreadScope scope(setting.thread_counts[t]);
        const Timing timing = time_calls([&] { a.multiply(x, y); });
        const double rate = a.bytes_per_product() / timing.median;
        const std::string share =
            t < setting.machine.by_threads.size()
                ? fmt::format("{:.0f} % of the bandwidth; ", 100 * rate / setting.machine.by_threads[t].triad)
                : "";
        results.push_back({name, setting.thread_counts[t], 1e-9 * rate, "GB/s",
                           fmt::format("{}{} rows of {:.1f} blocks of {} x {}, {:.0f} MB; {}", share, a.rows(),
                                       static_cast<double>(a.pattern().entries()) / static_cast<double>(a.rows()), B, B,
                                       1e-6 * static_cast<double>(a.bytes()), spread(timing))});
    }
}

template <class M>
void measure_solve(const Setting& setting, const std::string& name, const BlockCsr<1>& a, M& m,
                   std::vector<Result>& results) {
    std::vector<double> b(a.size()), x(a.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
        b[i] = static_cast<double>(i % 7) - 3;
    }
    linear::PcgScratch scratch;
    for (const int threads : setting.thread_counts) {
        const ThreadScope scope(threads);
        linear::SolveReport report;
        const Timing set_up = time_calls([&] { m.set_up(a); }, {3, 0});
        const Timing timing = time_calls(
            [&] {
                std::fill(x.begin(), x.end(), 0.0);
                report = linear::solve_pcg(a, m, b, x, {.tolerance = 1e-6}, scratch);
            },
            {3, 0});
        results.push_back({name, threads, 1e9 * timing.median / static_cast<double>(a.size()), "ns/row",
                           fmt::format("{} iterations to 1e-6, {} rows; set up in {:.0f} ns/row; {}", report.iterations,
                                       a.rows(), 1e9 * set_up.median / static_cast<double>(a.size()), spread(timing))});
    }
}

}  // namespace

void linear_product(const Setting& setting, std::vector<Result>& results) {
    measure_product<1>(setting, "linear.product.1", 60, 2.1, results);
    measure_product<3>(setting, "linear.product.3", 40, 1.5, results);
    measure_product<6>(setting, "linear.product.6", 30, 1.5, results);
    measure_product<12>(setting, "linear.product.12", 24, 1.1, results);
}

void linear_pcg(const Setting& setting, std::vector<Result>& results) {
    const auto a = lattice_springs<1>(50, 2.1);
    linear::BlockJacobi<1> jacobi;
    measure_solve(setting, "linear.pcg.block_jacobi", a, jacobi, results);
    linear::IncompleteCholesky<1> cholesky;
    measure_solve(setting, "linear.pcg.incomplete_cholesky", a, cholesky, results);
}

}  // namespace riprap::bench
