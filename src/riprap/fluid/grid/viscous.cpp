// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/viscous.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::fluid::grid {

namespace {

/// Nearest that a wall comes to the centre of a face, in cell widths; nearer ones hold the fluid as firmly [-]. The
/// shear mu/(s h^2) is then that of the layer of half a cell, 2 mu/(h/2)^2, which the face becomes as the wall passes
/// its centre: no jump.
constexpr double least_distance = 0.125;
/// Thinnest open part of a face as a layer, in cell widths [-].
constexpr double least_layer = 0.05;

}  // namespace

namespace {

using RowArray = std::array<double, most_in_row + 1>;

/// Fills in 1/length along one axis for the faces of a row [1/m].
void find_inverse(const std::vector<double>& lengths, int axis, int place, int n, RowArray& inverse) {
    const double* const first = lengths.data() + Mesh::ghosts + place;
    if (axis == 0) {
        for (int i = 0; i < n; ++i) {
            inverse[at(i)] = 1 / first[i];
        }
    } else {
        std::fill_n(inverse.begin(), n, 1 / *first);
    }
}

/// Shear stress at edges between the faces f - t and f, of a row [Pa].
struct EdgeStress {
    const Mesh& mesh;
    const GridScratch& s;
    int a, b;

    /// @param upper  place along b of the faces f
    void find(std::int64_t start, int n, const std::array<int, 3>& place, int upper, double* stress) const {
        const CellBox& box = mesh.box;
        const std::int64_t t = box.stride[at(b)], sa = box.stride[at(a)];
        const double *u = s.start.carrier[at(a)].data() + start, *v = s.start.carrier[at(b)].data() + start;
        const double* const mu = s.stress.viscosity.data() + start;
        // on a side, what its ghosts hold: no eddies on a wall
        const bool on_low = b != 0 && upper == 0, on_high = b != 0 && upper == box.cells[at(b)];
        const double *above = on_low ? mu - t : mu, *below = on_high ? mu : mu - t;
        RowArray across, along;
        find_inverse(mesh.distance[at(b)], b, upper, n, across);
        find_inverse(mesh.distance[at(a)], a, place[at(a)], n, along);
#pragma GCC ivdep
        for (int i = 0; i < n; ++i) {
            const double p = above[i] * below[i], q = above[i - sa] * below[i - sa];
            const double mean = 4 * p * q / (q * (above[i] + below[i]) + p * (above[i - sa] + below[i - sa]));
            stress[i] = mean * ((u[i] - u[i - t]) * across[at(i)] + (v[i] - v[i - sa]) * along[at(i)]);
        }
        if (b == 0) {
            for (const int side : {0, box.cells[0]}) {
                const int i = side - upper;
                if (i >= 0 && i < n) {
                    const std::int64_t ghost = side == 0 ? i - 1 : i;
                    stress[i] = 2 * mu[ghost] * mu[ghost - sa] / (mu[ghost] + mu[ghost - sa]) *
                                ((u[i] - u[i - t]) * across[at(i)] + (v[i] - v[i - sa]) * along[at(i)]);
                }
            }
        }
        if (s.open.has_bodies) {
            const float* const distance = s.open.wall_distance[at(a)].data() + start;
            for (int i = 0; i < n; ++i) {
                stress[i] = distance[i] <= 0 || distance[i - t] <= 0 ? 0 : stress[i];
            }
        }
    }
};

}  // namespace

void viscous_row(const GridSettings& settings, const GridScratch& s, int a, std::int64_t start, int n,
                 const std::array<int, 3>& place, double* force) {
    const Mesh& mesh = settings.mesh;
    const std::int64_t sa = mesh.box.stride[at(a)];
    const double *u = s.start.carrier[at(a)].data() + start, *mu = s.stress.viscosity.data() + start;
    const float* const distance = s.open.has_bodies ? s.open.wall_distance[at(a)].data() + start : nullptr;
    {  // along the axis: 2 mu du/dx at the two centres
        RowArray low, high, between;
        find_inverse(mesh.width[at(a)], a, place[at(a)] - 1, n, low);
        find_inverse(mesh.width[at(a)], a, place[at(a)], n, high);
        find_inverse(mesh.distance[at(a)], a, place[at(a)], n, between);
#pragma GCC ivdep
        for (int i = 0; i < n; ++i) {
            double below = 2 * mu[i - sa] * (u[i] - u[i - sa]) * low[at(i)],
                   above = 2 * mu[i] * (u[i + sa] - u[i]) * high[at(i)];
            if (distance != nullptr) {
                below = distance[i - sa] <= 0 ? 0 : below;
                above = distance[i + sa] <= 0 ? 0 : above;
            }
            force[i] = (above - below) * between[at(i)];
        }
    }
    for (int b = 0; b < mesh.box.axes; ++b) {
        if (b == a) {
            continue;
        }
        const EdgeStress edges{mesh, s, a, b};
        const int q = place[at(b)];
        RowArray low, high;
        edges.find(start, b == 0 ? n + 1 : n, place, q, low.data());
        const double* upper = low.data() + 1;
        if (b != 0) {
            edges.find(start + mesh.box.stride[at(b)], n, place, q + 1, high.data());
            upper = high.data();
        }
        RowArray width;
        find_inverse(mesh.width[at(b)], b, q, n, width);
        for (int i = 0; i < n; ++i) {
            force[i] += (upper[i] - low[at(i)]) * width[at(i)];
        }
    }
    for (int i = 0; distance != nullptr && i < n; ++i) {
        force[i] = distance[i] <= 0 ? 0 : force[i];
    }
}

double wall_drag(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face,
                 const std::array<int, 3>& place) {
    constexpr float far = 1e29F;  // of faces that know no solid
    const auto& distance = s.open.wall_distance[at(a)];
    const double here = distance[at(face)], area = s.room.area[at(a)][at(face)];
    if (distance[at(face)] > far || area == 0) {
        return 0;
    }
    const Mesh& mesh = settings.mesh;
    const double mu = 0.5 * (s.stress.viscosity[at(face - mesh.box.stride[at(a)])] + s.stress.viscosity[at(face)]);
    if (here <= 0) {  // the open part of the face is a layer beside the solid
        const double share = area / mesh.face_area(a, place[0], place[1], place[2]);
        const double layer = std::max(share, least_layer) * mesh.smallest_width();
        return 2 * mu / (layer * layer);
    }
    double drag = 0;
    for (int b = 0; b < mesh.box.axes; ++b) {
        const int q = place[at(b)];
        const double h = b == a ? mesh.d(a, q) : mesh.h(b, q);
        for (const std::int64_t side : {-mesh.box.stride[at(b)], mesh.box.stride[at(b)]}) {
            const double there = distance[at(face + side)];
            if (there <= 0) {
                const double share = std::max(here / (here - there), least_distance);
                drag += (b == a ? 2 : 1) * mu / (share * h * h);
            }
        }
    }
    return drag;
}

}  // namespace riprap::fluid::grid
