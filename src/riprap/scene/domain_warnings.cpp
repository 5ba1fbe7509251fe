// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/scene/fluid_warnings.hpp"
#include "riprap/scene/placed_part.hpp"

namespace riprap::scene {

void warn_of_bodies_outside(CaseBuild& build, const sim::FluidModel& fluid) {
    const fluid::Domain& domain = fluid.sph.domain;
    std::size_t count = 0, first = 0;
    for (std::size_t b = build.state.bodies.position.size(); b-- > 0;) {
        const Vec3& x = build.state.bodies.position[b];
        if (!domain.admits(x) && build.model.bodies.drive[b] == body::Drive::free && fluid.is_dry[b] == 0) {
            first = b;
            ++count;
        }
    }
    if (count > 0) {  // one line for all: a slide may begin far above its lake
        const Vec3& x = build.state.bodies.position[first];
        const std::string others = count > 1 ? fmt::format(" and {} more", count - 1) : "";
        warn_at(build, build.model.bodies.name_id[first],
                fmt::format("'{}' at ({:.6g}, {:.6g}, {:.6g}) m{} outside of 'fluid.domain', where no water comes",
                            build.model.bodies.name(BodyId{static_cast<std::int32_t>(first)}), x.x, x.y, x.z,
                            others.empty() ? " starts" : others + " start"));
    }
}

void warn_of_cut_region(CaseBuild& build, const SourcePlace& place, const coupling::FillRegion& region,
                        const fluid::Domain& domain, double spacing) {
    double most = 0;
    for (const geometry::Polyhedron& piece : region.pieces) {
        for (Vec3 x : piece.vertices) {
            x -= std::max(0.0, dot(x, build.up()) - region.level) * build.up();  // above its level it is empty
            for (int axis = 0; axis < domain.dimension; ++axis) {
                most = domain.is_periodic[static_cast<std::size_t>(axis)]
                           ? most
                           : std::max({most, domain.low[axis] - x[axis], x[axis] - domain.high[axis]});
            }
        }
    }
    if (most > (1 + 1e-6) * spacing) {
        build.warnings.push_back(to_string(Diagnostic{
            place, fmt::format("the region reaches {:.4g} m out of 'fluid.domain', where no water is placed", most),
            ""}));
    }
}

void warn_of_open_sides(CaseBuild& build, const SourcePlace& place, const sim::FluidModel& fluid,
                        const std::vector<Vec3>& water) {
    const fluid::Domain& domain = fluid.sph.domain;
    const double spacing = fluid.sph.spacing;
    for (int axis = 0; axis < domain.dimension; ++axis) {
        for (const double side : {domain.low[axis], domain.high[axis]}) {
            const double outward = side == domain.low[axis] ? -spacing : spacing;
            const auto is_open = [&](const Vec3& x) {
                Vec3 beyond = x;
                beyond[axis] += outward;
                return std::abs(side - x[axis]) < spacing && !solid_at(build, fluid.is_dry, beyond, 0).is_valid();
            };
            if (!domain.is_periodic[static_cast<std::size_t>(axis)] &&
                std::any_of(water.begin(), water.end(), is_open)) {
                build.warnings.push_back(to_string(Diagnostic{
                    place,
                    fmt::format(
                        "water stands at the side {} = {:.6g} m of the domain, where nothing holds it: a particle "
                        "that leaves ends the run",
                        "xyz"[axis], side),
                    "a wall there, an [[fluid.outflow]], or a larger domain"}));
            }
        }
    }
}

}  // namespace riprap::scene
