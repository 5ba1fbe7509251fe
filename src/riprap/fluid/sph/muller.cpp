// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/sph/forces.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/muller_kernels.hpp"
#include "riprap/fluid/sph/schemes.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid {
namespace {

/// Returns the sum over a square (cubic) lattice over the rest density, divided out of every sum [-].
double lattice_excess(const SphSettings& settings, const Poly6Kernel& kernel) {
    const double dp = settings.spacing, radius = settings.support_radius();
    const int reach = static_cast<int>(radius / dp) + 1, layers = settings.domain.dimension == 2 ? 0 : reach;
    double sum = 0;
    for (int k = -layers; k <= layers; ++k) {
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) {
                sum += kernel.value_at(dp * dp * static_cast<double>(i * i + j * j + k * k));
            }
        }
    }
    return sum * settings.particle_mass / settings.rest_density;
}

void sum_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, SphScratchData& s) {
    const DensitySum pair{Poly6Kernel(settings.support_radius(), settings.domain.dimension)};
    const double scale = 1 / lattice_excess(settings, pair.kernel);
    s.water.mass.fill(1, settings.is_plain, {scale * settings.particle_mass});
    s.walls.mass.resize(walls.position.size(), settings.is_plain);
    for (std::size_t w = 0; w < s.walls.mass.size(); ++w) {
        s.walls.mass.set(w, scale * settings.rest_density * walls.volume[w]);
    }
    make_zero(state.density, state.position.size());
    add_pair_sums_within(settings, pair, {state.position, {s.water.mass.view()}}, {sink(state.density)},
                         s.lists.fluid_fluid);
    add_pair_sums(settings, pair, {state.position, {s.water.mass.view()}}, {walls.position, {s.walls.mass.view()}},
                  {sink(state.density)}, s.lists.fluid_walls);
}

SpikyKernel spiky(const SphSettings& settings) { return {settings.support_radius(), settings.domain.dimension}; }

/// Calls work(pair) with the viscosity of the case between pairs of particles.
template <class Work>
void with_viscosity(const SphSettings& settings, const Work& work) {
    settings.viscosity.visit([&](const auto& law) { work(law.pair(settings, spiky(settings))); });
}

void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& s) {
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    sum_density(settings, state, walls, s);
    find_pressure(settings, columns_of(state), s.water);
    const double nu = settings.viscosity.visit([&](const auto& law) { return law.kinematic(settings, 0); });
    const auto count = state.position.size();
    s.water.dynamic_viscosity.fill(1, settings.is_plain, {settings.rest_density * nu});
    s.water.bareness.fill(count, settings.is_plain, {0});
    s.water.correction.fill(count, settings.is_plain, unit_tensor);  // gradients are left as they are
    make_room_for_forces(settings, state.size(), s.forces);
    s.forces.wall_heat.fill(count, settings.is_plain, {0});
    sum_at_walls(settings, spiky(settings), columns_of(state), columns_of(walls), s);
    with_viscosity(settings,
                   [&](const auto& law) { add_fluid_forces(settings, spiky(settings), columns_of(state), law, s); });
}

void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratchData& s) {
    const WallColumns at = columns_of(walls);
    extrapolate_to_walls(settings, s.at_walls, gravity, at, s.walls);
    with_viscosity(settings, [&](const auto& law) {
        find_forces_on_walls(settings, spiky(settings), columns_of(state), at, law, s);
    });
}

void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& s, FluidReport& report, const SparseVectors& extra_force) {
    with_viscosity(settings, [&](const auto& law) {
        add_forces_from_walls(settings, spiky(settings), columns_of(state), columns_of(walls), law, s);
    });
    kick(settings, state, gravity, dt, s, extra_force, report);
    book_walls(walls, dt, report);
}

}  // namespace

const Scheme muller_scheme{nullptr, begin_forces, load_walls, kick_fluid};

}  // namespace riprap::fluid
