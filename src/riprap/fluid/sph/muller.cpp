// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/sph/muller.hpp"

#include "riprap/fluid/particle/sweep/zeros.hpp"
#include "riprap/fluid/sph/density_sum.hpp"

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

}  // namespace

void Muller::sum_density(ParticleState& state, const BoundaryParticles& walls) {
    const DensitySum pair{Poly6Kernel(settings_.support_radius(), settings_.domain.dimension)};
    const double scale = 1 / lattice_excess(settings_, pair.kernel);
    mass_.fill(1, settings_.is_plain, {scale * settings_.particle_mass});
    wall_mass_.resize(walls.position.size(), settings_.is_plain);
    for (std::size_t w = 0; w < wall_mass_.size(); ++w) {
        wall_mass_.set(w, scale * settings_.rest_density * walls.volume[w]);
    }
    make_zeros(state.position.size(), state.density);
    const auto water = side(state.position, mass_);
    add_pair_sums_within(settings_, pair, water, sinks(state.density), site_.lists().fluid_fluid);
    add_pair_sums(settings_, pair, water, side(walls.position, wall_mass_), sinks(state.density),
                  site_.lists().fluid_walls);
}

void Muller::begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                          const Vec3& /*gravity*/, ParticleReport& report) {
    find_lost_particle(settings_, state, span.time, report);
    if (!report.problem.empty()) {
        return;
    }
    site_.take_for_forces(reach_of(settings_), state, walls);
    sum_density(state, walls);
    const ParticleColumns fluid = site_.water(state);
    find_pressure(fluid);
    const double nu = settings_.viscosity.visit([&](const auto& law) { return law.kinematic(settings_, 0); });
    water_.dynamic_viscosity.fill(1, settings_.is_plain, {settings_.rest_density * nu});
    water_.bareness.fill(1, settings_.is_plain, {0});
    stage_.resize(state.position.size(), settings_.is_plain, SphPlaces::count);
    corrections_ = lend_corrections(stage_);
    forces_ = lend_force_sums(stage_);
    Where::for_each(fluid.count, FillNumbers<symmetric_numbers>{corrections_.tensor, unit_tensor});  // none
    Where::for_each(fluid.count, FillNumbers<1>{forces_.wall_heat, {0}});
    sum_at_walls(fluid, site_.walls(walls));
    sum_fluid_forces(fluid);
}

void Muller::load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) {
    load(site_.water(state), site_.walls_to_load(walls), in_plane(gravity, settings_.domain));
}

void Muller::kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                  const SparseVectors& extra_force, ParticleReport& report) {
    add_forces_from_walls(site_.water(state), site_.walls(walls));
    finish_kick(state, walls, in_plane(gravity, settings_.domain), span, extra_force, report);
}

}  // namespace riprap::fluid
