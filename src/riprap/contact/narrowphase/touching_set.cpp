// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/touching_set.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::contact {

namespace {

/// Convex hull in the plane by Andrew's monotone chain; collinear points are dropped.
void make_convex(TouchingSet& set) {
    std::array<int, most_touching> order;
    for (int i = 0; i < set.count; ++i) {
        order[at(i)] = i;
    }
    std::sort(order.begin(), order.begin() + set.count, [&](int i, int j) {
        const PlanePoint &p = set.point[at(i)], &q = set.point[at(j)];
        return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    std::array<int, 2 * most_touching> chain;
    int count = 0;
    const auto extend = [&](int i, int least) {
        while (count >= least + 2) {
            const PlanePoint &p = set.point[at(chain[at(count - 2)])], &q = set.point[at(chain[at(count - 1)])];
            const PlanePoint u = q - p, v = set.point[at(i)] - q;
            if (cross(u, v) > 1e-9 * std::sqrt(dot(u, u) * dot(v, v))) {
                break;
            }
            --count;
        }
        chain[at(count++)] = i;
    };
    for (int k = 0; k < set.count; ++k) {
        extend(order[at(k)], 0);
    }
    const int upper = count - 1;
    for (int k = set.count - 2; k >= 0; --k) {
        extend(order[at(k)], upper);
    }
    TouchingSet hull;
    hull.count = count - 1;
    for (int k = 0; k < hull.count; ++k) {
        hull.vertex[at(k)] = set.vertex[at(chain[at(k)])];
        hull.point[at(k)] = set.point[at(chain[at(k)])];
    }
    set.count = hull.count;
    std::copy_n(hull.vertex.begin(), hull.count, set.vertex.begin());
    std::copy_n(hull.point.begin(), hull.count, set.point.begin());
}

/// A corner under way through the clipping. The side that leaves it lies on an edge of the subject or of the clip
/// polygon: `side` >= 0 counts edges of the subject, -1 - k is edge k of the clip.
struct Corner {
    PlanePoint point;
    std::int32_t subject_vertex;  ///< -1 = none
    std::int32_t clip_vertex;     ///< -1 = none
    std::int32_t side;
    std::int32_t cut_side{0}, cut_clip{-1};  ///< crossing: edge of the subject, edge of the clip
};

/// Where the side that leaves `from` meets clip edge k.
Corner meet(const Corner& from, const PlanePoint& point, int k, int clip_count) {
    Corner corner{point, -1, -1, 0, 0, -1};
    if (from.side >= 0) {
        corner.cut_side = from.side;
        corner.cut_clip = k;
    } else {
        const int other = -1 - from.side;  // two edges of the clip meet in the corner between them
        corner.clip_vertex = (other + 1) % clip_count == k ? k : (k + 1) % clip_count;
    }
    return corner;
}

/// The height of points above side k of a polygon, positive inside.
class Side {
 public:
    Side(const TouchingSet& polygon, int k)
        : from_(polygon.point[at(k)]),
          along_(polygon.point[at((k + 1) % polygon.count)] - from_),
          length_(std::sqrt(dot(along_, along_))) {}
    double operator()(const PlanePoint& q) const { return cross(along_, q - from_) / length_; }

 private:
    PlanePoint from_, along_;
    double length_;
};

/// Sutherland and Hodgman's clipping of a point, segment or polygon by a convex polygon [Sutherland1974].
int clip(const TouchingSet& subject, const TouchingSet& by, double slack, std::array<Corner, most_corners>& corners) {
    int count = subject.count;
    for (int i = 0; i < count; ++i) {
        corners[at(i)] = {subject.point[at(i)], i, -1, i, 0, -1};
    }
    for (int k = 0; k < by.count && count > 0; ++k) {
        const Side height(by, k);
        std::array<Corner, most_corners> kept;
        int kept_count = 0;
        const int sides = count > 2 ? count : count - 1;  // a segment has one side, a point none
        for (int i = 0; i < count && kept_count < most_corners - 1; ++i) {
            const Corner& here = corners[at(i)];
            const Corner& next = corners[at((i + 1) % count)];
            const double h = height(here.point), h_next = height(next.point);
            const bool leaves = i < sides && h_next < -slack;
            if (h >= -slack) {
                kept[at(kept_count++)] = here;
                if (leaves && h <= slack) {
                    kept[at(kept_count - 1)].side = -1 - k;  // on the edge: the boundary goes on along it
                }
            }
            if ((leaves && h > slack) || (i < sides && h < -slack && h_next > slack)) {
                Corner cut = meet(here, here.point + (h / (h - h_next)) * (next.point - here.point), k, by.count);
                cut.side = leaves ? -1 - k : here.side;
                kept[at(kept_count++)] = cut;
            }
        }
        count = kept_count;
        std::copy_n(kept.begin(), count, corners.begin());
    }
    return count;
}

}  // namespace

PlaneAxes axes_across(const Vec3& normal, const Vec3& origin) {
    const Vec3 other = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 x = normalized(riprap::cross(other, normal));
    return {origin, x, riprap::cross(normal, x)};
}

std::size_t facing_face(const PlacedHull& hull, const Vec3& outward) {
    std::size_t best = 0;
    for (std::size_t f = 1; f < hull.normals.size(); ++f) {
        best = riprap::dot(hull.normals[f], outward) > riprap::dot(hull.normals[best], outward) ? f : best;
    }
    return best;
}

TouchingSet touching_set(const PlacedHull& hull, const Vec3& outward, const Touch& touch, const PlaneAxes& axes) {
    const double most = riprap::dot(outward, hull.vertices[at(support_vertex(hull, outward))]);
    const auto face = touch.of_face > touch.of_corner
                          ? hull.topology->loop(static_cast<std::int32_t>(facing_face(hull, outward)))
                          : std::span<const std::int32_t>{};
    const auto touches = [&](std::size_t v) {
        const double below = most - riprap::dot(outward, hull.vertices[v]);
        return below <= touch.of_corner || (below <= touch.of_face && std::ranges::find(face, v) != face.end());
    };
    TouchingSet set;
    for (std::size_t v = 0; v < hull.vertices.size() && set.count < most_touching; ++v) {
        if (touches(v)) {
            set.vertex[at(set.count)] = static_cast<std::int32_t>(v);
            set.point[at(set.count)] = axes.project(hull.vertices[v]);
            ++set.count;
        }
    }
    set.touching = set.count;
    if (set.count > 1) {
        make_convex(set);
    }
    return set;
}

bool has_corner_inside(const TouchingSet& subject, const TouchingSet& by, double slack) {
    std::uint64_t inside = (std::uint64_t{1} << subject.count) - 1;
    for (int k = 0; k < by.count && inside != 0; ++k) {
        const Side height(by, k);
        for (int i = 0; i < subject.count; ++i) {
            if (!(height(subject.point[at(i)]) >= -slack)) {
                inside &= ~(std::uint64_t{1} << i);
            }
        }
    }
    return inside != 0;
}

CommonPolygon intersect(const TouchingSet& a, const TouchingSet& b, double slack) {
    const bool is_a_subject = b.count > 2;
    const TouchingSet &subject = is_a_subject ? a : b, &by = is_a_subject ? b : a;
    std::array<Corner, most_corners> corners;
    CommonPolygon polygon;
    polygon.count = clip(subject, by, slack, corners);
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& c = corners[at(i)];
        std::int32_t s_from = c.subject_vertex, s_to = c.subject_vertex, k_from = c.clip_vertex, k_to = c.clip_vertex;
        if (c.cut_clip >= 0) {
            s_from = c.cut_side;
            s_to = (c.cut_side + 1) % subject.count;
            k_from = c.cut_clip;
            k_to = (c.cut_clip + 1) % by.count;
        }
        polygon.corner[at(i)] = is_a_subject ? CommonCorner{c.point, s_from, s_to, k_from, k_to}
                                             : CommonCorner{c.point, k_from, k_to, s_from, s_to};
    }
    return polygon;
}

}  // namespace riprap::contact
