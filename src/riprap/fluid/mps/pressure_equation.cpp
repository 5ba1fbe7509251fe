// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/crowding.hpp"
#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/mps/separation.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"

namespace riprap::fluid {

using mps::Crowding;
using mps::Separation;

namespace {

/// n**/n_0 and whether p = 0: too few neighbours, and those to one side.
void look_around(const MpsSettings& settings, const Crowding& crowding, std::size_t i, MpsScratch& s) {
    const Separation separation(settings.domain);
    double sum = 0;
    Vec3 moment{};
    const auto add = [&](const Vec3& d, double share, double weight) {
        const double part = share * crowding.of_pair(norm_squared(d), weight);
        sum += part;
        moment += part * d;
    };
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        add(separation(s.around.predicted[i], s.around.predicted[s.around.fluid.index(e)]), 1,
            s.around.fluid.weight(e));
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        add(separation(s.around.predicted[i], s.around.predicted_walls[w]), s.walls.share[w], s.around.walls.weight(e));
    }
    s.around.density[i] = (sum + crowding.own()) / crowding.full();
    const bool is_bare = s.around.density[i] < settings.surface_density;
    s.around.surface[i] = is_bare && norm(moment) >= settings.surface_offset * settings.spacing * sum ? 1 : 0;
}

void number_unknowns(MpsScratch& s) {
    s.equation.unknown.resize(s.around.surface.size());
    parallel::for_each(static_cast<std::int64_t>(s.around.surface.size()), [&](std::int64_t i) {
        s.equation.unknown[static_cast<std::size_t>(i)] = s.around.surface[static_cast<std::size_t>(i)] != 0 ? 0 : 1;
    });
    const std::int32_t total = parallel::exclusive_scan<std::int32_t>(s.equation.unknown, s.equation.unknown);
    s.equation.particle.resize(static_cast<std::size_t>(total));
    parallel::for_each(static_cast<std::int64_t>(s.around.surface.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        if (s.around.surface[i] != 0) {
            s.equation.unknown[i] = -1;
        } else {
            s.equation.particle[static_cast<std::size_t>(s.equation.unknown[i])] = static_cast<std::int32_t>(i);
        }
    });
}

/// f(column) for the unknowns that row i couples to, ascending, with the weight; i itself with 0 in its place.
template <class F>
void for_couplings(const MpsScratch& s, std::size_t i, const F& f) {
    bool has_self = false;
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        if (j > i && !has_self) {
            f(s.equation.unknown[i], 0.0);
            has_self = true;
        }
        if (s.equation.unknown[j] >= 0) {
            f(s.equation.unknown[j], s.around.fluid.weight(e));
        }
    }
    if (!has_self) {
        f(s.equation.unknown[i], 0.0);
    }
}

linear::BlockPattern pattern_of(const MpsScratch& s) {
    linear::BlockPattern pattern;
    pattern.start.assign(s.equation.particle.size() + 1, 0);
    const auto rows = static_cast<std::int64_t>(s.equation.particle.size());
    const auto particle = [&](std::int64_t row) {
        return static_cast<std::size_t>(s.equation.particle[static_cast<std::size_t>(row)]);
    };
    parallel::for_each_uneven(rows, 256, [&](std::int64_t row) {
        for_couplings(s, particle(row), [&](std::int32_t, double) { ++pattern.start[static_cast<std::size_t>(row)]; });
    });
    pattern.column.resize(
        static_cast<std::size_t>(parallel::exclusive_scan<std::int64_t>(pattern.start, pattern.start)));
    parallel::for_each_uneven(rows, 256, [&](std::int64_t row) {
        auto entry = static_cast<std::size_t>(pattern.first(row));
        for_couplings(s, particle(row), [&](std::int32_t column, double) { pattern.column[entry++] = column; });
    });
    return pattern;
}

void fill_matrix(const MpsSettings& settings, const MpsLattice& lattice, double dt, MpsScratch& s) {
    const double c = lattice.second_order();
    const double compression = settings.rest_density * settings.compressibility / (dt * dt);
    parallel::for_each_uneven(s.equation.matrix.rows(), 256, [&](std::int64_t row) {
        const auto i = static_cast<std::size_t>(s.equation.particle[static_cast<std::size_t>(row)]);
        double diagonal = compression;
        for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
            diagonal += c * s.around.fluid.weight(e);
        }
        for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
            const std::size_t w = s.around.walls.index(e);
            diagonal += (1 - s.walls.follows[w]) * c * s.walls.share[w] * s.around.walls.weight(e);
        }
        std::int64_t entry = s.equation.matrix.pattern().first(row);
        for_couplings(s, i, [&](std::int32_t column, double weight) {
            s.equation.matrix.at(entry++, 0, 0) = column == row ? diagonal : -c * weight;
        });
    });
}

/// div u** = D/n_0 sum v.d W/r^2, with walls as in wcmps::NumberContinuityAtWalls. Walls have u** too, u_n + dt g: what
/// they accelerate otherwise is in the pressure that they mirror, and gravity would count twice if it closed the gap to
/// them here.
double divergence(const MpsSettings& settings, const ParticleState& state, const MpsScratch& s,
                  const Separation& separation, std::size_t i) {
    const MpsWeight weight = settings.weight();
    double sum = 0;
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted[j]);
        sum += dot(state.velocity[i] - state.velocity[j], d) *
               weight.over_square(norm_squared(d), s.around.fluid.weight(e));
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        sum += (1 + s.walls.mirrors[w]) * s.walls.share[w] * dot(state.velocity[i] - s.walls.start_velocity[w], d) *
                   weight.over_square(norm_squared(d), s.around.walls.weight(e)) +
               s.walls.share[w] * s.walls.openings.share[w] * s.around.walls.weight(e);
    }
    return sum;
}

}  // namespace

void Mps::share_openings(const ParticleState& state, const BoundaryParticles& walls) {
    MpsScratch& s = scratch_;
    if (settings_.wall_pressure == MpsWallPressure::mirrored) {
        s.walls.openings.share.assign(s.around.predicted_walls.size(), 0);
        return;
    }
    s.around.ones.assign(s.around.predicted.size(), 1.0);
    const MpsOpeningSides sides{s.around.predicted_walls, s.walls.start_velocity, walls.normal, s.walls.share,
                                s.around.predicted,       state.velocity,         s.around.ones};
    find_wall_openings(
        weight_, sides, [&](std::size_t w) { return s.walls.follows[w] != 0; },
        [&](const auto& pair, const auto& targets, const auto& candidates, const auto& sums, bool is_among_walls) {
            add_pair_sums(settings_, pair, targets, candidates, sums,
                          is_among_walls ? s.lists.walls_walls : s.lists.walls_fluid);
        },
        s.walls.openings);
}

void Mps::set_up_pressure(const ParticleState& state, const BoundaryParticles& walls, double dt) {
    MpsScratch& s = scratch_;
    const auto count = state.position.size();
    s.around.predicted.resize(count);
    s.around.density.resize(count);
    s.around.surface.resize(count);
    parallel::for_each(state.size(), [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        s.around.predicted[k] = state.position[k] + 0.5 * dt * state.velocity[k];
    });
    s.around.predicted_walls.resize(walls.position.size());
    parallel::for_each(walls.size(), [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        s.around.predicted_walls[k] = walls.position[k] + 0.5 * dt * walls.velocity[k];
    });
    s.lists.place(reach_of(settings_), state.blocks(), s.around.predicted, s.around.predicted_walls);
    s.around.fluid.find(settings_, s.around.predicted, s.around.predicted, true);
    s.around.walls.find(settings_, s.around.predicted, s.around.predicted_walls, false);
    const Crowding crowding(settings_);
    parallel::for_each_uneven(
        state.size(), 256, [&](std::int64_t i) { look_around(settings_, crowding, static_cast<std::size_t>(i), s); });
    number_unknowns(s);
    s.equation.matrix.set_pattern(pattern_of(s));
    fill_matrix(settings_, lattice_, dt, s);
    s.equation.preconditioner.set_up(s.equation.matrix);
}

linear::SolveReport Mps::solve_pressure(const ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                                        double dt) {
    MpsScratch& s = scratch_;
    const Separation separation(settings_.domain);
    const double c = lattice_.second_order();
    const double flow = settings_.divergence_share * lattice_.first_order() * settings_.rest_density / dt;
    const double stiffness = settings_.relaxation * settings_.rest_density / (dt * dt);
    s.walls.head.resize(walls.position.size());
    s.walls.start_velocity.resize(walls.position.size());
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        s.walls.head[w] = s.walls.follows[w] * settings_.rest_density * (gravity - walls.acceleration[w]);
        s.walls.start_velocity[w] =
            walls.velocity[w] + s.walls.follows[w] * dt * (gravity - 0.5 * walls.acceleration[w]);
    });
    if (flow > 0) {
        share_openings(state, walls);
    }
    s.equation.right.resize(s.equation.particle.size());
    s.equation.solution.resize(s.equation.particle.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(s.equation.particle.size()), 256, [&](std::int64_t entry) {
        const auto row = static_cast<std::size_t>(entry);
        const auto i = static_cast<std::size_t>(s.equation.particle[row]);
        double flux = 0;
        for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
            const std::size_t w = s.around.walls.index(e);
            const double head = -dot(s.walls.head[w], separation(s.around.predicted[i], s.around.predicted_walls[w]));
            flux += s.walls.share[w] * s.around.walls.weight(e) * (head + s.walls.given[w]);
        }
        s.equation.right[row] = stiffness * (s.around.density[i] + state.dilution[i] - 1) + c * flux;
        if (flow > 0) {
            s.equation.right[row] -= flow * divergence(settings_, state, s, separation, i);
        }
        s.equation.solution[row] = s.water.pressure[i];
    });
    const linear::PcgSettings solver{settings_.tolerance, 0, settings_.max_iterations};
    const linear::SolveReport report = linear::solve_pcg(s.equation.matrix, s.equation.preconditioner, s.equation.right,
                                                         s.equation.solution, solver, s.equation.solver);
    parallel::for_each(static_cast<std::int64_t>(s.water.pressure.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.water.pressure[i] = s.equation.unknown[i] >= 0
                                  ? std::max(0.0, s.equation.solution[static_cast<std::size_t>(s.equation.unknown[i])])
                                  : 0.0;
    });
    return report;
}

}  // namespace riprap::fluid
