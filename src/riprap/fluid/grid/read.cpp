// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/read.hpp"

#include <cmath>

#include "riprap/fluid/grid/datum.hpp"
#include "riprap/fluid/grid/momentum.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// Lower of the two nodes around a place along an axis and the share of the upper one. Nodes are cell centres, or faces
/// for is_face.
struct Between {
    int low;
    double share;
};
Between between(const Mesh& mesh, int a, double place, bool is_face) {
    const int n = mesh.box.cells[at(a)];
    if (a >= mesh.box.axes) {
        return {0, 0};
    }
    const int cell = mesh.cell_at(a, place);
    if (is_face) {
        const double low = mesh.edge[at(a)][at(cell)];
        return {cell, std::clamp((place - low) / mesh.h(a, cell), 0.0, 1.0)};
    }
    const int low = place < mesh.centre(a, cell) ? cell - 1 : cell;
    if (low < 0 || low + 1 >= n) {
        return {std::clamp(low, 0, n - 1), 0};
    }
    return {low, (place - mesh.centre(a, low)) / mesh.d(a, low + 1)};
}

double interpolated(const Mesh& mesh, const std::vector<double>& field, const Vec3& place, int face_axis) {
    std::array<Between, 3> b{};
    for (int a = 0; a < 3; ++a) {
        b[at(a)] = between(mesh, a, place[a], a == face_axis);
    }
    double sum = 0;
    for (int q = 0; q < 8; ++q) {
        const std::array<int, 3> up{q & 1, (q >> 1) & 1, q >> 2};
        double weight = 1;
        for (std::size_t a = 0; a < 3; ++a) {
            weight *= up[a] == 1 ? b[a].share : 1 - b[a].share;
        }
        if (weight > 0) {
            sum += weight * field[at(mesh.box.index(b[0].low + up[0], b[1].low + up[1], b[2].low + up[2]))];
        }
    }
    return sum;
}

}  // namespace

double read_pressure(const GridSettings& settings, const GridState& state, const Vec3& place) {
    const double p = interpolated(settings.mesh, state.pressure, place, -1);
    if (!settings.has_surface) {
        return p;
    }
    const double fraction = interpolated(settings.mesh, state.fraction, place, -1);
    return p + density_of(settings, fraction) * dot(body_force(settings, state.time), place - datum_of(settings.mesh));
}

Vec3 read_velocity(const GridSettings& settings, const GridState& state, const Vec3& place) {
    Vec3 velocity{};
    for (int a = 0; a < settings.mesh.box.axes; ++a) {
        velocity[a] = interpolated(settings.mesh, state.velocity[at(a)], place, a);
    }
    return velocity;
}

namespace {

/// First moment of the water in a mixed cell about its centre, over its volume [m].
Vec3 moment_of_water(const GridSettings& settings, const GridState& state, std::int64_t c,
                     const std::array<int, 3>& place) {
    constexpr int slabs = 8;
    const Mesh& mesh = settings.mesh;
    const CellPlane plane = place_plane(surface_normal(mesh.box, state.fraction, c), state.fraction[at(c)]);
    Vec3 moment{};
    for (int a = 0; a < mesh.box.axes; ++a) {
        for (int k = 0; k < slabs; ++k) {
            const double low = static_cast<double>(k) / slabs - 0.5, high = static_cast<double>(k + 1) / slabs - 0.5;
            moment[a] += slab_fraction(plane, a, low, high) * 0.5 * (low + high) / slabs * mesh.h(a, place[at(a)]);
        }
    }
    return moment;
}

}  // namespace

Energy read_energy(const GridSettings& settings, const GridState& state, const GridScratch& scratch) {
    const CellBox& box = settings.mesh.box;
    const Vec3 datum = datum_of(settings.mesh);
    return sum_cells(box, [&](std::int64_t c, int i, int j, int k) {
        const double mass = scratch.room.capacity[at(c)] * density_of(settings, state.fraction[at(c)]);
        double square = 0;  // by open areas: a jet out of a narrow gap is not the whole cell beyond
        for (int a = 0; a < box.axes; ++a) {
            const auto& u = state.velocity[at(a)];
            const auto& area = scratch.room.area[at(a)];
            const std::int64_t high = c + box.stride[at(a)];
            const double both = area[at(c)] + area[at(high)];
            const double share = both > 0 ? area[at(c)] / both : 0.5;
            square += share * std::pow(u[at(c)], 2) + (1 - share) * std::pow(u[at(high)], 2);
        }
        const double porosity = scratch.medium.has_stones ? scratch.medium.porosity[at(c)] : 1;
        Vec3 moment = mass * (settings.mesh.centre(i, j, k) - datum);
        if (settings.has_surface && is_mixed(state.fraction[at(c)])) {  // water lies on one side of the cell
            moment += (settings.water.density - settings.air.density) * scratch.room.capacity[at(c)] *
                      moment_of_water(settings, state, c, {i, j, k});
        }
        return Energy{0.5 * mass * square / (porosity * porosity), moment};
    });
}

}  // namespace riprap::fluid::grid
