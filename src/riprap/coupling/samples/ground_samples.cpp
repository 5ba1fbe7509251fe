// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/ground_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr double least_share = 0.02;  ///< of a cell: less solid than that is left out

/// The lattice of the water in the world, cell (i, j, k) about its middle.
struct CellLattice {
    Vec3 corner;
    double spacing;
    bool is_planar;

    std::int64_t index(double x, int axis) const {
        return is_planar && axis == 2 ? 0 : static_cast<std::int64_t>(std::floor((x - corner[axis]) / spacing));
    }
    Vec3 middle(const std::array<std::int64_t, 3>& c) const {
        const auto along = [&](int axis) {
            return corner[axis] + (static_cast<double>(c[riprap::at(axis)]) + 0.5) * spacing;
        };
        return {along(0), along(1), is_planar ? 0 : along(2)};
    }
};

[[noreturn]] void refuse(std::int64_t count, std::int64_t limit) {
    Diagnostic problem;
    problem.message = fmt::format("ground needs {} boundary particles or more", count);
    problem.allowed = fmt::format("at most {}: a larger spacing, a smaller domain, or wet = false", limit);
    throw CaseError(std::move(problem));
}

using Cell = std::array<std::int64_t, 3>;

/// Cells that come within `reach` of a triangle's box, each once, in order.
std::vector<Cell> cells_near(const geometry::TriangleMesh& mesh, const Pose& pose, const SampleBox& box,
                             const CellLattice& lattice, double reach, std::int64_t most) {
    std::vector<Cell> cells;
    std::vector<Vec3> points;
    points.reserve(mesh.points.size());
    for (const Vec3& x : mesh.points) {
        points.push_back(to_world(pose, x));
    }
    const Vec3 margin{reach, reach, reach};
    std::size_t sorted = 0;
    const auto tidy = [&cells, &sorted] {
        std::sort(cells.begin(), cells.end());
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
        sorted = cells.size();
    };
    for (const auto& corners : mesh.corners) {
        const Vec3 &a = points[at(corners[0])], &b = points[at(corners[1])], &c = points[at(corners[2])];
        const Vec3 low = max(min(a, min(b, c)) - margin, box.low), high = min(max(a, max(b, c)) + margin, box.high);
        if (!lattice.is_planar && !(low.z < high.z)) {
            continue;
        }
        for (std::int64_t k = lattice.index(low.z, 2); k <= lattice.index(high.z, 2); ++k) {
            for (std::int64_t j = lattice.index(low.y, 1); j <= lattice.index(high.y, 1); ++j) {
                for (std::int64_t i = lattice.index(low.x, 0); i <= lattice.index(high.x, 0); ++i) {
                    cells.push_back({k, j, i});
                }
            }
        }
        if (cells.size() > 2 * sorted + 1'000'000) {
            tidy();
            if (static_cast<std::int64_t>(cells.size()) > 8 * most) {
                refuse(static_cast<std::int64_t>(cells.size()) / 8, most);
            }
        }
    }
    tidy();
    return cells;
}

/// Of a cell: how much of it is solid, and the middle of that.
struct Solid {
    double share{0};
    Vec3 middle{};
};

/// @param depth  of the middle of the cell below the surface [m]
Solid solid_of(const Vec3& middle, double depth, const Vec3& normal, double spacing, bool is_planar) {
    const int n = is_planar ? 16 : 6;  // points a side
    const auto offset = [n, spacing](int i) { return ((i + 0.5) / n - 0.5) * spacing; };
    Vec3 sum{};
    int inside = 0, all = 0;
    for (int k = 0; k < (is_planar ? 1 : n); ++k) {
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i, ++all) {
                const Vec3 arm{offset(i), offset(j), is_planar ? 0 : offset(k)};
                // A plane between two rows of points has half of either.
                if (dot(normal, arm) < depth) {
                    sum += arm;
                    ++inside;
                }
            }
        }
    }
    return inside == 0 ? Solid{} : Solid{static_cast<double>(inside) / all, middle + sum / static_cast<double>(inside)};
}

}  // namespace

void sample_ground(const body::Ground& ground, const Pose& pose, const SampleBox& box, bool is_planar,
                   const SampleSettings& settings, SampleSet& samples) {
    const double dp = settings.spacing, half_diagonal = 0.5 * std::sqrt(is_planar ? 2.0 : 3.0) * dp;
    const double look = settings.reach + 2 * half_diagonal;
    const CellLattice lattice{settings.lattice_corner, dp, is_planar};
    const std::vector<Cell> cells = cells_near(ground.field.mesh(), pose, box, lattice, look, settings.limit);
    struct Found {
        Vec3 place, normal;
        double depth{0}, share{0};
    };
    std::vector<Found> found(cells.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(cells.size()), 64, [&](std::int64_t c) {
        const Cell& cell = cells[at(c)];
        const Vec3 middle = lattice.middle({cell[2], cell[1], cell[0]});
        const auto near = ground.field.nearest(to_body(pose, middle), look);
        if (!near || near->distance > half_diagonal) {
            return;
        }
        const Vec3 normal = rotate(pose.orientation, near->normal);
        const double depth = -near->distance;
        const Solid solid = depth >= half_diagonal ? Solid{1, middle} : solid_of(middle, depth, normal, dp, is_planar);
        const double below = depth + dot(normal, middle - solid.middle);
        if (solid.share >= least_share && below < settings.reach) {
            found[at(c)] = {to_body(pose, solid.middle), near->normal, below, solid.share};
        }
    });
    const double volume = is_planar ? dp * dp : dp * dp * dp;
    const bool is_slippery = !settings.is_slippery.empty() && settings.is_slippery[at(ground.body.value)] != 0;
    for (const Found& one : found) {
        if (one.share > 0) {
            samples.body.push_back(ground.body);
            samples.anchor.push_back(one.place);
            samples.normal.push_back(one.normal);
            samples.depth.push_back(std::max(0.0, one.depth));
            samples.volume.push_back(one.share * volume);
            samples.is_slippery.push_back(is_slippery ? 1 : 0);
            samples.is_in_vertex.push_back(0);  // share_seams finds them
        }
    }
    if (samples.size() > settings.limit) {
        refuse(samples.size(), settings.limit);
    }
}

}  // namespace riprap::coupling
