// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/core/step.hpp"

namespace riprap::solid {

/// Sums and extremes over the contacts of polyhedra in one step, in fixed blocks of their order.
struct PolyhedralSums {
    double elastic{0}, shear{0}, friction_loss{0};  ///< [J]
    float potential{0};                             ///< largest [-]
    float overlap{0};                               ///< largest [m]
    std::int64_t deepest{-1};                       ///< row of the largest potential
};
PolyhedralSums sum_contacts(const contact::ContactRows& rows, const contact::ContactHistory& history);

/// Names the deepest contact where it is deeper than allowed, at kick time `time`.
Outcome judge_overlap(const body::BodySet& bodies, double max_potential, const PolyhedralSums& contacts,
                      const contact::ContactRows& rows, double time);

}  // namespace riprap::solid
