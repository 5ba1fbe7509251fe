// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "riprap/body/ground.hpp"
#include "riprap/scene/case/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

void warn_of_hollow_ground(CaseBuild& build, const fluid::Domain& domain) {
    constexpr int places = 40;  // along each axis
    const std::array<int, 3> count{places, places, domain.dimension == 3 ? places : 1};
    const PlacedSolids solids(build, build.is_dry, domain.low, domain.high);
    for (const body::Ground& ground : body::find_grounds(build.model.bodies, build.model.shapes)) {
        const auto b = static_cast<std::size_t>(ground.body.value);
        const Pose pose{build.state.bodies.position[b], build.state.bodies.orientation[b]};
        int hollow = 0;
        double lowest = 0;
        Vec3 where{};
        for (int n = 0; n < count[0] * count[1] * count[2]; ++n) {
            const std::array<int, 3> cell{n % count[0], n / count[0] % count[1], n / (count[0] * count[1])};
            Vec3 x{};
            for (int axis = 0; axis < domain.dimension; ++axis) {
                const auto a = static_cast<std::size_t>(axis);
                x[axis] = domain.low[axis] + (cell[a] + 0.5) / count[a] * (domain.high[axis] - domain.low[axis]);
            }
            if (!ground.field.is_inside(to_body(pose, x)) || solids.at(x, 0).is_valid()) {
                continue;
            }
            if (hollow == 0 || dot(build.up(), x) < lowest) {
                lowest = dot(build.up(), x);
                where = x;
            }
            ++hollow;
        }
        if (hollow > 0) {
            warn_at(build, build.model.bodies.name_id[b],
                    fmt::format("'{}' is hollow in {:.2g} % of 'fluid.domain', as at ({:.6g}, {:.6g}, {:.6g}) m: this "
                                "fluid fills what lies below the cells of ground; a larger 'thickness' closes it",
                                build.model.bodies.name(ground.body), 100.0 * hollow / (count[0] * count[1] * count[2]),
                                where.x, where.y, where.z));
        }
    }
}

}  // namespace riprap::scene
