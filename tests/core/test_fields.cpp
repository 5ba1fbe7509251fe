// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "riprap/core/fields.hpp"

namespace riprap {
namespace {

struct SomeState {
    double time{1.5};
    std::vector<Vec3> velocity{{1, 2, 3}, {4, 5, 6}};
    std::vector<std::int32_t> partner{7, 8};
    std::vector<std::int32_t> flags{};

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("time", self.time);
        visit("velocity", self.velocity);
        visit("partner", self.partner);
        visit("flags", self.flags);
    }
};

TEST(Fields, TheHashSeesEveryBitOfEveryField) {
    std::set<std::uint64_t> hashes{hash_fields(SomeState{})};
    const auto expect_new = [&hashes](const char* what, auto change) {
        SomeState state;
        change(state);
        EXPECT_TRUE(hashes.insert(hash_fields(state)).second) << what;
    };
    expect_new("time by one bit", [](SomeState& s) { s.time = std::nextafter(s.time, 2.0); });
    expect_new("sign of zero", [](SomeState& s) { s.velocity[0].x = -0.0; });
    expect_new("zero", [](SomeState& s) { s.velocity[0].x = 0.0; });
    expect_new("two entries swapped", [](SomeState& s) { std::swap(s.velocity[0], s.velocity[1]); });
    expect_new("two components swapped", [](SomeState& s) { std::swap(s.velocity[0].x, s.velocity[0].y); });
    expect_new("an odd number of 4-byte entries", [](SomeState& s) { s.partner.push_back(0); });
    expect_new("an entry more", [](SomeState& s) { s.velocity.push_back({}); });
    expect_new("entries moved to the next field", [](SomeState& s) { s.partner.swap(s.flags); });
}

TEST(Fields, EqualStatesHashAlike) { EXPECT_EQ(hash_fields(SomeState{}), hash_fields(SomeState{})); }

TEST(Fields, TheFirstNonFiniteNumberIsNamedWithItsEntry) {
    EXPECT_EQ(find_non_finite(SomeState{}).name, "");

    SomeState state;
    state.velocity[1].z = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(find_non_finite(state).name, "velocity");
    EXPECT_EQ(find_non_finite(state).entry, 1U);

    state.time = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(find_non_finite(state).name, "time");
    EXPECT_EQ(find_non_finite(state).entry, 0U);
}

}  // namespace
}  // namespace riprap
