// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/ground_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/triangle.hpp"
#include "riprap/solid/affine/ground.hpp"

namespace riprap::solid::affine {

namespace {

using geometry::EdgeKind;
using geometry::SurfaceEdge;

/// Ends of edges and of faces count as longer by this share, so that nothing falls between two of them [-].
constexpr double end_slack = 1e-9;
/// Edges more nearly parallel than this (sine) do not cross [-].
constexpr double parallel = 1e-3;

enum class Kind : std::uint8_t { corner = 4, point = 5, edges = 6 };  ///< 1 to 3 are those of two blocks

std::uint64_t feature_of(Kind kind, std::size_t of_block, std::int32_t of_ground) {
    return static_cast<std::uint64_t>(kind) << 60 | static_cast<std::uint64_t>(of_block) << 32 |
           static_cast<std::uint32_t>(of_ground);
}
Kind kind_of(std::uint64_t feature) { return static_cast<Kind>(feature >> 60); }
std::int32_t ground_part(std::uint64_t feature) { return static_cast<std::int32_t>(feature & 0xffffffffU); }

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

/// Distance from the nearest corner within which others count as touching: that of two blocks [m].
double touching(const LocalBlock& block, double gap, double reach) {
    const double widest = 0.1 * block.size;
    return std::max(std::min(2 * std::abs(gap) + 1e-4 * block.size, widest), std::min(reach, widest));
}

/// Contact points of one pair in the frame of the ground.
class Meeting {
 public:
    Meeting(const OnGround& scene, const LocalBlock& block, double reach, const NearGround& near)
        : scene_(scene),
          block_(block),
          reach_(reach),
          near_(near),
          mesh_(scene.ground->field.mesh()),
          features_(scene.ground->features),
          misses_(block.vertices.size()) {}

    void find(const BlockContactHistory& history, std::size_t begin, std::size_t end,
              std::vector<BlockContact>& found) {
        first_ = found.size();
        found_ = &found;
        add_corners();
        add_points(history, begin, end);
        add_edges();
        if (scene_.needs_areas) {
            share_areas();
        }
        const auto own = std::span(found).subspan(first_);
        std::sort(own.begin(), own.end(),
                  [](const BlockContact& p, const BlockContact& q) { return p.feature < q.feature; });
        take_over(history, begin, end, own);
    }

 private:
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

    Floor floor_of(std::int32_t triangle) const {
        const Vec3& n = features_.normal(triangle);
        Floor floor{n, dot(n, mesh_.corner(triangle, 0)), 0, false};
        const double lowest = block_.lowest_along(n) - floor.offset;
        // A block whose middle is below the plane is on the other side of it.
        floor.is_met = lowest <= reach_ && floor.gap(block_.centre) > 0;
        floor.highest = std::min(reach_, lowest + touching(block_, lowest, reach_));
        return floor;
    }

    void add(Kind kind, std::size_t of_block, std::int32_t of_ground, const Vec3& normal, const Vec3& on_ground,
             const Vec3& on_block) {
        const auto world = [this](const Vec3& x) { return scene_.position + scene_.turn * x; };
        const Vec3 n = scene_.turn * normal, g = world(on_ground), b = world(on_block);
        const bool first = scene_.is_ground_first;
        BlockContact contact{scene_.pair.a, scene_.pair.b, feature_of(kind, of_block, of_ground), 0, first ? n : -n,
                             first ? g : b, first ? b : g, dot(normal, on_block - on_ground),     0, -1};
        found_->push_back(contact);
    }

    bool has_corner(std::size_t v, const Vec3& normal) const {
        const std::uint64_t name = feature_of(Kind::corner, v, 0) >> 32;
        const Vec3 n = (scene_.is_ground_first ? 1.0 : -1.0) * (scene_.turn * normal);
        return std::any_of(found_->begin() + static_cast<std::ptrdiff_t>(first_), found_->end(),
                           [&](const BlockContact& c) {
                               return c.feature >> 32 == name &&
                                      norm_squared(c.normal - n) < geometry::flat_turn * geometry::flat_turn;
                           });
    }
    void add_corner(std::size_t v, std::int32_t triangle, const Floor& floor) {
        if (!has_corner(v, floor.normal)) {
            const Vec3& x = block_.vertices[v];
            add(Kind::corner, v, triangle, floor.normal, x - floor.gap(x) * floor.normal, x);
        }
    }
    /// The other sides of the clefts around a triangle, which push the corner as well.
    void add_clefts(std::size_t v, std::int32_t triangle) {
        for (const std::int32_t e : features_.edges_of(triangle)) {
            if (features_.edge(e).kind == EdgeKind::cleft) {
                const std::int32_t other = features_.across(e, triangle);
                const Floor floor = floor_of(other);
                if (floor.is_met && floor.gap(block_.vertices[v]) <= floor.highest) {
                    add_corner(v, other, floor);
                }
            }
        }
    }

    Box box_of(std::int32_t triangle) const {
        Box box{mesh_.corner(triangle, 0), mesh_.corner(triangle, 0)};
        box.add(mesh_.corner(triangle, 1));
        box.add(mesh_.corner(triangle, 2));
        return box;
    }

    void add_corners() {
        for (const std::int32_t t : near_.triangles) {
            if (!box_of(t).meets(block_.box, reach_)) {
                continue;
            }
            const Floor floor = floor_of(t);
            for (std::size_t v = 0; floor.is_met && v < block_.vertices.size(); ++v) {
                const Vec3& x = block_.vertices[v];
                const double gap = floor.gap(x);
                if (gap > floor.highest) {
                    continue;
                }
                if (features_.is_in_cell(mesh_, t, x)) {
                    misses_[v].has_cell = true;
                    add_corner(v, t, floor);
                    add_clefts(v, t);
                } else if (gap < 0) {
                    remember_miss(v, t, gap);
                }
            }
        }
        for (std::size_t v = 0; v < misses_.size(); ++v) {
            if (!misses_[v].has_cell && misses_[v].triangle >= 0) {
                add_corner(v, misses_[v].triangle, floor_of(misses_[v].triangle));
            }
        }
    }
    /// A corner below a point where cells leave a gap stays with the nearest triangle.
    void remember_miss(std::size_t v, std::int32_t t, double gap) {
        const Vec3& x = block_.vertices[v];
        const auto on = geometry::nearest_on_triangle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), x);
        const double squared = norm_squared(x - on.point);
        Miss& miss = misses_[v];
        const bool is_near = squared <= 4 * gap * gap && norm(on.point - block_.centre) <= block_.size + reach_;
        if (is_near && (miss.triangle < 0 || squared < miss.squared)) {
            miss.squared = squared;
            miss.triangle = t;
        }
    }

    /// Whether the surface around a point falls away from a plane through it, within steep_turn.
    bool falls_away(std::int32_t point, const Vec3& down) const {
        static const double lean = -std::sin(geometry::steep_turn);
        const Vec3& x = mesh_.points[at(point)];
        for (const std::int32_t e : features_.fan(point)) {
            const SurfaceEdge& edge = features_.edge(e);
            const Vec3 out = mesh_.points[at(edge.from == point ? edge.to : edge.from)] - x;
            if (dot(down, out) < lean * norm(out)) {
                return false;
            }
        }
        return true;
    }
    /// Whether the foot of x lies on a face.
    bool is_over(std::size_t face, const Vec3& x) const {
        const Vec3& n = block_.normals[face];
        const auto loop = block_.topology.loop(static_cast<std::int32_t>(face));
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 &p = block_.vertices[at(loop[k])], &q = block_.vertices[at(loop[(k + 1) % loop.size()])];
            const Vec3 across = cross(q - p, n);  // out of the face, as long as the edge
            if (dot(across, x - p) > end_slack * norm_squared(q - p)) {
                return false;
            }
        }
        return true;
    }
    void add_points(const BlockContactHistory& history, std::size_t begin, std::size_t end) {
        for (const std::int32_t p : near_.points) {
            const Vec3& x = mesh_.points[at(p)];
            if (!Box{x, x}.meets(block_.box, reach_)) {
                continue;
            }
            std::size_t best = block_.normals.size();
            double gap = 0;
            for (std::size_t f = 0; f < block_.normals.size(); ++f) {
                const Vec3& n = block_.normals[f];
                const Vec3& on_face = block_.vertices[at(block_.topology.loop(static_cast<std::int32_t>(f))[0])];
                const double here = dot(n, x - on_face);
                const bool may = here <= reach_ && here > dot(n, block_.centre - on_face) &&
                                 dot(n, features_.facing(p)) < 0 && is_over(f, x) && falls_away(p, n);
                if (!may) {
                    continue;
                }
                const bool was_met = is_remembered(history, begin, end, feature_of(Kind::point, f, p));
                if (was_met || best == block_.normals.size() || here > gap) {
                    best = f;
                    gap = here;
                }
                if (was_met) {
                    break;
                }
            }
            if (best < block_.normals.size()) {
                const Vec3& n = block_.normals[best];
                add(Kind::point, best, p, -n, x, x - gap * n);
            }
        }
    }
    static bool is_remembered(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                              std::uint64_t feature) {
        for (std::size_t row = begin; row < end; ++row) {
            if (history.feature[row] == feature) {
                return true;
            }
        }
        return false;
    }

    void add_edges() {
        for (const std::int32_t e : near_.edges) {
            const SurfaceEdge& edge = features_.edge(e);
            Box box{mesh_.points[at(edge.from)], mesh_.points[at(edge.from)]};
            box.add(mesh_.points[at(edge.to)]);
            if (!box.meets(block_.box, reach_)) {
                continue;
            }
            for (std::size_t i = 0; i < block_.topology.edges.size(); ++i) {
                add_crossing(e, edge, i);
            }
        }
    }
    /// Least cosine of the angle to the middle of an arc of normals that still counts as within it.
    static double least_cosine(double half_cosine) {
        static const double c = std::cos(geometry::steep_turn), s = std::sin(geometry::steep_turn);
        return half_cosine * c - std::sqrt(std::max(0.0, 1 - half_cosine * half_cosine)) * s;
    }
    void add_crossing(std::int32_t e, const SurfaceEdge& edge, std::size_t i) {
        const contact::HullEdge& other = block_.topology.edges[i];
        const Vec3 &p = mesh_.points[at(edge.from)], &q = block_.vertices[at(other.from)];
        const Vec3 along = mesh_.points[at(edge.to)] - p, across = block_.vertices[at(other.to)] - q;
        const Vec3 product = cross(along, across);
        const double square = norm_squared(product);
        if (square <= parallel * parallel * norm_squared(along) * norm_squared(across)) {
            return;
        }
        Vec3 n = product / std::sqrt(square);
        n = dot(n, edge.mean) < 0 ? -n : n;
        const double gap = dot(n, q - p);
        if (gap > reach_ || dot(n, block_.centre - p) <= 0 || dot(n, edge.mean) < least_cosine(edge.half_cosine)) {
            return;
        }
        const Vec3 &left = block_.normals[at(other.left)], sum = left + block_.normals[at(other.right)];
        const Vec3 mean = normalized(sum);
        if (-dot(n, mean) < least_cosine(dot(mean, left))) {
            return;
        }
        const double t = dot(cross(q - p, across), product) / square, r = dot(cross(q - p, along), product) / square;
        const auto is_on = [](double share) { return share >= -end_slack && share <= 1 + end_slack; };
        if (is_on(t) && is_on(r)) {
            add(Kind::edges, i, e, n, p + t * along, q + r * across);
        }
    }

    /// Gives corners the area that they would have on the plane across their mean normal.
    void share_areas() {
        Vec3 normal{};
        const auto own = std::span(*found_).subspan(first_);
        for (const BlockContact& c : own) {
            normal += kind_of(c.feature) == Kind::corner ? c.normal : Vec3{};
        }
        if (!(norm_squared(normal) > 0)) {
            return;
        }
        normal = normalized((scene_.is_ground_first ? 1.0 : -1.0) * transpose_times(scene_.turn, normal));
        const double lowest = block_.lowest_along(normal);
        const contact::PlacedHull plane{nullptr, {}, {&normal, 1}, block_.centre, lowest};
        contact::PlaneContacts points;
        find_plane_contacts(plane, block_.hull(), {normal, 0, {}, false}, touching(block_, 0, reach_), points);
        for (BlockContact& c : own) {
            const Vec3& x = block_.vertices[at(static_cast<std::int32_t>(c.feature >> 32 & 0xfffffffU))];
            for (int k = 0; kind_of(c.feature) == Kind::corner && k < points.count; ++k) {
                c.area = points.contacts[at(k)].on_b == x ? points.contacts[at(k)].area : c.area;
            }
        }
    }

    /// Whether the surface goes on from one triangle, or edge, to the other: they share a point.
    bool are_neighbours(Kind kind, std::int32_t x, std::int32_t y) const {
        const auto points = [&](std::int32_t i) {
            const auto ends = [&](std::int32_t e) {
                return std::array{features_.edge(e).from, features_.edge(e).to, features_.edge(e).to};
            };
            return kind == Kind::corner ? mesh_.corners[at(i)] : ends(i);
        };
        const auto a = points(x), b = points(y);
        return std::any_of(a.begin(), a.end(),
                           [&](std::int32_t p) { return std::find(b.begin(), b.end(), p) != b.end(); });
    }
    /// Finds the rows of the history. What has come to the next triangle or edge goes on with the spring of the last.
    void take_over(const BlockContactHistory& history, std::size_t begin, std::size_t end,
                   std::span<BlockContact> own) const {
        std::vector<std::uint8_t> is_taken(end - begin, 0);
        for (BlockContact& c : own) {
            for (std::size_t row = begin; row < end; ++row) {
                if (history.feature[row] == c.feature) {
                    c.old = static_cast<std::int64_t>(row);
                    is_taken[row - begin] = 1;
                }
            }
        }
        for (BlockContact& c : own) {
            const Kind kind = kind_of(c.feature);
            for (std::size_t row = begin; row < end && c.old < 0 && kind != Kind::point; ++row) {
                const std::uint64_t before = history.feature[row];
                if (is_taken[row - begin] == 0 && before >> 32 == c.feature >> 32 &&
                    are_neighbours(kind, ground_part(before), ground_part(c.feature))) {
                    c.old = static_cast<std::int64_t>(row);
                    is_taken[row - begin] = 1;
                }
            }
        }
    }

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

template <class T>
void make_unique(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Looks for what is near anew where the block may have left the ball.
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
            const SurfaceEdge& edge = features.edge(e);
            if (edge.kind == EdgeKind::ridge) {
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

std::int32_t add_ground(BlockSystem& system, geometry::TriangleField surface) {
    Shape shape;
    for (const Vec3& x : surface.mesh().points) {
        shape.circumradius = std::max(shape.circumradius, norm(x));
    }
    shape.ground = std::make_shared<const Ground>(std::move(surface));
    system.shapes.push_back(std::move(shape));
    return static_cast<std::int32_t>(system.shapes.size()) - 1;
}

void find_on_ground(const OnGround& scene, const BlockContactHistory& history, std::size_t begin, std::size_t end,
                    double reach, NearGround& near, std::vector<BlockContact>& found) {
    const Vec3 centre = transpose_times(scene.turn, scene.block.centre - scene.position);
    look_around(*scene.ground, centre, radius_of(scene.block) + reach, near);
    if (!near.triangles.empty()) {
        const LocalBlock block(scene, centre);
        Meeting(scene, block, reach, near).find(history, begin, end, found);
    }
}

}  // namespace riprap::solid::affine
