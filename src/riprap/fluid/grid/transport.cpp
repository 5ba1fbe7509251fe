// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/transport.hpp"

#include <cmath>
#include <utility>

#include "riprap/fluid/grid/viscous.hpp"

namespace riprap::fluid::grid {

namespace {

/// Velocity that a mass takes along beyond that of the cell it leaves, without the factor in time: half of Koren's
/// limiter max(0, min(2 r, (1 + 2 r)/3, 2)) times the rise, r = behind/rise, written without the quotient [m/s].
inline double half_koren(double behind, double rise) {
    const double b = std::abs(behind), r = std::abs(rise);
    const double size = std::min(std::min(2 * b, (r + 2 * b) * (1.0 / 3)), 2 * r);
    return behind * rise > 0 ? std::copysign(0.5 * size, rise) : 0.0;
}

/// Mass and momentum through the lower faces, across one axis, of velocity cells in a row.
struct RowFluxes {
    const double *first, *second;           ///< fluxes of mass whose mean is that of the velocity cell [kg]
    const double *far, *low, *high, *next;  ///< velocities at -2, -1, 0, +1 cells across the face [m/s]
    const double *mass_low, *mass_low_behind, *mass_high, *mass_high_behind;  ///< of cells, two to a velocity cell [kg]
    double in_time;  ///< 1: the value is moved upstream in time, 0: not

    void find(int n, double* mass, double* momentum) const {
        constexpr double least = 1e-300;  // keeps quotients finite where both cells are closed
#pragma GCC ivdep
        for (int i = 0; i < n; ++i) {
            const double m = 0.5 * (first[i] + second[i]);
            const bool forward = m > 0;
            const double up = forward ? low[i] : high[i], down = forward ? high[i] : low[i];
            const double behind = up - (forward ? far[i] : next[i]);
            const double left = forward ? mass_low[i] + mass_low_behind[i] : mass_high[i] + mass_high_behind[i];
            const double courant = std::min(1.0, in_time * std::abs(m) / (0.5 * left + least));
            mass[i] = m;
            momentum[i] = m * (up + (1 - courant) * half_koren(behind, down - up));
        }
    }
};

/// @param place  along b of the lower faces of the row
RowFluxes fluxes_across(const GridScratch& s, const CellBox& box, const std::vector<double>& u, int a, int b,
                        std::int64_t start, int place, bool is_midpoint) {
    const std::int64_t t = box.stride[at(b)], sa = box.stride[at(a)];
    const double *flux = s.inertia.mass_flux[at(b)].data() + start, *v = u.data() + start,
                 *mass = s.inertia.mass.data() + start;
    return {b == a ? flux - t : flux,
            b == a ? flux : flux - sa,
            v - 2 * t,
            v - t,
            v,
            b != 0 && place > box.cells[at(b)] ? v : v + t,  // beyond an open side there are two layers, no third
            mass - t,
            mass - t - sa,
            mass,
            mass - sa,
            is_midpoint ? 0.0 : 1.0};
}

/// Sums over the faces of velocity cells.
struct Sums {
    std::array<double, most_in_row> momentum, in, out, upwind;
};

}  // namespace

void find_mass_fluxes(const GridSettings& settings, GridScratch& s) {
    const CellBox& box = settings.mesh.box;
    const double water = settings.water.density, air = settings.has_surface ? settings.air.density : 0;
    for (int a = 0; a < box.axes; ++a) {
        s.inertia.mass_flux[at(a)] = std::move(s.moved.flux[at(a)]);
        const auto& wet = s.moved.water_flux[at(a)];
        auto& flux = s.inertia.mass_flux[at(a)];
        parallel::for_ranges(box.size, 4096, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                flux[at(i)] = water * wet[at(i)] + air * (flux[at(i)] - wet[at(i)]);
            }
        });
        s.projection.predicted[at(a)] = std::move(s.moved.water_flux[at(a)]);
    }
}

void carry_row(const GridSettings& settings, const GridScratch& s, const std::vector<double>& u, int a,
               bool is_midpoint, std::int64_t start, int n, const std::array<int, 3>& place, double* moved) {
    const CellBox& box = settings.mesh.box;
    const std::int64_t sa = box.stride[at(a)];
    const double *before = s.inertia.mass_before.data() + start, *after = s.inertia.mass.data() + start,
                 *old = s.start.velocity(a).data() + start, *v = u.data() + start;
    std::array<double, most_in_row + 1> low_mass, low, high_mass, high;
    Sums sums;
    for (int i = 0; i < n; ++i) {
        const double mass = 0.5 * (before[i - sa] + before[i]);
        sums.momentum[at(i)] = sums.upwind[at(i)] = mass * old[i];
        sums.in[at(i)] = sums.out[at(i)] = 0;
    }
    for (int b = 0; b < box.axes; ++b) {
        const std::int64_t t = box.stride[at(b)];
        const RowFluxes fluxes = fluxes_across(s, box, u, a, b, start, place[at(b)], is_midpoint);
        fluxes.find(b == 0 ? n + 1 : n, low_mass.data(), low.data());
        const double *m_high = low_mass.data() + 1, *f_high = low.data() + 1;
        if (b != 0) {
            fluxes_across(s, box, u, a, b, start + t, place[at(b)] + 1, is_midpoint)
                .find(n, high_mass.data(), high.data());
            m_high = high_mass.data();
            f_high = high.data();
        }
#pragma GCC ivdep
        for (int i = 0; i < n; ++i) {
            const double from_low = std::max(0.0, low_mass[at(i)]), from_high = std::max(0.0, -m_high[i]);
            sums.momentum[at(i)] += low[at(i)] - f_high[i];
            sums.in[at(i)] += from_low + from_high;
            sums.out[at(i)] += std::max(0.0, -low_mass[at(i)]) + std::max(0.0, m_high[i]);
            sums.upwind[at(i)] += from_low * v[i - t] + from_high * v[i + t];
        }
    }
    const int last = box.cells[at(a)], p = place[at(a)];
    for (int i = 0; i < n; ++i) {
        const double mass_before = 0.5 * (before[i - sa] + before[i]), mass_after = 0.5 * (after[i - sa] + after[i]);
        const int here = a == 0 ? p + i : p;
        const bool is_on_rim = here == 0 || here == last;
        const bool is_flushed =
            is_on_rim || (s.open.has_bodies && sums.in[at(i)] > 0.45 * std::min(mass_before, mass_after));
        const double left = s.open.has_bodies ? mass_before + sums.in[at(i)] - sums.out[at(i)] : mass_after;
        if (!(mass_after > 0)) {
            moved[i] = old[i];
        } else if (is_flushed) {
            const double weight = mass_before + sums.in[at(i)];
            moved[i] = weight > 0 ? sums.upwind[at(i)] / weight : old[i];
        } else {  // uncovered in this step, and nothing has come in yet: left is 0
            moved[i] = left > 0 ? sums.momentum[at(i)] / left : old[i];
        }
    }
}

}  // namespace riprap::fluid::grid
