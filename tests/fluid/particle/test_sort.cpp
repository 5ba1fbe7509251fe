// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sort.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "fluid/particle/sample.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid {
namespace {

TEST(order_by_place, walks_from_neighbour_to_neighbour_through_a_lattice) {
    // 16 points per axis, a power of two: the curve visits each once and never jumps
    for (const int dimension : {2, 3}) {
        std::vector<Vec3> points;
        for (int k = 0; k < (dimension == 2 ? 1 : 16); ++k) {
            for (int j = 0; j < 16; ++j) {
                for (int i = 0; i < 16; ++i) {
                    points.push_back(0.5 * Vec3{double(i), double(j), double(k)});
                }
            }
        }
        std::shuffle(points.begin(), points.end(), std::mt19937_64(3));
        Domain domain;
        domain.dimension = dimension;
        const std::vector<std::uint32_t> order = order_by_place(points, domain, 1.0);
        for (std::size_t i = 1; i < order.size(); ++i) {
            ASSERT_NEAR(norm(points[order[i]] - points[order[i - 1]]), 0.5, 1e-12) << i;
        }
    }
}

TEST(sort_by_place, moves_whole_particles) {
    const Sample s = jittered_lattice(3, {12, 12, 12}, 1.3);
    ParticleState state;
    state.position = s.position;
    state.velocity = s.velocity;
    state.density = s.density;
    state.id.resize(s.size());
    std::iota(state.id.begin(), state.id.end(), 0);
    state.dilution.resize(s.size());
    std::iota(state.dilution.begin(), state.dilution.end(), 5.0);
    std::shuffle(state.position.begin(), state.position.end(), std::mt19937_64(3));
    const std::vector<Vec3> before = state.position;
    sort_by_place(state, s.domain, s.spacing);
    std::vector<std::int32_t> seen = state.id;
    std::sort(seen.begin(), seen.end());
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto id = static_cast<std::size_t>(state.id[i]);
        ASSERT_EQ(seen[i], static_cast<std::int32_t>(i));
        ASSERT_EQ(state.position[i], before[id]);
        ASSERT_EQ(state.velocity[i], s.velocity[id]);
        ASSERT_EQ(state.density[i], s.density[id]);
        ASSERT_EQ(state.dilution[i], 5.0 + state.id[i]);
    }
}

TEST(sort_by_place, gives_the_same_order_on_any_number_of_threads) {
    const Sample s = jittered_lattice(3, {40, 30, 30}, 1.3);
    parallel::set_thread_count(1);
    const auto one = order_by_place(s.position, s.domain, s.spacing);
    parallel::set_thread_count(4);
    const auto four = order_by_place(s.position, s.domain, s.spacing);
    parallel::set_thread_count(1);
    EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace riprap::fluid
