// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/geometry/surface/triangle.hpp"
#include "riprap/solid/affine/ground.hpp"
#include "riprap/solid/affine/ground_contacts.hpp"

// One block and one ground while their contact points are found, in the frame of the ground.

namespace riprap::solid::affine {

/// Kinds of contact points with ground. Numbers 1 to 3 are kinds of contact points of two blocks.
enum class GroundKind : std::uint8_t {
    corner = 4,  ///< of the block, on a triangle
    point = 5,   ///< of the ground, on a face of the block
    edges = 6    ///< that cross
};
constexpr std::uint64_t ground_feature(GroundKind kind, std::size_t of_block, std::int32_t of_ground) {
    return static_cast<std::uint64_t>(kind) << 60 | static_cast<std::uint64_t>(of_block) << 32 |
           static_cast<std::uint32_t>(of_ground);
}

constexpr GroundKind kind_of(std::uint64_t feature) { return static_cast<GroundKind>(feature >> 60); }

/// A box along the axes of the ground.
struct Box {
    Vec3 low, high;

    void add(const Vec3& x) {
        low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
        high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
    bool meets(const Box& o, double reach) const {
        return low.x <= o.high.x + reach && o.low.x <= high.x + reach && low.y <= o.high.y + reach &&
               o.low.y <= high.y + reach && low.z <= o.high.z + reach && o.low.z <= high.z + reach;
    }
};

/// A block in the frame of the ground.
struct LocalBlock {
    const contact::HullTopology& topology;
    std::vector<Vec3> vertices, normals;
    Vec3 centre;
    Box box;
    double size{0};  ///< radius about the centre [m]

    LocalBlock(const OnGround& scene, const Vec3& middle) : topology(*scene.block.topology), centre(middle), box{} {
        for (const Vec3& x : scene.block.vertices) {
            vertices.push_back(transpose_times(scene.turn, x - scene.position));
            size = std::max(size, norm_squared(vertices.back() - centre));
        }
        for (const Vec3& n : scene.block.normals) {
            normals.push_back(transpose_times(scene.turn, n));
        }
        size = std::sqrt(size);
        box = {vertices[0], vertices[0]};
        for (const Vec3& x : vertices) {
            box.add(x);
        }
    }
    contact::PlacedHull hull() const { return {&topology, vertices, normals, centre, 0}; }
    double lowest_along(const Vec3& n) const {
        double least = dot(n, vertices[0]);
        for (const Vec3& x : vertices) {
            least = std::min(least, dot(n, x));
        }
        return least;
    }
};

/// Finds the contact points of a block with a ground.
class GroundMeeting {
 public:
    GroundMeeting(const OnGround& scene, const LocalBlock& block, double reach, const NearGround& near)
        : scene_(scene),
          block_(block),
          reach_(reach),
          near_(near),
          mesh_(scene.ground->field.mesh()),
          features_(scene.ground->features),
          misses_(block.vertices.size()) {}

    /// Appends the contact points, sorted by feature; rows begin to end of the history belong to the pair.
    void find(const BlockContactHistory& history, std::size_t begin, std::size_t end, std::vector<BlockContact>& found);
    /// The same of a ball or a disc: one contact (a disc: two) at each place of the surface that is nearest to its
    /// centre among those around it.
    void find_round(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                    std::vector<BlockContact>& found);

 private:
    /// Place of a triangle that is nearest to the centre of the block.
    struct NearestOn {
        geometry::TrianglePoint on;
        double distance;  ///< [m]
    };
    NearestOn nearest_on(std::int32_t triangle) const;
    bool goes_on_nearer(std::int32_t triangle, const NearestOn& here) const;

    /// A triangle as a plane under the whole block.
    struct Floor {
        Vec3 normal;
        double offset;
        double highest;  ///< gap up to which corners are met [m]
        bool is_met;
        double gap(const Vec3& x) const { return dot(normal, x) - offset; }
    };
    /// The triangle nearest to a corner that lies in no cell.
    struct Miss {
        bool has_cell{false};
        double squared{0};
        std::int32_t triangle{-1};
    };

    Floor floor_of(std::int32_t triangle) const;
    Box box_of(std::int32_t triangle) const;
    void add(GroundKind kind, std::size_t of_block, std::int32_t of_ground, const Vec3& normal, const Vec3& on_ground,
             const Vec3& on_block);

    void add_corners();
    bool has_corner(std::size_t v, const Vec3& normal) const;
    void add_corner(std::size_t v, std::int32_t triangle, const Floor& floor);
    void add_clefts(std::size_t v, std::int32_t triangle);
    void remember_miss(std::size_t v, std::int32_t triangle, double gap);

    void add_points(const BlockContactHistory& history, std::size_t begin, std::size_t end);
    bool falls_away(std::int32_t point, const Vec3& down) const;
    bool is_over(std::size_t face, const Vec3& x) const;

    void add_edges();
    void add_crossing(std::int32_t e, const geometry::SurfaceEdge& edge, std::size_t i);

    void share_areas();
    bool are_neighbours(GroundKind kind, std::int32_t x, std::int32_t y) const;
    void take_over(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                   std::span<BlockContact> own) const;

    const OnGround& scene_;
    const LocalBlock& block_;
    double reach_;
    const NearGround& near_;
    const geometry::TriangleMesh& mesh_;
    const geometry::SurfaceFeatures& features_;
    std::vector<Miss> misses_;
    std::vector<BlockContact>* found_{nullptr};
    std::size_t first_{0};
};

}  // namespace riprap::solid::affine
