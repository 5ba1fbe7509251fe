// SPDX-License-Identifier: Apache-2.0
// What changes the volume m/rho of water, by cause: a dam break, which tears, shifts and returns.
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "fluid/dam.hpp"

namespace riprap::fluid::testing {
namespace {

double volume_of(const ParticleSettings& settings, const ParticleState& state) {
    double volume = 0;
    for (const double density : state.density) {
        volume += settings.particle_mass / density;
    }
    return volume;
}

struct Booked {
    VolumeBook volume;
    double by_diffusion{0};  ///< energy that diffusion took [J]
    double miss{0};          ///< largest of a step, of the book against the volumes [m^3]
    double before{0};        ///< volume at the start [m^3]
    double most_torn{0};     ///< largest gain of volume of a step by tearing and at walls, which only lose [m^3]
};

template <class Settings>
Booked break_dam(const Settings& settings) {
    Dam<Settings> dam(settings);
    Booked booked;
    double volume = booked.before = volume_of(dam.settings, dam.state);
    while (dam.time < 0.4 && dam.report.problem.empty()) {
        dam.step();
        const double after = volume_of(dam.settings, dam.state);
        booked.miss = std::max(booked.miss, std::abs(dam.report.volume.sum() - (after - volume)));
        booked.most_torn = std::max({booked.most_torn, dam.report.volume.tearing, dam.report.volume.walls});
        parallel::JoinBy<parallel::AddRounded>{}.add(booked.volume, dam.report.volume);
        booked.by_diffusion += dam.report.by_density.diffusion;
        volume = after;
    }
    EXPECT_EQ(dam.report.problem, "");
    return booked;
}

template <class Settings>
class VolumeOf : public ::testing::Test {};
using CarryingSettings = ::testing::Types<SphSettings, SphOnDevice, WcmpsSettings>;
TYPED_TEST_SUITE(VolumeOf, CarryingSettings);

TYPED_TEST(VolumeOf, water_changes_by_the_causes_that_are_booked_and_by_no_other) {
    const Booked booked = break_dam(TypeParam{});
    const VolumeBook& volume = booked.volume;
    EXPECT_LT(booked.miss, 1e-12 * booked.before);
    EXPECT_LT(volume.tearing + volume.walls, -1e-5 * booked.before);
    if (std::is_same_v<TypeParam, WcmpsSettings>) {
        EXPECT_GT(std::abs(volume.returned), 1e-5 * booked.before);
        EXPECT_EQ(volume.walls, 0);
        EXPECT_EQ(volume.shifting, 0);
    } else {
        EXPECT_EQ(booked.most_torn, 0);
        EXPECT_GT(volume.flow, 0);  // what tears is given back
        EXPECT_GT(volume.shifting, 0);
        EXPECT_GE(volume.refused, 0);
        EXPECT_EQ(volume.returned, 0);
    }
}

TEST(VolumeOfDeltaSph, is_neither_made_nor_lost_by_the_diffusion_of_density) {
    SphSettings settings;
    settings.is_plain = true;
    const Booked booked = break_dam(settings);
    const double per_volume = 1000 * 9.81 * 0.5;  // a pressure to compare with [Pa]
    EXPECT_GT(booked.by_diffusion, 1e-3 * per_volume * booked.before * 0.01);
    EXPECT_LT(std::abs(booked.volume.diffusion), 1e-9 * booked.by_diffusion / per_volume);
}

TEST(VolumeOfMps, has_no_book_as_its_density_is_counted_anew) { EXPECT_EQ(break_dam(MpsSettings{}).volume.flow, 0); }

}  // namespace
}  // namespace riprap::fluid::testing
