// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cut_loads.hpp"

#include "riprap/fluid/grid/momentum.hpp"

namespace riprap::coupling {

using fluid::grid::at;

std::vector<GridLoad> cut_loads(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                const fluid::grid::GridScratch& scratch, const std::vector<GridBody>& bodies,
                                const CutBodies& cut) {
    const fluid::grid::Mesh& mesh = settings.mesh;
    std::vector<GridLoad> loads(bodies.size());
    const Vec3 g = fluid::grid::body_force(settings, state.time);
    for (const CutFacet& facet : cut.facets) {
        const double density =
            settings.has_surface ? fluid::grid::density_of(settings, state.fraction[at(facet.cell)]) : 0;
        GridLoad& load = loads[at(facet.body)];
        for (const Vec3& x : facet.middle) {  // exact where p rises linearly, the moment too
            const Vec3 force = facet.area * (-(state.pressure[at(facet.cell)] + density * dot(g, x)) / 3);
            load.pressure += force;
            load.torque += cross(x - bodies[at(facet.body)].centre, force);
        }
    }
    for (int a = 0; a < mesh.box.axes; ++a) {
        std::array<int, 3> last = mesh.box.cells;
        last[at(a)] += 1;
        for (int k = 0; k < last[2]; ++k) {
            for (int j = 0; j < last[1]; ++j) {
                for (int i = 0; i < last[0]; ++i) {
                    const std::int64_t f = mesh.box.index(i, j, k);
                    const double drag = scratch.wall_drag[at(a)][at(f)];
                    const std::int32_t body = cut.nearest[at(a)][at(f)];
                    if (drag == 0 || body < 0) {
                        continue;
                    }
                    const double volume =
                        0.5 * (scratch.capacity[at(f)] + scratch.capacity[at(f - mesh.box.stride[at(a)])]);
                    Vec3 force{}, x = mesh.centre(i, j, k);
                    x[a] -= 0.5 * mesh.h(a, std::array{i, j, k}[at(a)]);
                    force[a] =
                        drag * volume * (state.velocity[at(a)][at(f)] - scratch.open.body_velocity[at(a)][at(f)]);
                    loads[at(body)].shear += force;
                    loads[at(body)].torque += cross(x - bodies[at(body)].centre, force);
                }
            }
        }
    }
    return loads;
}

}  // namespace riprap::coupling
