// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/shown_water.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// The section of the unit cell about the origin by the plane n.x = d, in order around n.
std::vector<Vec3> section(const std::array<double, 3>& n, double d, int axes) {
    std::vector<Vec3> points;
    const auto value = [&](const Vec3& x) { return n[0] * x.x + n[1] * x.y + n[2] * x.z - d; };
    for (int a = 0; a < axes; ++a) {
        for (int corner = 0; corner < (axes == 3 ? 4 : 4); ++corner) {
            Vec3 low{};
            low[(a + 1) % 3] = (corner & 1) != 0 ? 0.5 : -0.5;
            low[(a + 2) % 3] = (corner & 2) != 0 ? 0.5 : -0.5;
            low[a] = -0.5;
            Vec3 high = low;
            high[a] = 0.5;
            const double at_low = value(low), at_high = value(high);
            if ((at_low < 0) != (at_high < 0)) {
                points.push_back(low + (at_low / (at_low - at_high)) * (high - low));
            }
        }
    }
    Vec3 middle{};
    for (const Vec3& x : points) {
        middle += x / static_cast<double>(points.size());
    }
    const Vec3 normal = normalized(Vec3{n[0], n[1], n[2]});
    const Vec3 first =
        normalized(std::abs(normal.z) < 0.9 ? cross(normal, Vec3{0, 0, 1}) : cross(normal, Vec3{1, 0, 0}));
    const Vec3 second = cross(normal, first);
    std::sort(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
        return std::atan2(dot(a - middle, second), dot(a - middle, first)) <
               std::atan2(dot(b - middle, second), dot(b - middle, first));
    });
    return points;
}

/// Way from the centre of a full cell to its point: up to half a cell below a surface that lies in the lower half of a
/// cell beside it, which has no point of its own, so that the surface of balls rises without steps [m].
Vec3 way_to_surface(const Mesh& mesh, const GridState& state, const CellPlanes& plane, std::int64_t c,
                    const Vec3& size) {
    Vec3 way{};
    double farthest = 0;
    for (int a = 0; a < mesh.box.axes; ++a) {
        for (const int side : {-1, 1}) {
            const std::int64_t beside = c + side * mesh.box.stride[at(a)];
            const double fraction = state.fraction[at(beside)];
            if (!is_mixed(fraction) || fraction >= 0.5 || fraction <= farthest) {
                continue;  // only mixed cells have a plane
            }
            const auto& n = plane[at(beside)].n;
            if (side * n[at(a)] >= std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])})) {
                farthest = fraction;
                way = {};
                way[a] = side * fraction * size[a];
            }
        }
    }
    return way;
}

}  // namespace

ShownFluid show_water(const GridSettings& settings, const GridState& state, const OpenShares& open) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    ShownFluid shown;
    shown.spacing = mesh.smallest_width();
    CellPlanes plane;
    reconstruct_surface(mesh, state.fraction, plane);
    const Vec3 g = body_force(settings, state.time), datum = datum_of(mesh);
    for (int k = 0; k < box.cells[2]; ++k) {
        for (int j = 0; j < box.cells[1]; ++j) {
            for (int i = 0; i < box.cells[0]; ++i) {
                const std::int64_t c = box.index(i, j, k);
                const double fraction = state.fraction[at(c)];
                if (fraction < 1e-3 || (open.has_bodies && !(open.volume[at(c)] > 0))) {
                    continue;
                }
                Vec3 place = mesh.centre(i, j, k);
                const Vec3 size{mesh.h(0, i), mesh.h(1, j), mesh.h(2, k)};
                if (is_mixed(fraction) && fraction < 1 - 1e-3) {
                    const CellPlane& cut = plane[at(c)];
                    for (const Vec3& x : section(cut.n, cut.d, box.axes)) {
                        shown.corner.push_back(place + Vec3{x.x * size.x, x.y * size.y, x.z * size.z});
                    }
                    shown.polygon_end.push_back(static_cast<std::int32_t>(shown.corner.size()));
                    const double square = cut.n[0] * cut.n[0] + cut.n[1] * cut.n[1] + cut.n[2] * cut.n[2];
                    const double length = std::sqrt(square), shift = cut.d / square - 0.5 / length;
                    for (int a = 0; a < box.axes; ++a) {
                        place[a] += shift * cut.n[at(a)] * size[a];
                    }
                }
                if (fraction < 0.5) {
                    continue;
                }
                if (fraction >= 1 - 1e-3) {
                    place += way_to_surface(mesh, state, plane, c, size);
                }
                Vec3 velocity{};
                for (int a = 0; a < box.axes; ++a) {
                    const auto& u = state.velocity[at(a)];
                    velocity[a] = 0.5 * (u[at(c)] + u[at(c + box.stride[at(a)])]);
                }
                shown.place.push_back(place);
                shown.velocity.push_back(velocity);
                shown.pressure.push_back(static_cast<float>(
                    state.pressure[at(c)] + density_of(settings, fraction) * dot(g, mesh.centre(i, j, k) - datum)));
                shown.id.push_back(static_cast<std::int32_t>(c));
            }
        }
    }
    return shown;
}

}  // namespace riprap::fluid::grid
