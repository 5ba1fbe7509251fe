// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps_operators/mps_choices.hpp"

namespace riprap::fluid {

/// Constants of the weight on the full lattice that particles start from, which normalise every operator.
struct MpsLattice {
    double number_density;  ///< n_0 = sum W [-]
    double lambda;          ///< sum r^2 W / sum W [m^2]
    double neighbours;      ///< N_0, particles within the support [-]
    /// Per displacement of lattice planes in a wave, u_i = u cos(pi x_i/l_0) e_x or u cos(pi x_i/(2 l_0)) e_x: the
    /// larger change of -grad C = (2 D/n_0) sum W d/r^2 [1/m^2]. No displacement of the lattice is stiffer by more than
    /// a few percent: the reciprocal weight resists the shorter wave most, the smooth one of a wide support the longer.
    double wave_stiffness;
    int dimension;   ///< D
    double spacing;  ///< l_0 [m]

    /// D/n_0: factor of gradients and divergences [-]
    double first_order() const { return dimension / number_density; }
    /// 2 D/(lambda n_0): factor of Laplacians [1/m^2]
    double second_order() const { return 2 * dimension / (lambda * number_density); }
};

/// @param support_ratio  r_e/l_0 [-]
/// @param spacing        l_0 [m]
/// @param dimension      2 or 3
MpsLattice mps_lattice(MpsWeightLaw law, double support_ratio, double spacing, int dimension);

/// W [-] at the distance of lattice places. @param r  over l_0, above 0 [-]
double lattice_weight(MpsWeightLaw law, double support_ratio, double r);

}  // namespace riprap::fluid
