// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"
#include "riprap/fluid/mps_operators/mps_choices.hpp"
#include "riprap/fluid/particle/sweep/math.hpp"

namespace riprap::fluid {

/// Counts the neighbours of a particle, itself included, by Wendland's C2 function over the support radius r_e,
///
///     C^W = sum w/C_0,    w = (1 - q)^4 (1 + 4 q),    q = r/r_e < 1,
///
/// C_0 the same on the lattice. It does not tell arrangements apart: for the same particles per volume hexagonal and
/// face- and body-centred lattices have 1.000 (r_e = 3.1 l_0; 1.000 to 1.005 at 2.1), where sum W of the smooth weight
/// has 0.995 (0.974 to 0.983). With the reciprocal weight w = W, which is zero where a particle meets itself, as in the
/// source.
struct EvenCount {
    double reach{1};  ///< r_e [m]
    bool is_smooth{true};

    EvenCount() = default;
    EvenCount(double support_radius, MpsWeightLaw law)
        : reach(support_radius), is_smooth(law == MpsWeightLaw::smooth) {}

    /// w of a pair [-]. @param weight  W of it [-]
    template <class Real>
    RIPRAP_HD Real of_pair(Real r, Real weight) const {
        if (!is_smooth) {
            return weight;
        }
        const Real q = r * Real(1 / reach), rest = max(Real(1) - q, Real(0)), square = rest * rest;
        return square * square * (Real(1) + Real(4) * q);
    }
};

/// Returns what counts lack behind a flat surface, from how they lean outward, o = |sum W d/r|/n_0:
///
///     lack = a o + b o^2    [-],
///
/// right in the first two rows of the lattice.
struct EvenLattice {
    double full{1};     ///< C_0
    double a{0}, b{0};  ///< [-]
    double lack(double outward) const { return outward * (a + b * outward); }
};

/// @param support_ratio  r_e/l_0 [-]
/// @param dimension      2 or 3
EvenLattice even_lattice(MpsWeightLaw law, double support_ratio, int dimension);

}  // namespace riprap::fluid
