// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/planar/planar_cut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "riprap/core/index.hpp"

namespace riprap::geometry {

namespace {

/// Points, merged where they are nearer than `snap`.
class PointSet {
 public:
    explicit PointSet(double snap) : snap_(snap) {}

    std::int32_t add(const Vec2& p) {
        const auto i = static_cast<std::int64_t>(std::floor(p.x / (2 * snap_)));
        const auto j = static_cast<std::int64_t>(std::floor(p.y / (2 * snap_)));
        for (std::int64_t di = -1; di <= 1; ++di) {
            for (std::int64_t dj = -1; dj <= 1; ++dj) {
                const auto [begin, end] = cells_.equal_range({i + di, j + dj});
                for (auto it = begin; it != end; ++it) {
                    if (norm(points[at(it->second)] - p) <= snap_) {
                        return it->second;
                    }
                }
            }
        }
        points.push_back(p);
        const auto id = static_cast<std::int32_t>(points.size()) - 1;
        cells_.insert({{i, j}, id});
        return id;
    }
    std::vector<Vec2> points;

 private:
    double snap_;
    std::multimap<std::pair<std::int64_t, std::int64_t>, std::int32_t> cells_;
};

struct Piece {
    std::int32_t a, b;  ///< points, a < b
    std::int32_t type;
};

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 line = b - a;
    const double t = std::clamp(dot(p - a, line) / dot(line, line), 0.0, 1.0);
    return norm(p - (a + t * line));
}

/// Adds the points in which two joints cross or meet to both lists of cuts.
void add_meeting_points(const PlanarJoint& p, const PlanarJoint& q, double snap, std::vector<Vec2>& of_p,
                        std::vector<Vec2>& of_q) {
    for (const Vec2& end : {q.begin, q.end}) {
        if (distance_to_segment(end, p.begin, p.end) <= snap) {
            of_p.push_back(end);
        }
    }
    for (const Vec2& end : {p.begin, p.end}) {
        if (distance_to_segment(end, q.begin, q.end) <= snap) {
            of_q.push_back(end);
        }
    }
    const Vec2 u = p.end - p.begin, v = q.end - q.begin;
    const double turn = cross(u, v);
    if (std::abs(turn) <= 1e-12 * norm(u) * norm(v)) {
        return;  // parallel: their ends are all there is
    }
    const double s = cross(q.begin - p.begin, v) / turn, t = cross(q.begin - p.begin, u) / turn;
    if (s > 0 && s < 1 && t > 0 && t < 1) {
        const Vec2 point = p.begin + s * u;
        of_p.push_back(point);
        of_q.push_back(point);
    }
}

/// Splits the joints at all points in common.
std::vector<Piece> split(std::span<const PlanarJoint> joints, double snap, PointSet& points,
                         std::int32_t& crossing_count) {
    std::vector<std::vector<Vec2>> cuts(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        cuts[i] = {joints[i].begin, joints[i].end};
        const auto [left_i, right_i] = std::minmax(joints[i].begin.x, joints[i].end.x);
        for (std::size_t j = 0; j < i; ++j) {
            const auto [left, right] = std::minmax(joints[j].begin.x, joints[j].end.x);
            if (left <= right_i + snap && left_i <= right + snap) {
                add_meeting_points(joints[i], joints[j], snap, cuts[i], cuts[j]);
            }
        }
    }
    std::vector<Piece> pieces;
    std::map<std::int32_t, int> joints_at;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const Vec2 line = joints[i].end - joints[i].begin;
        std::vector<std::pair<double, std::int32_t>> order;
        for (const Vec2& point : cuts[i]) {
            order.emplace_back(dot(point - joints[i].begin, line), points.add(point));
        }
        std::sort(order.begin(), order.end());
        std::vector<std::int32_t> through;
        for (const auto& [along, id] : order) {
            if (through.empty() || through.back() != id) {
                through.push_back(id);
                ++joints_at[id];
            }
        }
        for (std::size_t k = 0; k + 1 < through.size(); ++k) {
            pieces.push_back(
                {std::min(through[k], through[k + 1]), std::max(through[k], through[k + 1]), joints[i].type});
        }
    }
    crossing_count = static_cast<std::int32_t>(
        std::count_if(joints_at.begin(), joints_at.end(), [](const auto& entry) { return entry.second > 1; }));
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Piece& x, const Piece& y) { return x.a < y.a || (x.a == y.a && x.b < y.b); });
    pieces.erase(std::unique(pieces.begin(), pieces.end(),
                             [](const Piece& x, const Piece& y) { return x.a == y.a && x.b == y.b; }),
                 pieces.end());
    return pieces;
}

/// Removes pieces with a free end until none is left. @returns their number
std::int32_t remove_dead_ends(std::vector<Piece>& pieces, std::size_t point_count) {
    std::vector<std::vector<std::int32_t>> around(point_count);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        around[at(pieces[k].a)].push_back(static_cast<std::int32_t>(k));
        around[at(pieces[k].b)].push_back(static_cast<std::int32_t>(k));
    }
    std::vector<std::int32_t> degree(point_count, 0), free_ends;
    for (std::size_t p = 0; p < point_count; ++p) {
        degree[p] = static_cast<std::int32_t>(around[p].size());
        if (degree[p] == 1) {
            free_ends.push_back(static_cast<std::int32_t>(p));
        }
    }
    std::vector<std::uint8_t> is_removed(pieces.size(), 0);
    while (!free_ends.empty()) {
        const std::int32_t end = free_ends.back();
        free_ends.pop_back();
        for (const std::int32_t k : around[at(end)]) {
            if (is_removed[at(k)] == 0) {
                is_removed[at(k)] = 1;
                const std::int32_t other = pieces[at(k)].a == end ? pieces[at(k)].b : pieces[at(k)].a;
                if (--degree[at(other)] == 1) {
                    free_ends.push_back(other);
                }
            }
        }
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (is_removed[k] == 0) {
            pieces[kept++] = pieces[k];
        }
    }
    const auto removed = static_cast<std::int32_t>(pieces.size() - kept);
    pieces.resize(kept);
    return removed;
}

/// Directed pieces: 2 k runs from a to b of piece k, 2 k + 1 back; `next` goes on round the region to the left.
struct Walks {
    std::vector<std::int32_t> next;
    std::vector<std::int32_t> from;
};

Walks link(const std::vector<Piece>& pieces, const std::vector<Vec2>& points) {
    Walks walks;
    const auto count = static_cast<std::int32_t>(2 * pieces.size());
    std::vector<std::vector<std::pair<double, std::int32_t>>> leaving(points.size());
    walks.from.resize(at(count));
    walks.next.resize(at(count));
    for (std::int32_t e = 0; e < count; ++e) {
        const Piece& piece = pieces[at(e / 2)];
        const std::int32_t from = e % 2 == 0 ? piece.a : piece.b, to = e % 2 == 0 ? piece.b : piece.a;
        const Vec2 line = points[at(to)] - points[at(from)];
        walks.from[at(e)] = from;
        leaving[at(from)].emplace_back(std::atan2(line.y, line.x), e);
    }
    for (auto& fan : leaving) {
        std::sort(fan.begin(), fan.end());
        for (std::size_t k = 0; k < fan.size(); ++k) {
            // arriving against fan[k], the region to the left goes on with the next one clockwise
            walks.next[at(fan[k].second ^ 1)] = fan[(k + fan.size() - 1) % fan.size()].second;
        }
    }
    return walks;
}

struct Face {
    Polygon corners;
    std::vector<std::int32_t> types;
    std::int32_t net{-1};  ///< of connected joints, named by its least point
};

/// The connected net that each point belongs to, named by its least point.
std::vector<std::int32_t> nets_of(const std::vector<Piece>& pieces, std::size_t point_count) {
    std::vector<std::int32_t> net(point_count);
    std::iota(net.begin(), net.end(), 0);
    const auto root = [&net](std::int32_t i) {
        while (net[at(i)] != i) {
            i = net[at(i)] = net[at(net[at(i)])];
        }
        return i;
    };
    for (const Piece& piece : pieces) {
        const std::int32_t a = root(piece.a), b = root(piece.b);
        net[at(std::max(a, b))] = std::min(a, b);
    }
    for (std::size_t i = 0; i < point_count; ++i) {
        net[i] = root(static_cast<std::int32_t>(i));
    }
    return net;
}

/// Removes the blocks of nets inside a block of another net. @returns the number of such nets
std::int32_t remove_loose_loops(std::vector<Face>& faces, const std::vector<Vec2>& points) {
    std::vector<std::int32_t> nets;
    for (const Face& face : faces) {
        nets.push_back(face.net);
    }
    std::sort(nets.begin(), nets.end());
    nets.erase(std::unique(nets.begin(), nets.end()), nets.end());
    if (nets.size() < 2) {
        return 0;
    }
    std::vector<std::int32_t> loose;
    for (const std::int32_t net : nets) {
        const bool is_inner = std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
            return face.net != net && is_inside(face.corners, points[at(net)]);
        });
        if (is_inner) {
            loose.push_back(net);
        }
    }
    std::erase_if(faces,
                  [&loose](const Face& face) { return std::binary_search(loose.begin(), loose.end(), face.net); });
    return static_cast<std::int32_t>(loose.size());
}

/// The walk that begins with `start`, without corners at which it goes straight on.
Face walk_round(const Walks& walks, const std::vector<Piece>& pieces, const std::vector<Vec2>& points,
                std::int32_t start, std::vector<std::uint8_t>& is_walked) {
    Polygon corners;
    std::vector<std::int32_t> types;
    for (std::int32_t e = start; !is_walked[at(e)]; e = walks.next[at(e)]) {
        is_walked[at(e)] = 1;
        corners.push_back(points[at(walks.from[at(e)])]);
        types.push_back(pieces[at(e / 2)].type);
    }
    Face face;
    const std::size_t n = corners.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 in = corners[k] - corners[(k + n - 1) % n], out = corners[(k + 1) % n] - corners[k];
        if (std::abs(cross(in, out)) > 1e-9 * norm(in) * norm(out) || dot(in, out) < 0) {
            face.corners.push_back(corners[k]);
            face.types.push_back(types[k]);
        }
    }
    return face;
}

double extent_of(std::span<const PlanarJoint> joints) {
    double extent = 0;
    for (const PlanarJoint& joint : joints) {
        for (const Vec2& p : {joint.begin - joints.front().begin, joint.end - joints.front().begin}) {
            extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
        }
    }
    return extent;
}

}  // namespace

Outcome<PlanarBlocks> cut_by_lines(std::span<const PlanarJoint> joints, const PlanarCutSettings& settings) {
    for (std::size_t k = 0; k < joints.size(); ++k) {
        const PlanarJoint& joint = joints[k];
        if (!std::isfinite(joint.begin.x + joint.begin.y + joint.end.x + joint.end.y)) {
            return GeometryProblem{fmt::format("joint {} has a coordinate that is not finite", k), {}};
        }
    }
    if (joints.empty()) {
        return GeometryProblem{"there are no joints", "joints that enclose a region"};
    }
    const double snap = settings.snap > 0 ? settings.snap : 1e-9 * extent_of(joints);
    PointSet points(snap);
    PlanarBlocks result;
    std::vector<Piece> pieces = split(joints, snap, points, result.crossings);
    result.dead_ends = remove_dead_ends(pieces, points.points.size());
    const Walks walks = link(pieces, points.points);
    const std::vector<std::int32_t> nets = nets_of(pieces, points.points.size());
    std::vector<std::uint8_t> is_walked(walks.next.size(), 0);
    std::vector<Face> faces;
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(walks.next.size()); ++e) {
        if (!is_walked[at(e)]) {
            Face face = walk_round(walks, pieces, points.points, e, is_walked);
            face.net = nets[at(walks.from[at(e)])];
            if (moments_of(face.corners).area > 0) {  // else the outside of a net
                faces.push_back(std::move(face));
            }
        }
    }
    result.loose_loops = remove_loose_loops(faces, points.points);
    std::vector<GeometryProblem> problems;
    for (Face& face : faces) {
        if (const Outcome<Polygon> polygon = make_polygon(face.corners, settings.sliver); !polygon) {
            const Vec2 center = moments_of(face.corners).centroid;
            problems.push_back({fmt::format("the block about ({:.6g}, {:.6g}): {}", center.x, center.y,
                                            polygon.problems().front().message),
                                "joints farther apart, or a larger snap"});
        }
        result.blocks.push_back(std::move(face.corners));
        result.edge_types.push_back(std::move(face.types));
    }
    if (!problems.empty()) {
        return problems;
    }
    if (result.blocks.empty()) {
        return GeometryProblem{"the joints enclose no region: they are open, or end before they meet",
                               "joints that cross or meet within the snap distance"};
    }
    return result;
}

}  // namespace riprap::geometry
