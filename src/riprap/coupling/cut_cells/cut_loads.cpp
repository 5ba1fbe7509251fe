// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/cut_cells/cut_loads.hpp"

#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/viscous.hpp"

namespace riprap::coupling {

using fluid::grid::at;

namespace {

/// P = p - rho g.(x - datum) [Pa] and density [kg/m^3] of the water that a facet looks at.
struct Water {
    double pressure{0}, density{0};
};

std::vector<Water> water_in_joints(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                   const CutBodies& cut) {
    std::vector<Water> found;
    found.reserve(cut.joints.size());
    for (const JointCell& joint : cut.joints) {
        Water sum;
        const double share = 1 / static_cast<double>(joint.sources.size());
        for (const std::int64_t source : joint.sources) {
            const Water one = source < 0 ? found[at(-1 - source)]
                                         : Water{state.pressure[at(source)],
                                                 fluid::grid::density_of(settings, state.fraction[at(source)])};
            sum.pressure += share * one.pressure;
            sum.density += share * one.density;
        }
        found.push_back(sum);
    }
    return found;
}

}  // namespace

std::vector<GridLoad> cut_loads(const fluid::grid::GridSettings& settings, const fluid::grid::GridState& state,
                                const fluid::grid::GridScratch& scratch, const std::vector<GridBody>& bodies,
                                const CutBodies& cut, double time) {
    const fluid::grid::Mesh& mesh = settings.mesh;
    std::vector<GridLoad> loads(bodies.size());
    const Vec3 g = fluid::grid::body_force(settings, time), datum = fluid::grid::datum_of(mesh);
    const std::vector<Water> joints = water_in_joints(settings, state, cut);
    for (const CutFacet& facet : cut.facets) {
        const bool is_joint = scratch.open.volume[at(facet.cell)] == 0;
        if (is_joint && facet.joint < 0) {
            continue;
        }
        const Water water = is_joint ? joints[at(facet.joint)]
                                     : Water{state.pressure[at(facet.cell)],
                                             fluid::grid::density_of(settings, state.fraction[at(facet.cell)])};
        const double density = settings.has_surface ? water.density : 0;
        GridLoad& load = loads[at(facet.body)];
        for (const Vec3& x : facet.middle) {  // exact where p rises linearly, the moment too
            const Vec3 force = facet.area * (-(water.pressure + density * dot(g, x - datum)) / 3);
            const Vec3 arm = x - bodies[at(facet.body)].centre;
            load.pressure += force;
            load.torque += cross(arm, force);
            load.pull += symmetric_product(force, arm);
        }
    }
    for (const MeshFace& face : cut.near_faces) {
        const auto a = at(face.axis);
        const double drag = fluid::grid::wall_drag(settings, scratch, face.axis, face.index, face.place);
        if (drag == 0) {
            continue;
        }
        const std::int32_t body = cut.nearest[a][at(face.index)];
        const double volume =
            0.5 * (scratch.room.capacity[at(face.index)] + scratch.room.capacity[at(face.index - mesh.box.stride[a])]);
        Vec3 force{}, x = mesh.centre(face.place[0], face.place[1], face.place[2]);
        x[face.axis] -= 0.5 * mesh.h(face.axis, face.place[a]);
        force[face.axis] =
            drag * volume * (state.velocity[a][at(face.index)] - scratch.open.body_velocity[a][at(face.index)]);
        GridLoad& load = loads[at(body)];
        const Vec3 arm = x - bodies[at(body)].centre;
        load.shear += force;
        load.shear_torque += cross(arm, force);
        load.shear_pull += symmetric_product(force, arm);
        load.torque += cross(arm, force);
        load.pull += symmetric_product(force, arm);
    }
    return loads;
}

}  // namespace riprap::coupling
