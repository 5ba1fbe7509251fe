// SPDX-License-Identifier: Apache-2.0
#pragma once

// The seam between a scheme and the traversal of neighbours. A scheme writes what one candidate j does to one target i
// once, as a functor on a number type; the traversals call it with double one pair at a time (the oracle), with lanes
// of float on the host, with float on a device.

#include <concepts>

#include "riprap/core/config.hpp"

namespace riprap::fluid {

/// Physics of one directed pair.
///
///     struct Continuity {
///         static constexpr int target_fields = 3;     // numbers read per target besides its place: vx, vy, vz
///         static constexpr int candidate_fields = 4;  // per candidate: vx, vy, vz, volume
///         static constexpr int sums = 1;              // numbers gathered per target
///         WendlandC2 kernel;                          // constants of the step, trivially copyable
///         template <int Dim, class Real>
///         RIPRAP_HD void operator()(const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
///                                   Real* sum) const;
///     };
///
/// d = x_i - x_j (Dim numbers [m]) and r = |d|, r2 its square. Every term must be a multiple of the kernel or of its
/// slope, which are exactly zero at and beyond the support, so that a candidate out of reach adds nothing; and finite
/// at r2 = 0, where a particle meets itself. Plain arithmetic and the functions of particle/math.hpp only: Real may be
/// a vector of lanes.
template <class P>
concept PairPhysics = requires {
    { P::target_fields } -> std::convertible_to<int>;
    { P::candidate_fields } -> std::convertible_to<int>;
    { P::sums } -> std::convertible_to<int>;
};

/// Physics of a pair whose two directions share most of their arithmetic. Besides the above
///
///     static constexpr int back_sums = 3;  // numbers gathered per candidate
///     template <int Dim, class Real>
///     RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r,
///                             Real* sum, Real* back) const;
///
/// which adds to `sum` what b does to a, and to `back` what a does to b. The call operator gives the first alone.
template <class P>
concept MutualPhysics = PairPhysics<P> && requires {
    { P::back_sums } -> std::convertible_to<int>;
};

}  // namespace riprap::fluid
