// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/porous.hpp"

#include <cmath>

namespace riprap::fluid::grid {

Resistance resistance_of(const PorousMedium& m) {
    const double n = m.porosity, solid = 1 - n, d = m.grain_size;
    const double unsteady = m.keulegan_carpenter > 0 ? 1 + 7.5 / m.keulegan_carpenter : 1;
    switch (m.closure) {
        case PorousClosure::ding:
            return {m.linear * solid * solid * solid / (n * n * n * d * d),
                    m.quadratic * unsteady * solid / (n * n * n * d), m.added_mass};
        case PorousClosure::van_gent:
            return {m.linear * solid * solid / (n * n * n * d * d), m.quadratic * unsteady * solid / (n * n * n * d),
                    0.34 * solid / n};
        case PorousClosure::engelund:
            return {m.linear * solid * solid * solid / (n * n * d * d), m.quadratic * solid / (n * n * n * d),
                    0.34 * solid / n};
    }
    return {};
}

MediumFields medium_fields(const GridSettings& settings) {
    MediumFields fields;
    if (settings.porous.empty()) {
        return fields;
    }
    const Mesh& mesh = settings.mesh;
    fields.has_stones = true;
    fields.porosity.assign(at(mesh.box.size), 1.0);
    for (auto* field : {&fields.linear, &fields.quadratic, &fields.added_mass, &fields.grain_size}) {
        field->assign(at(mesh.box.size), 0.0);
    }
    std::array<int, 3> first{}, last = mesh.box.cells;
    for (int a = 0; a < mesh.box.axes; ++a) {  // ghosts continue what touches a side
        first[at(a)] = -Mesh::ghosts;
        last[at(a)] += Mesh::ghosts;
    }
    for_box(mesh.box, first, last, [&](std::int64_t c, int i, int j, int k) {
        std::array<int, 3> place{i, j, k};
        for (std::size_t a = 0; a < 3; ++a) {
            place[a] = std::clamp(place[a], 0, mesh.box.cells[a] - 1);
        }
        for (const PorousZone& zone : settings.porous) {
            if (zone.holds(mesh.centre(place[0], place[1], place[2]))) {
                const Resistance r = resistance_of(zone.medium);
                fields.porosity[at(c)] = zone.medium.porosity;
                fields.linear[at(c)] = r.linear;
                fields.quadratic[at(c)] = r.quadratic;
                fields.added_mass[at(c)] = r.added_mass;
                fields.grain_size[at(c)] = zone.medium.grain_size;
            }
        }
    });
    return fields;
}

double filter_speed(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face) {
    const CellBox& box = settings.mesh.box;
    const std::int64_t sa = box.stride[at(a)];
    double square = 0;
    for (int b = 0; b < box.axes; ++b) {
        const auto& u = s.start.carrier[at(b)];
        const std::int64_t t = box.stride[at(b)];
        const double v =
            b == a ? u[at(face)] : 0.25 * (u[at(face)] + u[at(face + t)] + u[at(face - sa)] + u[at(face - sa + t)]);
        square += v * v;
    }
    return std::sqrt(square);
}

}  // namespace riprap::fluid::grid
