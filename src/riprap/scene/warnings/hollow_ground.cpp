// SPDX-License-Identifier: Apache-2.0
// Warns of ground that is a shell for a grid fluid: the fluid fills the room under it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/ground.hpp"
#include "riprap/scene/build/placed_part.hpp"
#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

constexpr int looks = 16;  // along each axis of the bottom

int axis_of(const Vec3& up) { return std::abs(up.x) > 0.5 ? 0 : std::abs(up.y) > 0.5 ? 1 : 2; }

/// Places just above the bottom of the domain.
std::vector<Vec3> bottom_of(const fluid::Domain& domain, const Vec3& up) {
    const int axis = axis_of(up), first = (axis + 1) % 3, second = (axis + 2) % 3;
    constexpr double above = 1e-6;  // of the height of the domain: the bottom may be a face of the ground
    const double height = domain.high[axis] - domain.low[axis];
    std::vector<Vec3> places;
    for (int i = 0; i < looks * looks; ++i) {
        Vec3 x;
        x[axis] = up[axis] > 0 ? domain.low[axis] + above * height : domain.high[axis] - above * height;
        x[first] = domain.low[first] + (i % looks + 0.5) / looks * (domain.high[first] - domain.low[first]);
        x[second] = domain.low[second] + (i / looks + 0.5) / looks * (domain.high[second] - domain.low[second]);
        if (domain.dimension == 2) {
            x.z = 0;
        }
        places.push_back(x);
    }
    return places;
}

/// Height of the highest point of ground above a place [m].
double height_above(const geometry::TriangleMesh& mesh, const Pose& pose, const Vec3& up, const Vec3& place) {
    double highest = 0;
    for (const Vec3& point : mesh.points) {
        highest = std::max(highest, dot(up, to_world(pose, point) - place));
    }
    return highest;
}

}  // namespace

void warn_of_hollow_ground(CaseBuild& build, const fluid::Domain& domain) {
    const body::BodySet& bodies = build.model.bodies;
    const std::vector<Vec3> places = bottom_of(domain, build.up());
    std::vector<std::uint8_t> is_dry = build.is_dry;
    is_dry.resize(static_cast<std::size_t>(bodies.size()), 0);
    for (const body::Ground& ground : body::find_grounds(bodies, build.model.shapes)) {
        const auto b = static_cast<std::size_t>(ground.body.value);
        if (is_dry[b] != 0) {
            continue;
        }
        const Pose pose{build.state.bodies.position[b], build.state.bodies.orientation[b]};
        const PlacedSolids solids(build, is_dry, domain.low, domain.high);
        const bool is_hollow = std::any_of(places.begin(), places.end(), [&](const Vec3& x) {
            return ground.field.is_inside(to_body(pose, x)) && !solids.at(x, 0).is_valid();
        });
        if (is_hollow) {
            warn_at(build, bodies.name_id[b],
                    fmt::format("'{}' does not reach the bottom of the grid, and the fluid fills the room under it: a "
                                "thickness of {:.3g} m would reach",
                                bodies.name(ground.body),
                                height_above(ground.field.mesh(), pose, build.up(), places.front())));
        }
    }
}

}  // namespace riprap::scene
