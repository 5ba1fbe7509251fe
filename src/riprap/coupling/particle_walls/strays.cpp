// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/strays.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/particle_walls/near_parts.hpp"
#include "riprap/geometry/polyhedra/convex_query.hpp"

namespace riprap::coupling {

namespace {

Strays join(const Strays& a, const Strays& b) {
    Strays both = b.depth > a.depth ? b : a;
    both.count = a.count + b.count;
    return both;
}

}  // namespace

Strays find_strays(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                   std::span<const std::uint8_t> is_dry, const std::vector<Vec3>& particles, double least) {
    std::vector<PlacedPart> parts;
    for (const body::Part& part : bodies.parts) {
        const auto b = at(part.body.value);
        const geometry::ConvexView shape = shapes.view(part.shape);
        if ((is_dry.empty() || is_dry[b] == 0) && shape.inscribed_radius > least) {
            const Pose pose{state.position[b], state.orientation[b]};
            parts.push_back({shape,
                             {to_world(pose, part.local.position), pose.orientation * part.local.orientation},
                             part.body.value,
                             shape.circumradius});
        }
    }
    NearParts near_parts;
    near_parts.find(parts, particles, fluid::Domain{}, least);
    return parallel::reduce(
        static_cast<std::int64_t>(particles.size()), Strays{},
        [&](std::int64_t i) {
            Strays found;
            const Vec3& x = particles[at(i)];
            for (const std::int32_t near : near_parts.of_block(i / NearParts::block_size)) {
                const PlacedPart& part = parts[at(near)];
                if (norm_squared(x - part.pose.position) > part.reach * part.reach) {
                    continue;
                }
                const double depth = geometry::depth_below_faces(part.shape, to_body(part.pose, x));
                if (depth > least && depth > found.depth) {
                    found = {1, BodyId{part.body}, depth};
                }
            }
            return found;
        },
        join, 512);
}

}  // namespace riprap::coupling
