// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_settings.hpp"

#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid {

MpsSettings::MpsSettings() {
    smoothing_ratio = 1.55;
    courant = 0.2;
    state_equation = StateEquation::linear;
}

MpsWeight MpsSettings::weight() const { return {support_radius(), spacing, weight_law}; }

MpsLattice MpsSettings::lattice() const { return mps_lattice(weight_law, support_ratio(), spacing, domain.dimension); }

}  // namespace riprap::fluid
