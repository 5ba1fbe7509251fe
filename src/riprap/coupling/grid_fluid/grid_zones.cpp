// SPDX-License-Identifier: Apache-2.0
// Zones of stones, and boxes where waves die.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "riprap/coupling/grid_fluid/grid_parts.hpp"
#include "riprap/geometry/ground/triangle_field.hpp"

namespace riprap::coupling {

namespace {

/// Part of a zone: by the planes of its faces where it is convex, else by its surface.
struct ZonePart {
    std::vector<geometry::Plane> planes;
    std::shared_ptr<const geometry::TriangleField> surface{};

    bool holds(const Vec3& x) const {
        return surface != nullptr ? surface->is_inside(x)
                                  : std::all_of(planes.begin(), planes.end(), [&](const geometry::Plane& plane) {
                                        return dot(plane.normal, x) <= plane.offset;
                                    });
    }
};

bool is_convex(const geometry::Polyhedron& piece, const std::vector<geometry::Plane>& planes) {
    Vec3 low = piece.vertices.front(), high = low;
    for (const Vec3& x : piece.vertices) {
        low = min(low, x);
        high = max(high, x);
    }
    const double slack = 1e-6 * norm(high - low);  // as flat as the audit of surfaces asks
    return std::all_of(piece.vertices.begin(), piece.vertices.end(), [&](const Vec3& x) {
        return std::all_of(planes.begin(), planes.end(),
                           [&](const geometry::Plane& plane) { return dot(plane.normal, x) <= plane.offset + slack; });
    });
}

ZonePart part_of(const geometry::Polyhedron& piece, const Vec3& up) {
    ZonePart part;
    for (const auto& face : piece.faces) {
        part.planes.push_back(geometry::face_plane(piece.vertices, face));
    }
    if (!is_convex(piece, part.planes)) {
        geometry::TriangleMesh mesh{piece.vertices, {}};
        for (const auto& face : piece.faces) {
            for (std::size_t i = 1; i + 1 < face.size(); ++i) {
                mesh.corners.push_back({face[0], face[i], face[i + 1]});
            }
        }
        part.surface = std::make_shared<const geometry::TriangleField>(std::move(mesh), up);
    }
    return part;
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

/// Tells why a sponge would do nothing; nothing where it does.
std::optional<KeyProblem> idle_sponge(const GridFluidSettings& settings, const CalmBox& box, std::string_view key) {
    const fluid::Domain& domain = settings.scene.domain;
    for (int a = 0; a < domain.dimension; ++a) {
        if (!(box.high[a] > domain.low[a] && box.low[a] < domain.high[a])) {
            return KeyProblem{
                key,
                fmt::format("the sponge lies outside the domain: from {} m to {} m along {}", box.low[a], box.high[a],
                            "xyz"[a]),
                fmt::format("a box that meets it, which reaches from {} m to {} m", domain.low[a], domain.high[a])};
        }
    }
    if (box.rate == 0 && norm(settings.grid.gravity) == 0) {
        return KeyProblem{key, "no rate follows for a sponge without gravity", "a rate in 1/s"};
    }
    return std::nullopt;
}

}  // namespace

std::vector<KeyProblem> add_zones(GridFluidSettings& settings) {
    std::vector<KeyProblem> problems;
    for (std::size_t entry = 0; entry < settings.scene.stones.size(); ++entry) {
        const Stones& stones = settings.scene.stones[entry];
        std::vector<ZonePart> parts;
        bool is_there = false;
        for (const geometry::Polyhedron& piece : stones.pieces) {
            parts.push_back(part_of(piece, settings.scene.up));
        }
        const fluid::grid::Mesh& mesh = settings.grid.mesh;
        const auto holds = [parts](const Vec3& x) {
            return std::any_of(parts.begin(), parts.end(), [&](const ZonePart& part) { return part.holds(x); });
        };
        for (int k = 0; k < mesh.box.cells[2] && !is_there; ++k) {
            for (int j = 0; j < mesh.box.cells[1] && !is_there; ++j) {
                for (int i = 0; i < mesh.box.cells[0] && !is_there; ++i) {
                    is_there = holds(mesh.centre(i, j, k));
                }
            }
        }
        if (!is_there) {
            problems.push_back({entry_key("porous", entry), "a porous zone that holds the middle of no cell",
                                "a zone in the domain, larger than a cell"});
        }
        settings.grid.porous.push_back({stones.medium, holds});
    }
    for (std::size_t entry = 0; entry < settings.scene.calm.size(); ++entry) {
        const CalmBox& box = settings.scene.calm[entry];
        if (auto problem = idle_sponge(settings, box, entry_key("sponge", entry))) {
            problems.push_back(std::move(*problem));
            continue;
        }
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
