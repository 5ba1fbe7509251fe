// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/grid/k_epsilon.hpp"

#include <cmath>

#include "riprap/fluid/grid/boundary.hpp"
#include "riprap/fluid/grid/momentum.hpp"

namespace riprap::fluid::grid {

namespace {

// Constants of [Launder1974]; sigma_t of the buoyancy, lambda_2 of [Larsen2018].
constexpr double c_mu = 0.09, c_1 = 1.44, c_2 = 1.92, sigma_k = 1.0, sigma_epsilon = 1.3, sigma_t = 0.85;
constexpr double lambda_2 = 0.05;
constexpr double realizable = 0.6;                        ///< alpha of [Durbin1996]
constexpr double least_k = 1e-12, least_epsilon = 1e-14;  ///< floors [m^2/s^2], [m^2/s^3]
constexpr double start_k = 1e-8, start_epsilon = 1e-4;    ///< of still water [m^2/s^2], [m^2/s^3]

/// Gradient of the filter velocity in a cell, [component][axis] [1/s].
std::array<std::array<double, 3>, 3> velocity_gradient(const Mesh& mesh, const GridState& state, std::int64_t c,
                                                       const std::array<int, 3>& place) {
    std::array<std::array<double, 3>, 3> gradient{};
    const CellBox& box = mesh.box;
    for (int a = 0; a < box.axes; ++a) {
        const auto& u = state.velocity[at(a)];
        const std::int64_t sa = box.stride[at(a)];
        for (int b = 0; b < box.axes; ++b) {
            const std::int64_t t = box.stride[at(b)];
            const int p = place[at(b)];
            gradient[at(a)][at(b)] = a == b
                                         ? (u[at(c + t)] - u[at(c)]) / mesh.h(b, p)
                                         : 0.5 * (u[at(c + t)] + u[at(c + t + sa)] - u[at(c - t)] - u[at(c - t + sa)]) /
                                               (mesh.d(b, p) + mesh.d(b, p + 1));
        }
    }
    return gradient;
}

/// 2 |sym grad u|^2 and 2 |skew grad u|^2 [1/s^2].
struct Rates {
    double strain{0}, rotation{0};
};
Rates rates_of(const std::array<std::array<double, 3>, 3>& g) {
    Rates rates;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            rates.strain += 0.5 * std::pow(g[a][b] + g[b][a], 2);
            rates.rotation += 0.5 * std::pow(g[a][b] - g[b][a], 2);
        }
    }
    return rates;
}

/// Size of the filter velocity in the middle of a cell [m/s].
double cell_speed(const Mesh& mesh, const GridState& state, std::int64_t c) {
    double square = 0;
    for (int a = 0; a < mesh.box.axes; ++a) {
        const auto& u = state.velocity[at(a)];
        square += std::pow(0.5 * (u[at(c)] + u[at(c + mesh.box.stride[at(a)])]), 2);
    }
    return std::sqrt(square);
}

/// Distance from the centre of a cell to the nearest side with the log law, 0 where it does not touch one [m].
double wall_distance(const GridSettings& settings, const std::array<int, 3>& place) {
    const CellBox& box = settings.mesh.box;
    double nearest = 0;
    for (int side = 0; side < 2 * box.axes; ++side) {
        const int a = side / 2, p = side % 2 == 0 ? 0 : box.cells[at(a)] - 1;
        if (settings.side[at(side)].kind == SideKind::wall_function && place[at(a)] == p) {
            const double distance = 0.5 * settings.mesh.h(a, p);
            nearest = nearest > 0 ? std::min(nearest, distance) : distance;
        }
    }
    return nearest;
}

/// Production and destruction of turbulence in a cell.
struct Sources {
    double production;          ///< nu_t S^2 [m^2/s^3]
    double buoyancy;            ///< (nu_t/sigma_t) g.grad rho/rho, a sink where water lies below air [m^2/s^3]
    double k_stones, e_stones;  ///< epsilon_inf and C_2 epsilon_inf^2/k_inf
};

Sources find_sources(const GridSettings& settings, const GridState& state, const GridScratch& s, std::int64_t c,
                     const std::array<int, 3>& place) {
    const Mesh& mesh = settings.mesh;
    const double nu_t = s.stress.eddy_viscosity[at(c)], density = density_of(settings, state.fraction[at(c)]);
    Sources sources{nu_t * rates_of(velocity_gradient(mesh, state, c, place)).strain, 0, 0, 0};
    const Vec3 g = body_force(settings, state.time);
    if (settings.has_surface) {
        for (int a = 0; a < mesh.box.axes; ++a) {
            const std::int64_t t = mesh.box.stride[at(a)];
            const int p = place[at(a)];
            // cells filled by solids have no density; nor does air beside water turn over as fast as g says: the
            // density is that of both cells
            const auto beside = [&](std::int64_t other) {
                return s.room.capacity[at(other)] > 0 ? density_of(settings, state.fraction[at(other)]) : density;
            };
            const double below = beside(c - t), above = beside(c + t);
            sources.buoyancy += nu_t / sigma_t * g[a] * (above - below) / (mesh.d(a, p) + mesh.d(a, p + 1)) /
                                std::max({density, below, above});
        }
    }
    const double n = s.medium.has_stones ? s.medium.porosity[at(c)] : 1;
    if (n < 1) {
        const double square = std::pow(cell_speed(mesh, state, c), 2);
        const double k_inf = 3.7 * (1 - n) / std::sqrt(n) * square;
        const double e_inf = 39 * std::pow(1 - n, 2.5) / n * std::pow(square, 1.5) / s.medium.grain_size[at(c)];
        sources.k_stones = e_inf;
        sources.e_stones = k_inf > 0 ? c_2 * e_inf * e_inf / k_inf : 0;
    }
    return sources;
}

/// A cell into which a step brings more than this share of its mass takes the mean of what is there and comes in [-].
constexpr double most_flushed = 0.45;

/// A cell quantity after it was carried and diffused over the step, explicit. Slivers beside solids, which a step
/// flushes, take a weighted mean: positive and bounded for any step, and nearly the same weights for k and epsilon, so
/// that k^2/epsilon stays near those around.
double carried(const GridSettings& settings, const GridState& state, const GridScratch& s, const std::vector<double>& q,
               double sigma, std::int64_t c, const std::array<int, 3>& place, double dt) {
    const Mesh& mesh = settings.mesh;
    const double before = s.inertia.mass_before[at(c)];
    double sum = before * q[at(c)], mean = sum, weight = before;
    for (int a = 0; a < mesh.box.axes; ++a) {
        const std::int64_t t = mesh.box.stride[at(a)];
        for (const int side : {0, 1}) {
            const std::int64_t f = side == 0 ? c : c + t, other = side == 0 ? c - t : c + t;
            const double mass = s.inertia.mass_flux[at(a)][at(f)];
            const double in = side == 0 ? mass : -mass;
            sum += in > 0 ? in * q[at(other)] : in * q[at(c)];
            const auto conductivity = [&](std::int64_t cell) {  // s.stress.viscosity has all of the eddies
                const double density = density_of(settings, state.fraction[at(cell)]);
                return s.stress.viscosity[at(cell)] + (1 / sigma - 1) * density * s.stress.eddy_viscosity[at(cell)];
            };
            const double area = s.room.area[at(a)][at(f)], distance = mesh.d(a, place[at(a)] + side);
            const double exchanged = dt * area * 0.5 * (conductivity(c) + conductivity(other)) / distance;
            sum += exchanged * (q[at(other)] - q[at(c)]);
            mean += (std::max(0.0, in) + exchanged) * q[at(other)];
            weight += std::max(0.0, in) + exchanged;
        }
    }
    if (s.open.has_bodies && weight - before > most_flushed * std::min(before, s.inertia.mass[at(c)])) {
        return weight > 0 ? mean / weight : q[at(c)];
    }
    return sum / s.inertia.mass[at(c)];
}

}  // namespace

void start_turbulence(const GridSettings& settings, GridState& state) {
    if (settings.turbulence != Turbulence::laminar) {
        state.turbulent_energy.assign(at(settings.mesh.box.size), start_k);
        state.dissipation_rate.assign(at(settings.mesh.box.size), start_epsilon);
    }
}

void find_eddy_viscosity(const GridSettings& settings, const GridState& state, GridScratch& s) {
    const Mesh& mesh = settings.mesh;
    for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        const double energy = state.turbulent_energy[at(c)];
        double rate = state.dissipation_rate[at(c)];
        if (settings.turbulence == Turbulence::k_epsilon_stable) {
            const Rates rates = rates_of(velocity_gradient(mesh, state, c, {i, j, k}));
            // where the strain is fast against k/epsilon, normal stresses would be negative and k grow without bound
            const double strained = std::sqrt(3 * rates.strain) * c_mu / realizable * energy;
            rate = std::max(
                {rate, strained, lambda_2 * c_2 / c_1 * rates.strain / std::max(rates.rotation, 1e-300) * rate});
        }
        s.stress.eddy_viscosity[at(c)] = c_mu * energy * energy / rate;
    });
    // none beyond walls: viscous.cpp takes the viscosity on a wall from there
    for (int side = 0; side < 2 * mesh.box.axes; ++side) {
        const SideKind kind = settings.side[at(side)].kind;
        const double share = kind == SideKind::no_slip || kind == SideKind::wall_function ? 0 : 1;
        for_ghosts(mesh.box, side, [&](std::int64_t ghost, std::int64_t inside, int, int, int, int) {
            s.stress.eddy_viscosity[at(ghost)] = share * s.stress.eddy_viscosity[at(inside)];
        });
    }
}

void advance_turbulence(const GridSettings& settings, GridState& state, GridScratch& s, double dt) {
    const Mesh& mesh = settings.mesh;
    for (auto* field : {&state.turbulent_energy, &state.dissipation_rate}) {
        mirror_ghosts(mesh, *field);
    }
    std::vector<double> k_new = state.turbulent_energy, e_new = state.dissipation_rate;
    for_cells(mesh.box, [&](std::int64_t c, int i, int j, int k) {
        if (!(s.inertia.mass[at(c)] > 0)) {
            return;
        }
        const std::array<int, 3> place{i, j, k};
        const double energy = state.turbulent_energy[at(c)], rate = state.dissipation_rate[at(c)];
        Sources sources = find_sources(settings, state, s, c, place);
        const double y = wall_distance(settings, place);
        if (y > 0) {  // stress and gradient of the log law
            const double u_tau = shear_velocity(cell_speed(mesh, state, c), y, settings.water.kinematic_viscosity);
            sources.production = u_tau * u_tau * u_tau / (von_karman * y);
        }
        const double frequency = rate / energy;
        const double k_start = carried(settings, state, s, state.turbulent_energy, sigma_k, c, place, dt);
        const double e_start = carried(settings, state, s, state.dissipation_rate, sigma_epsilon, c, place, dt);
        const double sink = std::max(0.0, sources.buoyancy) / energy, gain = std::max(0.0, -sources.buoyancy);
        k_new[at(c)] =
            std::max(least_k, (std::max(0.0, k_start) + dt * (sources.production + gain + sources.k_stones)) /
                                  (1 + dt * (frequency + sink)));
        e_new[at(c)] = std::max(
            least_epsilon,
            (std::max(0.0, e_start) + dt * (c_1 * (sources.production + gain) * frequency + sources.e_stones)) /
                (1 + dt * c_2 * frequency));
        if (y > 0) {
            e_new[at(c)] = std::pow(c_mu, 0.75) * std::pow(k_new[at(c)], 1.5) / (von_karman * y);
        }
    });
    state.turbulent_energy = std::move(k_new);
    state.dissipation_rate = std::move(e_new);
    find_eddy_viscosity(settings, state, s);
}

}  // namespace riprap::fluid::grid
