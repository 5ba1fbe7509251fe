// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fluid/sph/water.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/key.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/schemes.hpp"

namespace riprap::fluid::testing {
namespace {

/// A column of water beside a dry floor, stepped as the driver does it: through the interface of all schemes.
template <class Settings>
struct Dam {
    Settings settings;
    ParticleState state;
    BoundaryParticles walls;
    Vec3 gravity{0, -9.81, 0};
    std::unique_ptr<ParticleScheme> scheme;
    double time{0}, last_dt{0}, given{0};
    FluidReport report;
    Vec3 impulse{};

    explicit Dam(const Settings& chosen = {}) : settings(chosen) {
        Water water;
        water.settings = settings_2d(0.5 / 16, 20 * std::sqrt(9.81 * 0.5));
        add_tank(water, 1.0, 0.75, true);
        walls = water.walls;
        ParticleSettings& base = settings;
        base.spacing = water.settings.spacing;
        base.sound_speed = water.settings.sound_speed;
        base.particle_mass = water.settings.particle_mass;
        base.domain = water.settings.domain;
        for_lattice(base.spacing, 0.5, 0.5, [&](double x, double y) {
            state.add({x, y, 0}, {}, density_of(base, 1000 * 9.81 * (0.5 - y)),
                      static_cast<std::int32_t>(state.size()));
        });
        scheme = make_scheme(settings);
    }
    double stored() const { return report.kinetic + report.potential + report.internal; }

    void step() {
        const double dt = scheme->limit(state).limit;
        const TimeSpan span{time, dt};
        report = {};
        scheme->update_density(state, walls, gravity, 0.5 * (last_dt + dt), report);
        drift(settings, state, 0.5 * dt);
        scheme->begin_forces(state, walls, span, gravity, report);
        scheme->load_walls(state, walls, gravity);
        scheme->load_walls(state, walls, gravity);  // as light bodies make the driver do
        scheme->kick(state, walls, gravity, span, {}, report);
        drift(settings, state, 0.5 * dt);
        given += report.dissipated_viscous + report.dissipated_collisions + report.dissipated_diffusion +
                 report.pressure_loss + report.shifted + report.work_on_solids + report.wall_exchange +
                 report.earlier_heat + report.earlier_collisions + report.earlier_exchange - report.work_external;
        impulse += report.impulse;
        time += dt;
        last_dt = dt;
    }
    void run_until(double end) {
        while (time < end && report.problem.empty()) {
            step();
        }
    }
};

/// delta_sph by the loops of a device, which has the bits of the host here.
struct SphOnDevice : SphSettings {
    SphOnDevice() { runs_on = RunsOn::device; }
};

template <class Settings>
class EveryScheme : public ::testing::Test {};
using AllSettings = ::testing::Types<SphSettings, SphOnDevice, WcmpsSettings, MpsSettings>;
TYPED_TEST_SUITE(EveryScheme, AllSettings);

TYPED_TEST(EveryScheme, books_the_energy_and_momentum_of_a_dam_break) {
    Dam<TypeParam> dam;
    dam.step();
    const double start = dam.stored() + dam.given, potential = dam.report.potential;
    const Vec3 momentum = dam.report.momentum - dam.impulse;
    dam.run_until(0.4);
    ASSERT_EQ(dam.report.problem, "");
    const double turnover = potential - dam.report.potential;
    EXPECT_GT(turnover, 0.3 * potential);
    EXPECT_NEAR(dam.stored() + dam.given, start, 0.01 * turnover);
    EXPECT_LT(norm(dam.report.momentum - momentum - dam.impulse), 1e-6 * dam.report.mass * 9.81 * dam.time);
}

TYPED_TEST(EveryScheme, has_the_same_bits_with_two_threads_and_when_it_is_made_anew_between_steps) {
    const auto hash = [](int threads, bool is_made_anew) {
        parallel::set_thread_count(threads);
        Dam<TypeParam> dam;
        for (int k = 0; k < 10; ++k) {
            if (is_made_anew) {
                dam.scheme = make_scheme(dam.settings);
            }
            dam.step();
        }
        parallel::set_thread_count(1);
        return hash_fields(dam.state);
    };
    const std::uint64_t one = hash(1, false);
    EXPECT_EQ(hash(2, false), one);
    EXPECT_EQ(hash(1, true), one);
}

TEST(MpsFluid, tells_of_an_equation_that_it_cannot_solve_when_it_is_to_kick) {
    MpsSettings settings;
    settings.max_iterations = 1;
    settings.tolerance = 1e-10;
    Dam<MpsSettings> dam(settings);
    dam.step();
    EXPECT_THAT(dam.report.problem, ::testing::AllOf(::testing::HasSubstr("is not solved"),
                                                     ::testing::HasSubstr("after 1 iterations, residual ")));
    EXPECT_THAT(dam.report.remedy, ::testing::StartsWith("more fluid.max_iterations or a larger fluid.tolerance; "));
}

TEST(SchemeKeys, words_and_defaults_are_those_of_the_settings) {
    const auto names = [](const auto& keys) {
        std::vector<std::string> all;
        for (const auto& key : keys) {
            all.emplace_back(key.row.name);
        }
        return all;
    };
    EXPECT_THAT(names(WcmpsSettings::keys().keys), ::testing::IsSupersetOf({"spacing", "courant", "shifting"}));
    EXPECT_THAT(names(MpsSettings::keys().keys), ::testing::IsSupersetOf({"spacing", "gradient", "tolerance"}));
    EXPECT_NEAR(WcmpsSettings().support_ratio(), 3.1, 1e-12);
    EXPECT_NEAR(MpsSettings().support_ratio(), 3.1, 1e-12);
}

}  // namespace
}  // namespace riprap::fluid::testing
