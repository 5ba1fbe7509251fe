// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/box_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riprap::solid::sphere_dem {

namespace {

/// Cells along an edge [-].
double cells_along(double length, double radius) { return std::max(1.0, std::ceil(length / (2 * radius) - 1e-9)); }

/// Grid of the nodes of a box; in the plane one layer.
struct Grid {
    std::array<int, 3> cells{};
    Vec3 step;  ///< [m]
    int axes{3};
};

Grid grid_of(const BoxSampling& box) {
    Grid grid;
    grid.axes = box.is_planar ? 2 : 3;
    for (int axis = 0; axis < grid.axes; ++axis) {
        const double cells = cells_along(box.size[axis], box.radius);
        grid.cells[static_cast<std::size_t>(axis)] = static_cast<int>(cells);
        grid.step[axis] = box.size[axis] / cells;
    }
    return grid;
}

/// Mean over the faces of a node of the area that is its own; in the plane of the length.
/// @param side  per axis: -1 or 1 where the node lies in that face, else 0
double area_of(const Grid& grid, const std::array<int, 3>& side) {
    double sum = 0;
    int faces = 0;
    for (int normal = 0; normal < grid.axes; ++normal) {
        if (side[static_cast<std::size_t>(normal)] == 0) {
            continue;
        }
        double area = 1;
        for (int axis = 0; axis < grid.axes; ++axis) {
            if (axis != normal) {
                area *= grid.step[axis] * (side[static_cast<std::size_t>(axis)] != 0 ? 0.5 : 1);
            }
        }
        sum += area;
        ++faces;
    }
    return sum / faces;
}

/// Node of the grid, moved inwards until a sphere lies inside the box.
Vec3 place(const BoxSampling& box, const Grid& grid, const std::array<int, 3>& index, double radius) {
    Vec3 x{};
    for (int axis = 0; axis < grid.axes; ++axis) {
        const double room = 0.5 * box.size[axis] - radius;
        const double node = grid.step[axis] * index[static_cast<std::size_t>(axis)] - 0.5 * box.size[axis];
        x[axis] = std::clamp(node, -room, room);
    }
    return x;
}

void add_node(const BoxSampling& box, const Grid& grid, const std::array<int, 3>& index,
              std::vector<SurfaceSample>& samples) {
    std::array<int, 3> side{};
    Vec3 normal{};
    int sides = 0;
    for (int axis = 0; axis < grid.axes; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        side[a] = index[a] == 0 ? -1 : index[a] == grid.cells[a] ? 1 : 0;
        normal[axis] = side[a];
        sides += side[a] != 0 ? 1 : 0;
    }
    if (sides == 0) {
        return;
    }
    const double area = area_of(grid, side);
    if (sides == 1) {
        samples.push_back({{place(box, grid, index, box.radius), box.radius, normal}, box.radius, area});
        return;
    }
    samples.push_back({{place(box, grid, index, box.sharp), box.sharp, {}}, box.radius, area});
    if (box.meets_triangles) {
        samples.push_back({{place(box, grid, index, box.radius), box.radius, {}}, box.radius, area});
    }
}

}  // namespace

std::vector<SurfaceSample> box_samples(const BoxSampling& box) {
    const Grid grid = grid_of(box);
    std::vector<SurfaceSample> samples;
    for (int i = 0; i <= grid.cells[0]; ++i) {
        for (int j = 0; j <= grid.cells[1]; ++j) {
            const bool is_inner = i > 0 && i < grid.cells[0] && j > 0 && j < grid.cells[1];
            for (int k = 0; k <= grid.cells[2]; k += is_inner ? std::max(1, grid.cells[2]) : 1) {
                add_node(box, grid, {i, j, k}, samples);
            }
        }
    }
    return samples;
}

double box_sample_count(const BoxSampling& box) {
    double all = 1, inside = 1;
    for (int axis = 0; axis < (box.is_planar ? 2 : 3); ++axis) {
        const double cells = cells_along(box.size[axis], box.radius);
        all *= cells + 1;
        inside *= cells - 1;
    }
    return all - inside;
}

}  // namespace riprap::solid::sphere_dem
