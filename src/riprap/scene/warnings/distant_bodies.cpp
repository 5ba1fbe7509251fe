// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/distant_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/scene/warnings/fluid_warnings.hpp"

namespace riprap::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

    void add(const Vec3& x, double radius) {
        low = min(low, x - Vec3{radius, radius, radius});
        high = max(high, x + Vec3{radius, radius, radius});
    }
    bool is_empty() const { return !(low.x <= high.x); }
    double size() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

/// The box of the balls around the parts of a body; without those that have no end.
Box box_of(const CaseBuild& build, std::size_t b) {
    const body::BodySet& bodies = build.model.bodies;
    const Pose pose{build.state.bodies.position[b], build.state.bodies.orientation[b]};
    Box box;
    for (auto p = bodies.part_begin[b]; p < bodies.part_begin[b + 1]; ++p) {
        const body::Part& part = bodies.parts[static_cast<std::size_t>(p)];
        const double radius = build.model.shapes.view(part.shape).circumradius;
        if (std::isfinite(radius)) {
            box.add(to_world(pose, part.local.position), radius);
        }
    }
    return box;
}

/// Largest distance between two boxes along an axis.
double gap(const Box& a, const Box& b) {
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        most = std::max({most, b.low[axis] - a.high[axis], a.low[axis] - b.high[axis]});
    }
    return most;
}

}  // namespace

void warn_of_distant_bodies(CaseBuild& build) {
    const auto count = static_cast<std::size_t>(build.model.bodies.size());
    Box moving;
    for (std::size_t b = 0; b < count; ++b) {
        if (build.model.bodies.drive[b] == body::Drive::free) {
            moving.add(build.state.bodies.position[b], 0);
        }
    }
    if (build.domain && std::isfinite(norm(build.domain->low)) && std::isfinite(norm(build.domain->high))) {
        moving.add(build.domain->low, 0);
        moving.add(build.domain->high, 0);
    }
    for (std::size_t b = 0; b < count && !moving.is_empty(); ++b) {
        if (build.model.bodies.drive[b] == body::Drive::free) {
            continue;
        }
        constexpr double many = 1000;
        const Box box = box_of(build, b);
        const double distance = box.is_empty() ? 0 : gap(box, moving);
        if (distance > many * std::max(box.size(), moving.size())) {
            const std::string name = build.model.bodies.name(BodyId{static_cast<std::int32_t>(b)});
            warn_at(build, build.model.bodies.name_id[b],
                    fmt::format("'{}' lies {:.4g} m from all that moves{}: its 'position' or an 'origin' brings map "
                                "coordinates to those of the scene",
                                name, distance, build.domain ? " and from 'fluid.domain'" : ""));
        }
    }
}

}  // namespace riprap::scene
