// SPDX-License-Identifier: Apache-2.0
// Particles that start off their lattice.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

constexpr double spacing = 0.05;

/// Places of the particles at the start.
std::vector<Vec3> places(const std::string& method, double jitter, int seed = 1) {
    const std::string text = fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 0.1
seed = {}
[fluid]
method = "{}"
spacing = {}
jitter = {}
domain = {{ low = [0.0, 0.0], high = [1.0, 2.0], periodic = [true, false] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [1.0, 1.0] }}
)",
                                         seed, method, spacing, jitter);
    return Simulation(scene::read_case_text(text, "case.toml", ".")).state().fluid.position;
}

TEST(Jitter, moves_particles_of_every_scheme_by_up_to_its_share_of_the_spacing) {
    for (const char* const method : {"sph", "wcmps", "mps"}) {
        const std::vector<Vec3> even = places(method, 0), moved = places(method, 0.2);
        ASSERT_EQ(even.size(), moved.size()) << method;
        double low = 0, high = 0;
        for (std::size_t i = 0; i < even.size(); ++i) {
            const Vec3 way = (1 / spacing) * (moved[i] - even[i]);
            low = std::min({low, way.x, way.y});
            high = std::max({high, way.x, way.y});
            EXPECT_EQ(way.z, 0) << method;
        }
        EXPECT_GT(high, 0.19) << method;
        EXPECT_LE(high, 0.2 + 1e-12) << method;
        EXPECT_LT(low, -0.19) << method;
        EXPECT_GE(low, -0.2 - 1e-12) << method;
    }
}

TEST(Jitter, follows_from_the_seed_of_the_case_alone) {
    EXPECT_EQ(places("sph", 0.1), places("sph", 0.1));
    EXPECT_NE(places("sph", 0.1), places("sph", 0.1, 2));
}

TEST(Jitter, of_more_than_a_quarter_of_the_spacing_is_refused) {
    EXPECT_NO_THROW(places("sph", 0.25));
    EXPECT_THROW(places("sph", 0.26), CaseError);
}

}  // namespace
}  // namespace riprap::run
