// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/vector_ops.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/core/wide.hpp"

namespace riprap::linear {
namespace {

using Eight = Wide<double, 8>;

double fold(const Eight& a) { return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])); }

/// Sums eight(i) over groups of eight entries and one(i) over the rest in fixed blocks, and the blocks exactly.
template <class EightAt, class OneAt>
double sum_in_blocks(std::size_t count, const EightAt& eight, const OneAt& one) {
    constexpr auto block = static_cast<std::size_t>(parallel::reduce_block);
    const auto sum_of_block = [&](std::int64_t index) {
        std::size_t i = static_cast<std::size_t>(index) * block;
        const std::size_t end = std::min(count, i + block);
        Eight sum{};
        for (; i + 8 <= end; i += 8) {
            sum += eight(i);
        }
        double total = fold(sum);
        for (; i < end; ++i) {
            total += one(i);
        }
        return total;
    };
    return parallel::sum(static_cast<std::int64_t>((count + block - 1) / block), sum_of_block, 1);
}

}  // namespace

double dot(std::span<const double> a, std::span<const double> b) {
    return sum_in_blocks(
        a.size(), [&](std::size_t i) { return Eight::load(&a[i]) * Eight::load(&b[i]); },
        [&](std::size_t i) { return a[i] * b[i]; });
}

void scale_and_add(std::span<const double> x, double scale, std::span<double> y) {
    parallel::for_each(static_cast<std::int64_t>(y.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        y[i] = x[i] + scale * y[i];
    });
}

double step_along(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
                  std::span<double> r) {
    const auto eight = [&](std::size_t i) {
        (Eight::load(&x[i]) + step * Eight::load(&p[i])).store(&x[i]);
        const Eight rest = Eight::load(&r[i]) - step * Eight::load(&q[i]);
        rest.store(&r[i]);
        return rest * rest;
    };
    const auto one = [&](std::size_t i) {
        x[i] += step * p[i];
        r[i] -= step * q[i];
        return r[i] * r[i];
    };
    return sum_in_blocks(x.size(), eight, one);
}

double subtract(std::span<const double> b, std::span<const double> q, std::span<double> r) {
    const auto eight = [&](std::size_t i) {
        const Eight rest = Eight::load(&b[i]) - Eight::load(&q[i]);
        rest.store(&r[i]);
        return rest * rest;
    };
    const auto one = [&](std::size_t i) {
        r[i] = b[i] - q[i];
        return r[i] * r[i];
    };
    return sum_in_blocks(b.size(), eight, one);
}

}  // namespace riprap::linear
