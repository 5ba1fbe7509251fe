// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fluid/dam.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/core/key.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid::testing {
namespace {

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
