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
///         struct Water { enum : int { velocity, count = velocity + 3 }; };
///         struct Wall { enum : int { velocity, volume = velocity + 3, count }; };
///         static constexpr int target_fields = Water::count;    // numbers read per target besides its place
///         static constexpr int candidate_fields = Wall::count;  // per candidate
///         static constexpr int sums = 1;                        // numbers gathered per target
///         WendlandC2 kernel;                                    // constants of the step, trivially copyable
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

/// Physics of a pair whose two directions share most of their arithmetic. In place of the call operator it has
///
///     static constexpr int back_sums = 3;  // numbers gathered per candidate
///     template <int Dim, class Real>
///     RIPRAP_HD void exchange(const Real* a, const Real* b, const Real* d, Real r2, Real r,
///                             Real* sum, Real* back) const;
///
/// which adds to `sum` what b does to a, and to `back` what a does to b.
template <class P>
concept MutualPhysics = PairPhysics<P> && requires {
    { P::back_sums } -> std::convertible_to<int>;
};

/// Adds to `sum` what the candidate does to the target, and nothing to the candidate.
template <int Dim, PairPhysics Pair, class Real>
RIPRAP_HD void act_one_way(const Pair& pair, const Real* target, const Real* candidate, const Real* d, Real r2, Real r,
                           Real* sum) {
    if constexpr (MutualPhysics<Pair>) {
        Real back[Pair::back_sums];
        for (Real& number : back) {
            number = Real(0);
        }
        pair.template exchange<Dim>(target, candidate, d, r2, r, sum, back);
    } else {
        pair.template operator()<Dim>(target, candidate, d, r2, r, sum);
    }
}

}  // namespace riprap::fluid
