// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/surface.hpp"

namespace riprap::fluid::grid {

namespace {

/// van Leer's limiter of the ratio of gradients [-].
double van_leer(double r) { return (r + std::abs(r)) / (1 + std::abs(r)); }

struct Fluxes {
    double low, high;  ///< of first order; with compression, before the limit [m^3]
};

Fluxes face_fluxes(const GridSettings& settings, const std::vector<double>& f, const GridScratch& s, int a,
                   std::int64_t face) {
    const CellBox& box = settings.mesh.box;
    const std::int64_t t = box.stride[at(a)];
    const double volume = s.moved.flux[at(a)][at(face)];
    const double below = f[at(face - t)], above = f[at(face)];
    const double up = volume > 0 ? below : above, down = volume > 0 ? above : below;
    const double far = volume > 0 ? f[at(face - 2 * t)] : f[at(face + t)];
    const double rise = down - up;
    const double r = std::abs(rise) > 1e-300 ? (up - far) / rise : 0;
    const double limited = up + 0.5 * van_leer(r) * rise;
    // compression towards the water: along the normal of the surface, as strong as the flow through the face
    std::array<double, 3> gradient{};
    gradient[at(a)] = above - below;
    for (int b = 0; b < box.axes; ++b) {
        if (b != a) {
            const std::int64_t q = box.stride[at(b)];
            gradient[at(b)] = 0.25 * (f[at(face + q)] - f[at(face - q)] + f[at(face - t + q)] - f[at(face - t - q)]);
        }
    }
    const double size = std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
    const double middle = 0.5 * (below + above);
    const double squeeze =
        size > 1e-8 ? settings.compression * std::abs(volume) * gradient[at(a)] / size * middle * (1 - middle) : 0;
    return {volume * up, volume * limited + squeeze};
}

}  // namespace

void move_water_compressive(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    (void)dt;
    const CellBox& box = settings.mesh.box;
    fill_fraction_ghosts(settings, s.start.carrier, state.time, state.fraction);
    const std::vector<double> old = state.fraction;
    std::array<std::vector<double>, 3> extra;  // high minus low
    for (int a = 0; a < box.axes; ++a) {
        extra[at(a)].assign(at(box.size), 0.0);
        for_faces(box, a, [&](std::int64_t face, int, int, int) {
            const Fluxes flux = face_fluxes(settings, old, s, a, face);
            s.moved.water_flux[at(a)][at(face)] = flux.low;
            extra[at(a)][at(face)] = flux.high - flux.low;
        });
    }
    // Zalesak's limit: what comes in or leaves beyond the first-order flux keeps cells between 0 and 1
    std::vector<double> in_share(at(box.size), 0.0), out_share(at(box.size), 0.0);
    const auto after = [&](std::int64_t c) {
        double out = 0, water = old[at(c)] * s.room.before()[at(c)];
        for (int a = 0; a < box.axes; ++a) {
            const std::int64_t t = box.stride[at(a)];
            out += s.moved.flux[at(a)][at(c + t)] - s.moved.flux[at(a)][at(c)];
            water -= s.moved.water_flux[at(a)][at(c + t)] - s.moved.water_flux[at(a)][at(c)];
        }
        return water + old[at(c)] * (out + s.room.capacity[at(c)] - s.room.before()[at(c)]);
    };
    for_cells(box, [&](std::int64_t c, int, int, int) {
        double in = 0, out = 0;
        for (int a = 0; a < box.axes; ++a) {
            const double low = extra[at(a)][at(c)], high = extra[at(a)][at(c + box.stride[at(a)])];
            in += std::max(0.0, low) + std::max(0.0, -high);
            out += std::max(0.0, -low) + std::max(0.0, high);
        }
        const double water = after(c);
        in_share[at(c)] = in > 0 ? std::clamp((s.room.capacity[at(c)] - water) / in, 0.0, 1.0) : 0;
        out_share[at(c)] = out > 0 ? std::clamp(water / out, 0.0, 1.0) : 0;
    });
    for (int a = 0; a < box.axes; ++a) {
        const std::int64_t t = box.stride[at(a)];
        for_faces(box, a, [&](std::int64_t face, int i, int j, int k) {
            const std::array<int, 3> place{i, j, k};
            const bool on_rim = place[at(a)] == 0 || place[at(a)] == box.cells[at(a)];
            const double e = extra[at(a)][at(face)];
            const double share = on_rim  ? 0
                                 : e > 0 ? std::min(in_share[at(face)], out_share[at(face - t)])
                                         : std::min(in_share[at(face - t)], out_share[at(face)]);
            s.moved.water_flux[at(a)][at(face)] += share * e;
        });
    }
    for_cells(box, [&](std::int64_t c, int, int, int) {
        if (s.room.capacity[at(c)] > 0) {
            state.fraction[at(c)] = after(c) / s.room.capacity[at(c)];
        }
    });
}

}  // namespace riprap::fluid::grid
