// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/contact_sums.hpp"

#include <fmt/format.h>

#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/sum.hpp"

namespace riprap::solid {

// A potential that is not a number counts as the deepest.
void PolyhedralSums::take_deeper(const PolyhedralSums& other) {
    if (other.deepest < 0) {
        return;
    }
    const bool is_none = std::isnan(potential), is_other_none = std::isnan(other.potential);
    const bool is_deeper = is_none != is_other_none ? is_other_none : !is_none && other.potential > potential;
    const bool is_same = is_none == is_other_none && (is_none || other.potential == potential);
    if (deepest < 0 || is_deeper || (is_same && other.deepest < deepest)) {
        potential = other.potential;
        deepest = other.deepest;
    }
}

PolyhedralSums sum_contacts(const contact::ContactRows& rows, const contact::ContactHistory& history) {
    return parallel::sum_exactly(static_cast<std::int64_t>(rows.size()), [&](std::int64_t i) {
        const contact::ContactRow& row = rows[at(i)];
        PolyhedralSums one;
        one.elastic = row.elastic_energy;
        one.shear = history.shear_energy[at(i)];
        one.friction_loss = row.friction_loss;
        one.potential = row.potential;
        one.overlap = row.overlap;
        one.deepest = i;
        return one;
    });
}

Outcome judge_overlap(const body::BodySet& bodies, double max_potential, const PolyhedralSums& contacts,
                      const contact::ContactRows& rows, double time) {
    if (contacts.deepest < 0 || contacts.potential <= max_potential) {
        return {};
    }
    const contact::ContactRow& row = rows[at(contacts.deepest)];
    const auto name = [&](std::int32_t part) { return bodies.name(bodies.parts[at(part)].body); };
    return {
        fmt::format("overlap of {} and {} reaches {:.4g} of an inscribed radius at ({:.6g}, {:.6g}, {:.6g}) m, "
                    "t = {:.9g} s; allowed: {:.4g}",
                    name(row.parts.a), name(row.parts.b), contacts.potential, row.point.x, row.point.y, row.point.z,
                    time, max_potential)};
}

}  // namespace riprap::solid
