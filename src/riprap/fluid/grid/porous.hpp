// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"

namespace riprap::fluid::grid {

/// Coefficients of the resistance of stones, R = a mu + b rho |U| [Pa s/m^2] with the filter velocity U.
struct Resistance {
    double linear;      ///< a [1/m^2]
    double quadratic;   ///< b [1/m]
    double added_mass;  ///< C_A [-]
};

/// Resistance by the closures, D the grain size, n the porosity, K = 1 + 7.5/K_C (1 in steady flow):
///
///     ding       a = mu_1 (1-n)^3/(n^3 D^2),  b = mu_2 K (1-n)/(n^3 D),  C_A as given    [Ding2021, eqs. 3.20, 3.21]
///     van_gent   a = mu_1 (1-n)^2/(n^3 D^2),  b = mu_2 K (1-n)/(n^3 D),  C_A = 0.34 (1-n)/n            [VanGent1995]
///     engelund   a = mu_1 (1-n)^3/(n^2 D^2),  b = mu_2 (1-n)/(n^3 D),    C_A = 0.34 (1-n)/n           [Engelund1953]
///
/// The quadratic term of [Ding2021, eq. 3.24] is printed with n^4; n^3 is that of its sources.
Resistance resistance_of(const PorousMedium& medium);

/// Fills the fields of the medium from the zones.
MediumFields medium_fields(const GridSettings& settings);

/// Viscosity that stones resist with: of both phases by their volume, as drag adds up over volumes, and molecular: what
/// eddies between stones take is in the quadratic term [Pa s].
inline double drag_viscosity(const GridSettings& settings, double fraction) {
    const double water = settings.water.density * settings.water.kinematic_viscosity;
    const double air = settings.air.density * settings.air.kinematic_viscosity;
    return settings.has_surface ? fraction * water + (1 - fraction) * air : water;
}

/// Medium on a face: means by the widths of the two half cells, so that the drop of pressure over a layer of whole
/// cells is exact.
struct FaceMedium {
    double porosity{1};
    double linear{0};      ///< R at rest [Pa s/m^2]
    double quadratic{0};   ///< growth of R with |U| [Pa s^2/m^3]
    double added_mass{0};  ///< [-]
};
inline FaceMedium face_medium(const GridSettings& settings, const GridScratch& s, std::int64_t face,
                              std::int64_t stride, double share_low, double density, double viscosity) {
    (void)settings;
    const MediumFields& m = s.medium;
    if (!m.has_stones) {
        return {};
    }
    const auto mean = [&](const std::vector<double>& field) {
        return share_low * field[at(face - stride)] + (1 - share_low) * field[at(face)];
    };
    return {mean(m.porosity), viscosity * mean(m.linear), density * mean(m.quadratic), mean(m.added_mass)};
}

/// Size of the filter velocity at a face, of the start of the step [m/s].
double filter_speed(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face);

}  // namespace riprap::fluid::grid
