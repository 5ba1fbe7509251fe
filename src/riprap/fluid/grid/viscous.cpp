// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/viscous.hpp"

#include <cmath>

namespace riprap::fluid::grid {

namespace {

/// A face is left out of the fluid's own shear where its centre lies in a solid.
bool is_in_solid(const GridScratch& s, int a, std::int64_t face) {
    return s.open.has_bodies && s.open.wall_distance[at(a)][at(face)] <= 0;
}

/// Nearest that a wall comes to the centre of a face, in cell widths; nearer ones hold the fluid as firmly [-].
constexpr double least_distance = 0.05;

}  // namespace

double viscous_force(const GridSettings& settings, const GridScratch& s, int a, std::int64_t face,
                     const std::array<int, 3>& place) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    const std::int64_t sa = box.stride[at(a)];
    const auto& u = s.carrier[at(a)];
    const int p = place[at(a)];
    if (is_in_solid(s, a, face)) {
        return 0;
    }
    double force = 0;
    {  // along the axis: 2 mu du/dx at the two centres
        const double below = is_in_solid(s, a, face - sa)
                                 ? 0
                                 : 2 * s.viscosity[at(face - sa)] * (u[at(face)] - u[at(face - sa)]) / mesh.h(a, p - 1);
        const double above = is_in_solid(s, a, face + sa)
                                 ? 0
                                 : 2 * s.viscosity[at(face)] * (u[at(face + sa)] - u[at(face)]) / mesh.h(a, p);
        force += (above - below) / mesh.d(a, p);
    }
    for (int b = 0; b < box.axes; ++b) {
        if (b == a) {
            continue;
        }
        const std::int64_t t = box.stride[at(b)];
        const auto& v = s.carrier[at(b)];
        const int q = place[at(b)];
        const auto edge_stress = [&](std::int64_t f, int upper) {  // at the edge between f - t and f
            if (is_in_solid(s, a, f) || is_in_solid(s, a, f - t)) {
                return 0.0;
            }
            // on a side, what its ghosts hold: no eddies on a wall
            const std::int64_t above = upper == 0 ? f - t : f, below = upper == box.cells[at(b)] ? f : f - t;
            const double mu = 4 / (1 / s.viscosity[at(above)] + 1 / s.viscosity[at(below)] +
                                   1 / s.viscosity[at(above - sa)] + 1 / s.viscosity[at(below - sa)]);
            return mu * ((u[at(f)] - u[at(f - t)]) / mesh.d(b, upper) + (v[at(f)] - v[at(f - sa)]) / mesh.d(a, p));
        };
        force += (edge_stress(face + t, q + 1) - edge_stress(face, q)) / mesh.h(b, q);
    }
    return force;
}

void find_wall_drag(const GridSettings& settings, GridScratch& s) {
    const Mesh& mesh = settings.mesh;
    const CellBox& box = mesh.box;
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t sa = box.stride[at(a)];
        const auto& distance = s.open.wall_distance[at(a)];
        for_faces(box, a, [&](std::int64_t f, int i, int j, int k) {
            double& drag = s.wall_drag[at(a)][at(f)];
            drag = 0;
            if (s.area[at(a)][at(f)] == 0) {
                return;
            }
            const std::array<int, 3> place{i, j, k};
            const double mu = 0.5 * (s.viscosity[at(f - sa)] + s.viscosity[at(f)]);
            const double here = distance[at(f)];
            if (here <= 0) {  // the open part of the face is a layer beside the solid
                const double h = mesh.smallest_width(), layer = std::max(s.open.area[at(a)][at(f)], least_distance) * h;
                drag = 2 * mu / (layer * layer);
                return;
            }
            for (int b = 0; b < box.axes; ++b) {
                const int q = place[at(b)];
                const double h = b == a ? mesh.d(a, q) : mesh.h(b, q);
                for (const std::int64_t side : {-box.stride[at(b)], box.stride[at(b)]}) {
                    const double there = distance[at(f + side)];
                    if (there <= 0) {
                        const double share = std::max(here / (here - there), least_distance);
                        drag += (b == a ? 2 : 1) * mu / (share * h * h);
                    }
                }
            }
        });
    }
}

}  // namespace riprap::fluid::grid
