// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/bodies_in_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/mps/separation.hpp"

namespace riprap::fluid {
namespace mps {
namespace {

using Six = std::array<double, 6>;
using SixBySix = std::array<double, 36>;  ///< by rows

Six to_six(const Vec3& a, const Vec3& b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }

/// Gives what a force along d at an arm does, and how accelerations move that place along d.
Six along(const Vec3& d, const Vec3& arm) { return to_six(d, cross(arm, d)); }

Six times(const SixBySix& m, const Six& x) {
    Six y{};
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            y[i] += m[6 * i + j] * x[j];
        }
    }
    return y;
}

/// A^-1 B by Gauss' elimination with the largest pivot of each column.
SixBySix solve(SixBySix a, SixBySix b) {
    for (std::size_t k = 0; k < 6; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < 6; ++i) {
            pivot = std::abs(a[6 * i + k]) > std::abs(a[6 * pivot + k]) ? i : pivot;
        }
        for (std::size_t j = 0; j < 6; ++j) {
            std::swap(a[6 * k + j], a[6 * pivot + j]);
            std::swap(b[6 * k + j], b[6 * pivot + j]);
        }
        for (std::size_t i = 0; i < 6; ++i) {
            const double factor = i == k ? 0 : a[6 * i + k] / a[6 * k + k];
            for (std::size_t j = 0; j < 6 && factor != 0; ++j) {
                a[6 * i + j] -= factor * a[6 * k + j];
                b[6 * i + j] -= factor * b[6 * k + j];
            }
        }
    }
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            b[6 * i + j] /= a[6 * i + i];
        }
    }
    return b;
}

/// Appends the entries of particle i, one a body that it meets, in the order of its boundary particles.
void add_entries(const MpsSettings& settings, const MpsLattice& lattice, const LooseBodies& bodies, std::size_t i,
                 const MpsScratch& s, std::vector<BodyEntry>& entries) {
    const MpsWeight weight = settings.weight();
    const Separation separation(settings.domain);
    const double c = lattice.second_order() * settings.rest_density;
    const double f = lattice.first_order() * settings.particle_mass / settings.rest_density;
    const std::size_t first = entries.size();
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const std::int32_t body = w < bodies.of_wall.size() ? bodies.of_wall[w] : -1;
        if (body < 0 || s.walls.follows[w] == 0) {
            continue;
        }
        const auto known = std::find_if(entries.begin() + static_cast<std::ptrdiff_t>(first), entries.end(),
                                        [body](const BodyEntry& entry) { return entry.body == body; });
        BodyEntry& entry = known != entries.end()
                               ? *known
                               : entries.emplace_back(BodyEntry{static_cast<std::int32_t>(i), body, {}, {}, {}});
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        const Six u = along(d, bodies.arm[w]);
        const double near = s.walls.share[w] * s.around.walls.weight(e);
        const double slope = weight.over_square(norm_squared(d), near);
        const bool is_mirrored = s.walls.mirrors[w] != 0;
        const double all = is_mirrored ? 0 : s.at_walls.load_weight[w];
        const double mean = all > 0 ? near / all : 0;  // share of i in the pressure of w
        const Six lean = is_mirrored ? u : along(s.at_walls.load_slope[w], bodies.arm[w]);
        const Six carry = all > 0 ? along(s.at_walls.load_moment[w] / all, bodies.arm[w]) : u;
        for (std::size_t k = 0; k < 6; ++k) {
            entry.flux[k] += c * near * u[k];
            entry.load[k] += f * (mean * lean[k] - (1 + s.walls.mirrors[w]) * slope * u[k]);
            for (std::size_t l = 0; l < 6; ++l) {
                entry.mass[6 * k + l] += f * settings.rest_density * (is_mirrored ? slope : mean) * lean[k] * carry[l];
            }
        }
    }
}

void find_entries(const MpsSettings& settings, const LooseBodies& bodies, MpsScratch& s) {
    BodiesInPressure& own = s.bodies;
    const MpsLattice lattice = settings.lattice();
    const auto count = static_cast<std::int64_t>(s.around.predicted.size());
    constexpr std::int64_t range = 1024;
    own.chunks.resize(at((count + range - 1) / range));
    parallel::for_ranges(count, range, [&](std::int64_t begin, std::int64_t end) {
        std::vector<BodyEntry>& chunk = own.chunks[at(begin / range)];
        chunk.clear();
        for (std::int64_t i = begin; i < end; ++i) {
            add_entries(settings, lattice, bodies, at(i), s, chunk);
        }
    });
    own.entries.clear();
    for (const auto& chunk : own.chunks) {
        own.entries.insert(own.entries.end(), chunk.begin(), chunk.end());
    }
}

/// (1 - M^-1 K)^-1 and that times M^-1, K = -sum of `mass`.
void find_mobility(const LooseBodies& bodies, BodiesInPressure& own) {
    std::vector<SixBySix> mass(bodies.size(), SixBySix{});
    for (const BodyEntry& entry : own.entries) {
        for (std::size_t k = 0; k < 36; ++k) {
            mass[at(entry.body)][k] += entry.mass[k];
        }
    }
    own.inverse.resize(bodies.size());
    own.mobility.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        SixBySix lightness{}, one{}, system{};  // M^-1, 1, 1 + M^-1 (-K)
        for (std::size_t column = 0; column < 6; ++column) {
            Vec3 axis{};
            axis[static_cast<int>(column % 3)] = 1;
            const double along = bodies.lightness[b][static_cast<int>(column % 3)];
            const Vec3 answer = column < 3 ? along * axis : bodies.inverse_inertia[b] * axis;
            for (int k = 0; k < 3; ++k) {
                lightness[6 * (at(k) + (column < 3 ? 0 : 3)) + column] = answer[k];
            }
            one[7 * column] = 1;
        }
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t j = 0; j < 6; ++j) {
                system[6 * i + j] = one[6 * i + j];
                for (std::size_t k = 0; k < 6; ++k) {
                    system[6 * i + j] += lightness[6 * i + k] * mass[b][6 * k + j];
                }
            }
        }
        own.inverse[b] = solve(system, one);
        own.mobility[b] = solve(system, lightness);
    }
}

/// Accelerations H L S p that pressures give bodies.
std::vector<Six> respond(const MpsScratch& s, std::span<const double> pressure) {
    std::vector<Six> load(s.bodies.mobility.size(), Six{});
    for (const BodyEntry& entry : s.bodies.entries) {
        const std::int32_t row = s.equation.unknown[at(entry.particle)];
        if (row < 0 || !(s.water.pressure[at(entry.particle)] > 0)) {
            continue;
        }
        for (std::size_t k = 0; k < 6; ++k) {
            load[at(entry.body)][k] += entry.load[k] * pressure[at(row)];
        }
    }
    for (std::size_t b = 0; b < load.size(); ++b) {
        load[b] = times(s.bodies.mobility[b], load[b]);
    }
    return load;
}

/// y += factor B a
void add_flux(const MpsScratch& s, const std::vector<Six>& acceleration, double factor, std::span<double> y) {
    for (const BodyEntry& entry : s.bodies.entries) {
        const std::int32_t row = s.equation.unknown[at(entry.particle)];
        for (std::size_t k = 0; k < 6 && row >= 0; ++k) {
            y[at(row)] += factor * entry.flux[k] * acceleration[at(entry.body)][k];
        }
    }
}

/// A - B H L S
struct Coupled {
    const MpsScratch& s;
    std::size_t size() const { return s.equation.matrix.size(); }
    void multiply(std::span<const double> x, std::span<double> y) const {
        s.equation.matrix.multiply(x, y);
        add_flux(s, respond(s, x), -1, y);
    }
};

}  // namespace

}  // namespace mps

bool Mps::correct(const LooseBodies& bodies, std::span<const Twist> residual, std::span<Twist> change) {
    using namespace mps;
    MpsScratch& s = scratch_;
    BodiesInPressure& own = s.bodies;
    find_entries(settings_, bodies, s);
    find_mobility(bodies, own);
    std::vector<Six> direct(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        direct[b] = times(own.inverse[b], to_six(residual[b].linear, residual[b].angular));
    }
    own.right.assign(s.equation.matrix.size(), 0);
    own.solution.resize(s.equation.matrix.size());
    add_flux(s, direct, 1, own.right);
    constexpr double tolerance = 1e-5;  // of a correction: Newton's method makes good what is left
    const linear::SolveReport report =
        linear::solve_bicgstab(Coupled{s}, s.equation.preconditioner, own.right, own.solution,
                               {tolerance, 0, settings_.max_iterations}, own.solver);
    const std::vector<Six> follow = respond(s, own.solution);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const auto sum = [&](std::size_t k) { return direct[b][k] + follow[b][k]; };
        change[b] = {{sum(0), sum(1), sum(2)}, {sum(3), sum(4), sum(5)}};
    }
    return report.is_converged();
}

}  // namespace riprap::fluid
