// SPDX-License-Identifier: Apache-2.0
// Traits that methods declare: a name that is none of them does not compile, and neither does one of another type.
#include <gtest/gtest.h>

#include "riprap/core/fields.hpp"
#include "riprap/coupling/fluid_traits.hpp"
#include "riprap/coupling/hydrostatic/settings.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/implicit_dda/settings.hpp"
#include "riprap/solid/solid_traits.hpp"

namespace riprap {
namespace {

template <class Settings>
concept SpeltRight = requires {
    solid::SolidTraits<Settings>{.has_locks = true, .problems_of = nullptr};
    solid::SolidTraits<Settings>{.meets_by_shapes = [](const Settings&) { return false; }};
};
template <class Settings>
concept TakesAMisspeltTrait = requires {
    solid::SolidTraits<Settings>{.has_lock = true};
};
template <class Settings>
concept TakesATraitOfOtherArguments = requires {
    solid::SolidTraits<Settings>{.meets_by_shapes = [](int) { return false; }};
};
template <class Settings>
concept TakesAStep = requires {
    solid::SolidTraits<Settings>{.step = &Settings::step};
};
static_assert(SpeltRight<solid::DemSettings>);
static_assert(!TakesAMisspeltTrait<solid::DemSettings>);
static_assert(!TakesATraitOfOtherArguments<solid::DemSettings>);
static_assert(TakesAStep<solid::ImplicitDdaSettings>);
static_assert(!TakesAStep<solid::DemSettings>);  // it wants none

template <class Settings>
concept SpeltRightOfAFluid = requires {
    coupling::FluidTraits<Settings>{.leads = false, .offers = fluid::reading::pressure};
};
template <class Settings>
concept TakesAMisspeltTraitOfAFluid = requires {
    coupling::FluidTraits<Settings>{.lead = false};
};
static_assert(SpeltRightOfAFluid<coupling::HydrostaticSettings>);
static_assert(!TakesAMisspeltTraitOfAFluid<coupling::HydrostaticSettings>);

TEST(MethodTraits, SettingsThatSeveralMethodsHaveAreFoundAndSetInPlace) {
    sim::SolidSettings rigid = solid::DemSettings(), implicit = solid::ImplicitDdaSettings();
    EXPECT_EQ(sim::step_of(rigid), nullptr);
    EXPECT_EQ(sim::elasticity_of(rigid), nullptr);
    ASSERT_NE(sim::step_of(implicit), nullptr);
    *sim::step_of(implicit) = 0.25;
    sim::elasticity_of(implicit)->poisson_ratio = 0.125;
    EXPECT_EQ(std::get<solid::ImplicitDdaSettings>(implicit).step, 0.25);
    EXPECT_EQ(std::get<solid::ImplicitDdaSettings>(implicit).elasticity.poisson_ratio, 0.125);
}

TEST(MethodTraits, ThatAMethodLeavesOutHaveTheirDefaults) {
    const solid::SolidTraits<solid::DemSettings> none;
    EXPECT_FALSE(none.has_locks || none.tells_depth || none.books_every_step || none.has_bolts);
    EXPECT_TRUE(none.meets_by_shapes({}));
    EXPECT_TRUE(none.accounts().empty() && none.shown().empty());
    const coupling::FluidTraits<coupling::HydrostaticSettings> still;
    EXPECT_TRUE(still.is_there && still.leads);
    EXPECT_FALSE(still.books_every_step({}));
    EXPECT_EQ(still.spacing({}), 0);
}

}  // namespace
}  // namespace riprap
