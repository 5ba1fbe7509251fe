// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/sweep_plain.hpp"

#include <gmock/gmock.h>

#include "fluid/particle/sample.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid {
namespace {

/// sum over j of f_j W(r) and of W(r)
struct Interpolate {
    static constexpr int target_fields = 0;
    static constexpr int candidate_fields = 1;
    static constexpr int sums = 2;
    WendlandC2 kernel;

    template <int Dim, class Real>
    void operator()(const Real*, const Real* candidate, const Real*, Real, Real r, Real* sum) const {
        const Real w = kernel.value(r);
        sum[0] += w * candidate[0];
        sum[1] += w;
    }
};

/// The same by all pairs, and all images in the periodic directions.
std::vector<double> brute_force(const Sample& s, const std::vector<double>& values) {
    std::vector<double> sum(s.size());
    const auto images = [&](int axis) {
        return axis < s.domain.dimension && s.domain.is_periodic[static_cast<std::size_t>(axis)] ? 1 : 0;
    };
    const Vec3 period = s.domain.high - s.domain.low;
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (std::size_t j = 0; j < s.size(); ++j) {
            for (int a = -images(0); a <= images(0); ++a) {
                for (int b = -images(1); b <= images(1); ++b) {
                    for (int c = -images(2); c <= images(2); ++c) {
                        const Vec3 d = s.position[i] - s.position[j] + Vec3{a * period.x, b * period.y, c * period.z};
                        sum[i] += values[j] * s.constants.kernel.value(norm(d));
                    }
                }
            }
        }
    }
    return sum;
}

std::vector<double> sweep_of(const Sample& s) {
    std::vector<double> sum(s.size()), weight(s.size());
    sweep_plain(Interpolate{s.constants.kernel}, s.reach(), {s.position, {}}, {s.position, {field(s.density)}},
                {sink(sum), sink(weight)});
    return sum;
}

void expect_equal(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_NEAR(a[i], b[i], 1e-12 * std::abs(b[i])) << i;
    }
}

TEST(plain_sweep, equals_all_pairs_in_two_and_three_dimensions) {
    for (const int dimension : {2, 3}) {
        const Sample s = jittered_lattice(dimension, {13, 11, 9}, 1.3);
        expect_equal(sweep_of(s), brute_force(s, s.density));
    }
}

TEST(plain_sweep, meets_the_images_across_periodic_sides) {
    Sample s = jittered_lattice(3, {9, 11, 12}, 1.3);
    s.domain.is_periodic = {true, false, true};
    expect_equal(sweep_of(s), brute_force(s, s.density));
    // a particle that has just left through a periodic side is still where its image is
    std::vector<double> before = sweep_of(s);
    s.position[0].x += 9 * s.spacing;
    expect_equal(sweep_of(s), before);
}

TEST(plain_sweep, refuses_a_period_in_which_a_particle_would_meet_itself) {
    Sample s = jittered_lattice(3, {4, 11, 12}, 1.3);
    s.domain.is_periodic = {true, false, false};
    EXPECT_THROW(sweep_of(s), CaseError);
}

TEST(plain_sweep, survives_particles_far_away_and_not_finite) {
    Sample s = jittered_lattice(3, {9, 9, 9}, 1.3);
    const std::vector<double> before = sweep_of(s);
    s.position.push_back({1e9, -1e9, 3});
    s.position.push_back({std::nan(""), 0, 0});
    s.density.insert(s.density.end(), {1000, 1000});
    std::vector<double> after = sweep_of(s);
    after.resize(before.size());
    expect_equal(after, before);
}

TEST(plain_sweep, adds_to_its_sums_and_takes_empty_sets) {
    const Sample s = jittered_lattice(2, {5, 5, 1}, 1.3);
    std::vector<double> sum(s.size(), 3.0), weight(s.size());
    const std::vector<Vec3> nobody;
    const Interpolate pair{s.constants.kernel};
    sweep_plain(pair, s.reach(), {s.position, {}}, {nobody, {}}, {sink(sum), sink(weight)});
    sweep_plain(pair, s.reach(), {nobody, {}}, {s.position, {field(s.density)}}, {sink(sum), sink(weight)});
    EXPECT_THAT(sum, testing::Each(3.0));
}

}  // namespace
}  // namespace riprap::fluid
