// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/pressure.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/mat3.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/mps/separation.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::mps {
namespace {

/// What pairs count in the number density. With the smooth weight that is Wendland's kernel (1 - q)^4 (1 + 4 q), whose
/// slope over distance is -20 W/r^2 but for its size: forces along d W/r^2 then follow from the density as from a
/// potential, and a particle counts itself. W itself falls where particles come nearer than 0.4 r_e, which lets them
/// pair and stirs water at rest. The reciprocal weight counts as it is.
class Crowding {
 public:
    explicit Crowding(const MpsSettings& settings)
        : reach_(settings.support_radius()), is_smooth_(settings.weight_law == MpsWeightLaw::smooth) {
        const double ratio = settings.support_ratio();
        const int reach = static_cast<int>(std::ceil(ratio)), reach_z = settings.domain.dimension == 3 ? reach : 0;
        full_ = is_smooth_ ? own() : settings.lattice().number_density;
        for (int z = -reach_z; is_smooth_ && z <= reach_z; ++z) {
            for (int y = -reach; y <= reach; ++y) {
                for (int x = -reach; x <= reach; ++x) {
                    const double r = settings.spacing * std::sqrt(x * x + y * y + z * z);
                    full_ += r > 0 ? of_pair(r * r, 0) : 0;
                }
            }
        }
    }
    /// @param weight  W of the pair [-]
    double of_pair(double r2, double weight) const {
        if (!is_smooth_) {
            return weight;
        }
        const double q = std::sqrt(r2) / reach_, rest = std::max(0.0, 1 - q);
        return rest * rest * rest * rest * (1 + 4 * q);
    }
    double own() const { return is_smooth_ ? 1 : 0; }  ///< of a particle itself
    double full() const { return full_; }              ///< n_0 of this count

 private:
    double reach_, full_{0};
    bool is_smooth_;
};

/// n**/n_0 and whether p = 0: too few neighbours, and those to one side.
void look_around(const MpsSettings& settings, const Crowding& crowding, std::size_t i, MpsScratchData& s) {
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

void number_unknowns(MpsScratchData& s) {
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
void for_couplings(const MpsScratchData& s, std::size_t i, const F& f) {
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

linear::BlockPattern pattern_of(const MpsScratchData& s) {
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

void fill_matrix(const MpsSettings& settings, const MpsLattice& lattice, double dt, MpsScratchData& s) {
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

/// Force on i by pairs in balance, P_i + P_j; walls have a pressure, or 2 P_i - h.d stands for both.
Vec3 conservative_force(const MpsSettings& settings, const Separation& separation, std::size_t i,
                        const MpsScratchData& s) {
    const MpsWeight weight = settings.weight();
    Vec3 force{};
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted[j]);
        force += (s.water.pressure[i] + s.water.pressure[j]) *
                 weight.over_square(norm_squared(d), s.around.fluid.weight(e)) * d;
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        const double m = s.walls.mirrors[w];
        const double push = (1 + m) * s.water.pressure[i] + s.walls.pressure[w] - m * dot(s.walls.head[w], d);
        force += push * s.walls.share[w] * weight.over_square(norm_squared(d), s.around.walls.weight(e)) * d;
    }
    return force;
}

/// n_0/D times minus the gradient that is exact for linear pressures, with P_j - min P in place of P_j - P_i.
Vec3 corrected_force(const MpsSettings& settings, const MpsLattice& lattice, const Separation& separation,
                     std::size_t i, const MpsScratchData& s) {
    const MpsWeight weight = settings.weight();
    const auto wall_pressure = [&](std::size_t w, const Vec3& d) {
        return std::max(0.0, s.walls.follows[w] * s.water.pressure[i] + s.walls.given[w] - dot(s.walls.head[w], d));
    };
    double least = s.water.pressure[i];
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        least = std::min(least, s.water.pressure[s.around.fluid.index(e)]);
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        least = std::min(least, wall_pressure(w, separation(s.around.predicted[i], s.around.predicted_walls[w])));
    }
    Vec3 sum{};
    Mat3 moment = settings.domain.dimension == 2 ? Mat3::diagonal({0, 0, lattice.number_density}) : Mat3{};
    const auto add = [&](const Vec3& d, double w, double pressure) {
        const Vec3 slope = weight.over_square(norm_squared(d), w) * d;
        sum += (pressure - least) * slope;
        moment = moment + outer(slope, d);
    };
    for (std::int64_t e = s.around.fluid.first(i); e < s.around.fluid.end(i); ++e) {
        const std::size_t j = s.around.fluid.index(e);
        add(separation(s.around.predicted[i], s.around.predicted[j]), s.around.fluid.weight(e), s.water.pressure[j]);
    }
    for (std::int64_t e = s.around.walls.first(i); e < s.around.walls.end(i); ++e) {
        const std::size_t w = s.around.walls.index(e);
        const Vec3 d = separation(s.around.predicted[i], s.around.predicted_walls[w]);
        add(d, s.walls.share[w] * s.around.walls.weight(e), wall_pressure(w, d));
    }
    const double even = lattice.number_density / settings.domain.dimension;
    const bool is_regular = determinant(moment) > 1e-3 * lattice.number_density * even * even;
    return is_regular ? even * (inverse(moment) * sum) : sum;
}

/// div u** = D/n_0 sum v.d W/r^2, with walls as in wcmps::NumberContinuityAtWalls. Walls have u** too, u_n + dt g: what
/// they accelerate otherwise is in the pressure that they mirror, and gravity would count twice if it closed the gap to
/// them here.
double divergence(const MpsSettings& settings, const ParticleState& state, const MpsScratchData& s,
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

/// Finds g of walls at r**, of the water's u**: zero where they mirror each particle or have a pressure of their own.
void share_openings(const MpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    MpsScratchData& s) {
    if (settings.wall_pressure == MpsWallPressure::mirrored) {
        s.walls.openings.share.assign(s.around.predicted_walls.size(), 0);
        return;
    }
    s.around.ones.assign(s.around.predicted.size(), 1.0);
    const wcmps::OpeningSides sides{s.around.predicted_walls, s.walls.start_velocity, walls.normal, s.walls.share,
                                    s.around.predicted,       state.velocity,         s.around.ones};
    wcmps::find_openings(
        settings.weight(), sides, [&](std::size_t w) { return s.walls.follows[w] != 0; },
        [&](const auto& pair, const auto& targets, const auto& candidates, const auto& sums, bool is_among_walls) {
            add_pair_sums(settings, pair, targets, candidates, sums,
                          is_among_walls ? s.lists.walls_walls : s.lists.walls_fluid);
        },
        s.walls.openings);
}

}  // namespace

void set_up_pressure(const MpsSettings& settings, const ParticleState& state, const BoundaryParticles& walls, double dt,
                     MpsScratchData& s) {
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
    s.lists.place({settings.support_radius(), settings.domain}, s.around.predicted, s.around.predicted_walls);
    s.around.fluid.find(settings, s.around.predicted, s.around.predicted, true);
    s.around.walls.find(settings, s.around.predicted, s.around.predicted_walls, false);
    const MpsLattice lattice = settings.lattice();
    const Crowding crowding(settings);
    parallel::for_each_uneven(state.size(), 256,
                              [&](std::int64_t i) { look_around(settings, crowding, static_cast<std::size_t>(i), s); });
    number_unknowns(s);
    s.equation.matrix.set_pattern(pattern_of(s));
    fill_matrix(settings, lattice, dt, s);
    s.equation.preconditioner.set_up(s.equation.matrix);
}

linear::SolveReport solve_pressure(const MpsSettings& settings, const ParticleState& state,
                                   const BoundaryParticles& walls, const Vec3& gravity, double dt, MpsScratchData& s) {
    const MpsLattice lattice = settings.lattice();
    const Separation separation(settings.domain);
    const double c = lattice.second_order();
    const double flow = settings.divergence_share * lattice.first_order() * settings.rest_density / dt;
    const double stiffness = settings.relaxation * settings.rest_density / (dt * dt);
    s.walls.head.resize(walls.position.size());
    s.walls.start_velocity.resize(walls.position.size());
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        s.walls.head[w] = s.walls.follows[w] * settings.rest_density * (gravity - walls.acceleration[w]);
        s.walls.start_velocity[w] =
            walls.velocity[w] + s.walls.follows[w] * dt * (gravity - 0.5 * walls.acceleration[w]);
    });
    if (flow > 0) {
        share_openings(settings, state, walls, s);
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
            s.equation.right[row] -= flow * divergence(settings, state, s, separation, i);
        }
        s.equation.solution[row] = s.water.pressure[i];
    });
    const linear::PcgSettings solver{settings.tolerance, 0, settings.max_iterations};
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

void find_pressure_forces(const MpsSettings& settings, MpsScratchData& s) {
    const MpsLattice lattice = settings.lattice();
    const Separation separation(settings.domain);
    const double factor = lattice.first_order() * settings.particle_mass / settings.rest_density;
    s.water.pressure_force.resize(s.around.predicted.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(s.around.predicted.size()), 256, [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        s.water.pressure_force[i] = factor * (settings.gradient == MpsGradient::conservative
                                                  ? conservative_force(settings, separation, i, s)
                                                  : corrected_force(settings, lattice, separation, i, s));
    });
}

}  // namespace riprap::fluid::mps
