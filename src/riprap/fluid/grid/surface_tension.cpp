// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/surface_tension.hpp"

#include <cmath>
#include <optional>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// A column reaches into water and air where its ends differ from 1 and 0 by no more [-].
constexpr double end_tolerance = 1e-6;
constexpr int reach = 3;  ///< cells of a column on either side of the cell; 2 beside the ghosts' end

/// Water in the column through c along an axis [m], or nothing where it does not cross the surface once.
std::optional<double> height(const Mesh& mesh, const std::vector<double>& f, std::int64_t c, int a, int place,
                             bool water_below) {
    const std::int64_t s = mesh.box.stride[at(a)];
    const int low = std::min(reach, place + Mesh::ghosts), high = std::min(reach, mesh.box.cells[at(a)] + 1 - place);
    double sum = 0;
    for (int i = -low; i <= high; ++i) {
        sum += f[at(c + i * s)] * mesh.h(a, place + i);
    }
    const double bottom = f[at(c - low * s)], top = f[at(c + high * s)];
    const double full = water_below ? bottom : top, empty = water_below ? top : bottom;
    if (full < 1 - end_tolerance || empty > end_tolerance) {
        return {};
    }
    return sum;
}

/// Curvature from the heights of 3 x 3 columns (3 in a plane flow).
std::optional<double> curvature_of_heights(const Mesh& mesh, const std::vector<double>& f, std::int64_t c, int a,
                                           const std::array<int, 3>& place, bool water_below) {
    const int b = (a + 1) % mesh.box.axes, d = mesh.box.axes == 3 ? (a + 2) % 3 : -1;
    std::array<std::array<double, 3>, 3> h{};
    for (int q = d < 0 ? 0 : -1; q <= (d < 0 ? 0 : 1); ++q) {
        for (int p = -1; p <= 1; ++p) {
            const std::int64_t column = c + p * mesh.box.stride[at(b)] + (d < 0 ? 0 : q * mesh.box.stride[at(d)]);
            const auto value = height(mesh, f, column, a, place[at(a)], water_below);
            if (!value) {
                return {};
            }
            h[at(q + 1)][at(p + 1)] = *value;
        }
    }
    const double w = mesh.h(b, place[at(b)]);
    const double hx = (h[1][2] - h[1][0]) / (2 * w), hxx = (h[1][2] - 2 * h[1][1] + h[1][0]) / (w * w);
    if (d < 0) {
        return -hxx / std::pow(1 + hx * hx, 1.5);
    }
    const double v = mesh.h(d, place[at(d)]);
    const double hy = (h[2][1] - h[0][1]) / (2 * v), hyy = (h[2][1] - 2 * h[1][1] + h[0][1]) / (v * v);
    const double hxy = (h[2][2] - h[2][0] - h[0][2] + h[0][0]) / (4 * w * v);
    return -(hxx * (1 + hy * hy) + hyy * (1 + hx * hx) - 2 * hx * hy * hxy) / std::pow(1 + hx * hx + hy * hy, 1.5);
}

/// Component of the unit normal into the water, from differences over the neighbours, weights 1 2 1.
double normal_component(const Mesh& mesh, const std::vector<double>& f, std::int64_t c, int axis,
                        const std::array<int, 3>& place) {
    const CellBox& box = mesh.box;
    std::array<double, 3> m{};
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t s = box.stride[at(a)], t = box.stride[at((a + 1) % box.axes)];
        const bool in_space = box.axes == 3;
        const std::int64_t v = in_space ? box.stride[at((a + 2) % 3)] : 0;
        for (int q = in_space ? -1 : 0; q <= (in_space ? 1 : 0); ++q) {
            for (int p = -1; p <= 1; ++p) {
                const std::int64_t i = c + p * t + q * v;
                m[at(a)] += (p == 0 ? 2 : 1) * (q == 0 ? 2 : 1) * (f[at(i + s)] - f[at(i - s)]);
            }
        }
        m[at(a)] /= mesh.h(a, place[at(a)]);
    }
    const double size = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    return size > 0 ? m[at(axis)] / size : 0;
}

}  // namespace

void find_curvature(const GridSettings& settings, const GridState& state, GridScratch& s) {
    if (settings.surface_tension <= 0) {
        return;
    }
    const Mesh& mesh = settings.mesh;
    const auto& f = state.fraction;
    for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        s.stress.curvature[at(c)] = 0;
        if (!is_mixed(f[at(c)])) {
            return;
        }
        const std::array<int, 3> place{i, j, k};
        const auto& n = s.moved.plane[at(c)].n;
        int a = 0;
        for (int b = 1; b < mesh.box.axes; ++b) {
            a = std::abs(n[at(b)]) > std::abs(n[at(a)]) ? b : a;
        }
        if (const auto by_heights = curvature_of_heights(mesh, f, c, a, place, n[at(a)] > 0)) {
            s.stress.curvature[at(c)] = *by_heights;
            return;
        }
        double divergence = 0;
        for (int b = 0; b < mesh.box.axes; ++b) {
            const std::int64_t t = mesh.box.stride[at(b)];
            std::array<int, 3> low = place, high = place;
            low[at(b)] -= 1;
            high[at(b)] += 1;
            if (place[at(b)] == 0 || place[at(b)] + 1 == mesh.box.cells[at(b)]) {
                continue;
            }
            divergence += (normal_component(mesh, f, c + t, b, high) - normal_component(mesh, f, c - t, b, low)) /
                          (2 * mesh.h(b, place[at(b)]));
        }
        s.stress.curvature[at(c)] = -divergence;
    });
    mirror_ghosts(mesh, s.stress.curvature);
}

}  // namespace riprap::fluid::grid
