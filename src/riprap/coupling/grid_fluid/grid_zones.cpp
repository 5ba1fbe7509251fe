// SPDX-License-Identifier: Apache-2.0
// Zones of stones, and boxes where waves die.
#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"

namespace riprap::coupling {

namespace {

bool is_in(const std::vector<geometry::Plane>& planes, const Vec3& x) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const geometry::Plane& plane) { return dot(plane.normal, x) <= plane.offset; });
}

/// Rate at the end of a box that sends back about a hundredth of a long wave of speed c: 7 c/L, growing as the square.
double calm_rate(const GridFluidSettings& settings, const CalmBox& box) {
    double bed = std::numeric_limits<double>::infinity();
    for (const Vec3& x : {settings.scene.domain.low, settings.scene.domain.high}) {
        bed = std::min(bed, dot(x, settings.scene.up));
    }
    const double depth = std::max(settings.spacing, still_level(settings) - bed);
    return 7 * std::sqrt(norm(settings.grid.gravity) * depth) / (box.high[box.axis] - box.low[box.axis]);
}

}  // namespace

std::vector<KeyProblem> add_zones(GridFluidSettings& settings) {
    std::vector<KeyProblem> problems;
    for (const Stones& stones : settings.scene.stones) {
        std::vector<std::vector<geometry::Plane>> pieces;
        bool is_there = false;
        for (const geometry::Polyhedron& piece : stones.pieces) {
            std::vector<geometry::Plane> planes;
            for (const auto& face : piece.faces) {
                planes.push_back(geometry::face_plane(piece.vertices, face));
            }
            pieces.push_back(std::move(planes));
        }
        const fluid::grid::Mesh& mesh = settings.grid.mesh;
        const auto holds = [pieces](const Vec3& x) {
            return std::any_of(pieces.begin(), pieces.end(), [&](const auto& planes) { return is_in(planes, x); });
        };
        for (int k = 0; k < mesh.box.cells[2] && !is_there; ++k) {
            for (int j = 0; j < mesh.box.cells[1] && !is_there; ++j) {
                for (int i = 0; i < mesh.box.cells[0] && !is_there; ++i) {
                    is_there = holds(mesh.centre(i, j, k));
                }
            }
        }
        if (!is_there) {
            problems.push_back({"porous", "a porous zone that holds the middle of no cell",
                                "a zone in the domain, larger than a cell"});
        }
        settings.grid.porous.push_back({stones.medium, holds});
    }
    for (const CalmBox& box : settings.scene.calm) {
        const double rate = box.rate > 0 ? box.rate : calm_rate(settings, box);
        settings.grid.sponges.push_back({[box, rate, axes = settings.scene.domain.dimension](const Vec3& x) {
            for (int a = 0; a < axes; ++a) {
                if (x[a] < box.low[a] || x[a] > box.high[a]) {
                    return 0.0;
                }
            }
            const double share = (x[box.axis] - box.low[box.axis]) / (box.high[box.axis] - box.low[box.axis]);
            return rate * std::pow(box.is_towards_high ? share : 1 - share, 2);
        }});
    }
    return problems;
}

}  // namespace riprap::coupling
