// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/body/body_set.hpp"
#include "riprap/contact/contact_set.hpp"
#include "riprap/core/step.hpp"

namespace riprap::solid {

/// Sums and extremes over the contacts of polyhedra in one step. Every contact is added exactly, so the sums depend on
/// no order or grouping of contacts.
struct PolyhedralSums {
    double elastic{0}, shear{0}, friction_loss{0};  ///< [J]
    float potential{0};                             ///< largest [-]
    float overlap{0};                               ///< largest [m]
    std::int64_t deepest{-1};                       ///< row of the largest potential, the first of several

    template <class By>
    static void join(PolyhedralSums& a, const PolyhedralSums& b, const By& by) {
        by.add(a.elastic, b.elastic);
        by.add(a.shear, b.shear);
        by.add(a.friction_loss, b.friction_loss);
        by.largest(a.overlap, b.overlap);
        a.take_deeper(b);
    }

 private:
    void take_deeper(const PolyhedralSums& other);
};
PolyhedralSums sum_contacts(const contact::ContactRows& rows, const contact::ContactHistory& history);

/// Names the deepest contact where it is deeper than allowed, at kick time `time`.
Outcome judge_overlap(const body::BodySet& bodies, double max_potential, const PolyhedralSums& contacts,
                      const contact::ContactRows& rows, double time);

}  // namespace riprap::solid
