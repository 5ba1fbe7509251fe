// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/ground_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/solid/affine/ground_meeting.hpp"

namespace riprap::solid::affine {

namespace {

template <class T>
void make_unique(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Looks for triangles, edges and points again where the block may have left the ball of the last search.
void look_around(const Ground& ground, const Vec3& centre, double radius, NearGround& near) {
    if (near.radius >= 0 && norm(centre - near.centre) + radius <= near.radius) {
        return;
    }
    near.centre = centre;
    near.radius = 1.25 * radius;
    near.triangles.clear();
    near.edges.clear();
    near.points.clear();
    ground.field.near(centre, near.radius, near.triangles);
    const geometry::SurfaceFeatures& features = ground.features;
    for (const std::int32_t t : near.triangles) {
        for (const std::int32_t e : features.edges_of(t)) {
            const geometry::SurfaceEdge& edge = features.edge(e);
            if (edge.kind == geometry::EdgeKind::ridge) {
                near.edges.push_back(e);
            }
            for (const std::int32_t p : {edge.from, edge.to}) {
                if (features.is_sharp(p)) {
                    near.points.push_back(p);
                }
            }
        }
    }
    make_unique(near.edges);
    make_unique(near.points);
}

double radius_of(const contact::PlacedHull& block) {
    double square = 0;
    for (const Vec3& x : block.vertices) {
        square = std::max(square, norm_squared(x - block.centre));
    }
    return std::sqrt(square);
}

}  // namespace

Shape ground_shape(geometry::TriangleField surface) {
    Shape shape;
    for (const Vec3& x : surface.mesh().points) {
        shape.circumradius = std::max(shape.circumradius, norm(x));
    }
    shape.ground = std::make_shared<const Ground>(std::move(surface));
    return shape;
}

void find_on_ground(const OnGround& scene, const BlockContactHistory& history, std::size_t begin, std::size_t end,
                    double reach, NearGround& near, std::vector<BlockContact>& found) {
    const Vec3 centre = transpose_times(scene.turn, scene.block.centre - scene.position);
    look_around(*scene.ground, centre, radius_of(scene.block) + reach, near);
    if (!near.triangles.empty()) {
        const LocalBlock block(scene, centre);
        GroundMeeting meeting(scene, block, reach, near);
        scene.round.ball_radius > 0 ? meeting.find_round(history, begin, end, found)
                                    : meeting.find(history, begin, end, found);
    }
}

}  // namespace riprap::solid::affine
