// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/contact_sums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::solid {

PolyhedralSums sum_contacts(const contact::ContactRows& rows, const contact::ContactHistory& history) {
    return parallel::reduce(
        static_cast<std::int64_t>(rows.size()), PolyhedralSums{},
        [&](std::int64_t i) {
            const contact::ContactRow& row = rows[at(i)];
            return PolyhedralSums{
                row.elastic_energy, history.shear_energy[at(i)], row.friction_loss, row.potential, row.overlap, i};
        },
        [](PolyhedralSums a, const PolyhedralSums& b) {
            a.elastic += b.elastic;
            a.shear += b.shear;
            a.friction_loss += b.friction_loss;
            a.overlap = std::max(a.overlap, b.overlap);
            // A potential that is not a number counts as the deepest and stays so.
            if (b.deepest >= 0 && (a.deepest < 0 || (!std::isnan(a.potential) && !(b.potential <= a.potential)))) {
                a.potential = b.potential;
                a.deepest = b.deepest;
            }
            return a;
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
