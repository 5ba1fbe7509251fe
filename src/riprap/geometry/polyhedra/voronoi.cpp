// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/voronoi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <voro++/voro++.hh>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::geometry {

namespace {

struct Box {
    Vec3 low, high;
};

Box bounding_box(const Polyhedron& region) {
    Box box{region.vertices[0], region.vertices[0]};
    for (const Vec3& x : region.vertices) {
        box.low = min(box.low, x);
        box.high = max(box.high, x);
    }
    return box;
}

std::vector<Plane> planes_of(const Polyhedron& region) {
    std::vector<Plane> planes;
    planes.reserve(region.faces.size());
    for (const auto& face : region.faces) {
        planes.push_back(face_plane(region.vertices, face));
    }
    return planes;
}

bool is_inside(std::span<const Plane> planes, const Vec3& x, double tolerance) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Plane& p) { return dot(p.normal, x) <= p.offset + tolerance; });
}

/// For each point the points whose cells share a face with its own in the bounding box of the region, nearest first.
/// The neighbours in any convex region inside that box are among them.
std::vector<std::vector<int>> find_neighbours(const Box& box, std::span<const Vec3> points) {
    const Vec3 margin = 1e-3 * (box.high - box.low);  // voro++ drops points on the upper sides of its box
    const Vec3 low = box.low - margin, high = box.high + margin, extent = high - low;
    constexpr double points_per_cell = 5.0;  // what voro++ is fastest with
    const double cell =
        std::cbrt(extent.x * extent.y * extent.z * points_per_cell / static_cast<double>(points.size()));
    const auto cells = [&](double length) { return std::clamp(static_cast<int>(length / cell), 1, 4096); };
    voro::container container(low.x, high.x, low.y, high.y, low.z, high.z, cells(extent.x), cells(extent.y),
                              cells(extent.z), false, false, false, 8);
    for (std::size_t i = 0; i < points.size(); ++i) {
        container.put(static_cast<int>(i), points[i].x, points[i].y, points[i].z);
    }
    std::vector<std::vector<int>> neighbours(points.size());
    voro::voronoicell_neighbor voro_cell;
    voro::c_loop_all loop(container);
    if (loop.start()) {
        do {
            if (!container.compute_cell(voro_cell, loop)) {
                continue;
            }
            const auto i = static_cast<std::size_t>(loop.pid());
            std::vector<int>& list = neighbours[i];
            voro_cell.neighbors(list);
            std::erase_if(list, [](int other) { return other < 0; });  // sides of the box
            std::sort(list.begin(), list.end(), [&](int a, int b) {
                const double to_a = norm_squared(points[static_cast<std::size_t>(a)] - points[i]);
                const double to_b = norm_squared(points[static_cast<std::size_t>(b)] - points[i]);
                return to_a != to_b ? to_a < to_b : a < b;
            });
        } while (loop.inc());
    }
    return neighbours;
}

/// Two points at the very same place, which voro++ passes over in silence; -1 if there are none.
std::pair<int, int> find_equal_points(std::span<const Vec3> points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto coordinates = [&](int i) {
        const Vec3& x = points[static_cast<std::size_t>(i)];
        return std::array{x.x, x.y, x.z};
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        const auto at_a = coordinates(a), at_b = coordinates(b);
        return at_a != at_b ? at_a < at_b : a < b;
    });
    const auto equal =
        std::adjacent_find(order.begin(), order.end(), [&](int a, int b) { return coordinates(a) == coordinates(b); });
    return equal == order.end() ? std::pair{-1, -1} : std::pair{equal[0], equal[1]};
}

std::vector<GeometryProblem> check(const Polyhedron& region, std::int64_t count, double gap) {
    std::vector<GeometryProblem> problems;
    if (region.faces.size() < 4) {
        problems.push_back({"the region to divide is empty", "a closed convex polyhedron"});
    }
    if (count < 1 || count > voronoi_maximum_blocks) {
        problems.push_back({fmt::format("{} Voronoi blocks", count), fmt::format("1 to {}", voronoi_maximum_blocks)});
    }
    if (!std::isfinite(gap) || gap < 0.0) {
        problems.push_back({fmt::format("gap {:g} m", gap), "a finite width, at least 0"});
    }
    return problems;
}

}  // namespace

std::vector<Vec3> random_points(const Polyhedron& region, std::int64_t count, std::uint64_t seed) {
    const Box box = bounding_box(region);
    const Vec3 extent = box.high - box.low;
    const std::vector<Plane> planes = planes_of(region);
    // A convex body fills at least 1/6 of the box aligned with some frame but can fill arbitrarily little of this one.
    constexpr std::uint64_t attempts = 100'000;
    std::vector<Vec3> points;
    points.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::uint64_t key = mix_bits(seed, static_cast<std::uint64_t>(i));
        for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
            const Vec3 x{box.low.x + extent.x * unit_interval(mix_bits(key, 3 * attempt)),
                         box.low.y + extent.y * unit_interval(mix_bits(key, 3 * attempt + 1)),
                         box.low.z + extent.z * unit_interval(mix_bits(key, 3 * attempt + 2))};
            if (is_inside(planes, x, 0.0)) {
                points.push_back(x);
                break;
            }
        }
    }
    return points;
}

Outcome<std::vector<Polyhedron>> voronoi_cells(const Polyhedron& region, std::span<const Vec3> points, double gap) {
    std::vector<GeometryProblem> problems = check(region, static_cast<std::int64_t>(points.size()), gap);
    if (!problems.empty()) {
        return problems;
    }
    const double smallest_distance = 1e-9 * length_scale(region.vertices);
    const std::vector<Plane> planes = planes_of(region);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i]) || !is_inside(planes, points[i], smallest_distance)) {
            problems.push_back({fmt::format("Voronoi point {} at ({:g}, {:g}, {:g}) lies outside the region", i,
                                            points[i].x, points[i].y, points[i].z),
                                "points inside"});
        }
    }
    const auto [first, second] = find_equal_points(points);
    if (first >= 0) {
        problems.push_back({fmt::format("Voronoi points {} and {} coincide", first, second), "points apart"});
    }
    if (!problems.empty()) {
        return problems;
    }
    const auto neighbours = find_neighbours(bounding_box(region), points);
    std::vector<Polyhedron> blocks(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        Polyhedron block = region;
        for (const int other : neighbours[i]) {
            const Vec3& near = points[i];
            const Vec3& far = points[static_cast<std::size_t>(other)];
            const double distance = norm(far - near);
            if (!(distance > smallest_distance)) {
                problems.push_back({fmt::format("Voronoi points {} and {} coincide", i, other), "points apart"});
                break;
            }
            const Vec3 normal = (far - near) / distance;
            block = clip_convex(block, {normal, 0.5 * dot(normal, near + far) - 0.5 * gap});
        }
        if (block.faces.empty()) {
            problems.push_back({fmt::format("a gap of {:g} m leaves nothing of Voronoi block {}", gap, i),
                                "a smaller gap, fewer blocks, or more Lloyd iterations"});
        }
        blocks[i] = std::move(block);
    }
    if (!problems.empty()) {
        return problems;
    }
    return blocks;
}

Outcome<std::vector<Polyhedron>> voronoi_blocks(const Polyhedron& region, const VoronoiOptions& options) {
    std::vector<GeometryProblem> problems = check(region, options.block_count, options.gap);
    constexpr int most_iterations = 1000;
    if (options.lloyd_iterations < 0 || options.lloyd_iterations > most_iterations) {
        problems.push_back(
            {fmt::format("{} Lloyd iterations", options.lloyd_iterations), fmt::format("0 to {}", most_iterations)});
    }
    if (!problems.empty()) {
        return problems;
    }
    std::vector<Vec3> points = random_points(region, options.block_count, options.seed);
    if (static_cast<std::int64_t>(points.size()) < options.block_count) {
        return GeometryProblem{"the region fills too little of its bounding box to find points inside",
                               "a region turned so that it fills more of its bounding box"};
    }
    for (int iteration = 0; iteration < options.lloyd_iterations; ++iteration) {
        const auto cells = voronoi_cells(region, points, 0.0);
        if (!cells) {
            return cells.problems();
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            points[i] = mass_properties(cells.value()[i]).centroid;
        }
    }
    return voronoi_cells(region, points, options.gap);
}

}  // namespace riprap::geometry
