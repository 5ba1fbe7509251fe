// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/mesh.hpp"

#include <algorithm>

#include "riprap/core/error.hpp"

namespace riprap::fluid::grid {

Mesh::Mesh(const std::array<std::vector<double>, 3>& edges, int axes) : edge(edges) {
    std::array<int, 3> cells{};
    for (std::size_t a = 0; a < 3; ++a) {
        RIPRAP_ASSERT(edges[a].size() >= 2, "an axis without a cell");
        cells[a] = static_cast<int>(edges[a].size()) - 1;
    }
    box = CellBox(cells, ghosts, axes);
    for (std::size_t a = 0; a < 3; ++a) {
        const int n = cells[a];
        for (int i = -ghosts; i < n + ghosts; ++i) {
            const int mirrored = i < 0 ? -1 - i : i >= n ? 2 * n - 1 - i : i;
            const auto m = at(std::clamp(mirrored, 0, n - 1));
            width[a].push_back(edge[a][m + 1] - edge[a][m]);
        }
        distance[a].assign(width[a].size() + 1, 0.0);
        for (std::size_t i = 1; i < width[a].size(); ++i) {
            distance[a][i] = 0.5 * (width[a][i - 1] + width[a][i]);
        }
        distance[a].front() = width[a].front();
        distance[a].back() = width[a].back();
    }
}

double Mesh::centre(int a, int i) const {
    const auto& e = edge[at(a)];
    const int n = box.cells[at(a)];
    if (i < 0) {
        return e[0] - (0.5 * h(a, i) + (i < -1 ? h(a, -1) : 0));
    }
    if (i >= n) {
        return e[at(n)] + (0.5 * h(a, i) + (i > n ? h(a, n) : 0));
    }
    return 0.5 * (e[at(i)] + e[at(i + 1)]);
}

int Mesh::cell_at(int a, double place) const {
    const auto& e = edge[at(a)];
    const auto above = std::upper_bound(e.begin(), e.end(), place) - e.begin();
    return std::clamp(static_cast<int>(above) - 1, 0, box.cells[at(a)] - 1);
}

double Mesh::smallest_width() const {
    double smallest = h(0, 0);
    for (int a = 0; a < box.axes; ++a) {
        for (int i = 0; i < box.cells[at(a)]; ++i) {
            smallest = std::min(smallest, h(a, i));
        }
    }
    return smallest;
}

std::vector<double> uniform_edges(double low, double high, int cells) {
    std::vector<double> edges;
    for (int i = 0; i <= cells; ++i) {
        edges.push_back(low + (high - low) * i / cells);
    }
    return edges;
}

}  // namespace riprap::fluid::grid
