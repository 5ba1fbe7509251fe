// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums and updates over whole vectors with the same bits at any thread count: entries are folded into eight partial
// sums within fixed blocks of parallel::reduce_block entries, and blocks are added up exactly, in no order.

#include <cstdint>
#include <span>

namespace riprap::linear {

/// sum a_i b_i
double dot(std::span<const double> a, std::span<const double> b);

/// y = x + scale y
void scale_and_add(std::span<const double> x, double scale, std::span<double> y);

/// x += step p, r -= step q; returns r.r afterwards.
double step_along(double step, std::span<const double> p, std::span<const double> q, std::span<double> x,
                  std::span<double> r);

/// r = b - q; returns r.r.
double subtract(std::span<const double> b, std::span<const double> q, std::span<double> r);

}  // namespace riprap::linear
