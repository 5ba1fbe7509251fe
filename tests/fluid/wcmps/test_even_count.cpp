// SPDX-License-Identifier: Apache-2.0
// The count that water returns to: the same for every arrangement of as many particles, and whole behind a surface.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/mps_operators/even_count.hpp"
#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid {
namespace {

/// A lattice of one particle per volume of 1: its basis in a cell of size (a, b, c).
struct Arrangement {
    const char* name;
    int dimension;
    double a, b, c;
    std::vector<Vec3> basis;
};

const std::vector<Arrangement>& arrangements() {
    const double hexagonal = std::sqrt(2 / std::sqrt(3.0)), face = std::cbrt(4.0), body = std::cbrt(2.0);
    static const std::vector<Arrangement> all{
        {"hexagonal", 2, hexagonal, hexagonal * std::sqrt(3.0), 1, {{0, 0, 0}, {0.5, 0.5, 0}}},
        {"face-centred", 3, face, face, face, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}},
        {"body-centred", 3, body, body, body, {{0, 0, 0}, {0.5, 0.5, 0.5}}}};
    return all;
}

/// Calls put(place) for the places of an arrangement about one of them.
template <class Put>
void for_places(const Arrangement& lattice, const Put& put) {
    const int deep = lattice.dimension == 3 ? 5 : 0;
    for (int k = -deep; k <= deep; ++k) {
        for (int j = -5; j <= 5; ++j) {
            for (int i = -5; i <= 5; ++i) {
                for (const Vec3& x : lattice.basis) {
                    put(Vec3{lattice.a * (i + x.x), lattice.b * (j + x.y), lattice.c * (k + x.z)});
                }
            }
        }
    }
}

/// C^W and sum W/n_0.
struct Counts {
    double even{0}, weight{0};
};

Counts count(const Arrangement& lattice, double ratio) {
    const EvenCount even(ratio, MpsWeightLaw::smooth);
    const MpsWeight weight(ratio, 1, MpsWeightLaw::smooth);
    Counts counts;
    for_places(lattice, [&](const Vec3& x) {
        const double w = weight.value(norm_squared(x));
        counts.weight += w;
        counts.even += even.of_pair(norm(x), w);
    });
    counts.even /= even_lattice(MpsWeightLaw::smooth, ratio, lattice.dimension).full;
    counts.weight /= mps_lattice(MpsWeightLaw::smooth, ratio, 1, lattice.dimension).number_density;
    return counts;
}

TEST(EvenCount, does_not_tell_arrangements_of_as_many_particles_apart) {
    for (const Arrangement& lattice : arrangements()) {
        EXPECT_NEAR(count(lattice, 3.1).even, 1, 3e-4) << lattice.name;
        EXPECT_NEAR(count(lattice, 2.1).even, 1, 5e-3) << lattice.name;
        EXPECT_LT(count(lattice, 3.1).weight, 0.997) << lattice.name;
        EXPECT_LT(count(lattice, 2.1).weight, 0.985) << lattice.name;
    }
}

TEST(EvenCount, of_the_reciprocal_weight_is_that_of_the_source) {
    const EvenCount even(3.1, MpsWeightLaw::reciprocal);
    EXPECT_EQ(even.of_pair(1.0, 2.1), 2.1);
    EXPECT_NEAR(even_lattice(MpsWeightLaw::reciprocal, 3.1, 2).full,
                mps_lattice(MpsWeightLaw::reciprocal, 3.1, 1, 2).number_density, 1e-9);
}

TEST(EvenCount, rows_behind_a_flat_surface_lack_nothing_with_what_they_lean_outward) {
    for (const MpsWeightLaw law : {MpsWeightLaw::smooth, MpsWeightLaw::reciprocal}) {
        for (const double ratio : {2.1, 3.1}) {
            for (const int dimension : {2, 3}) {
                const EvenLattice lattice = even_lattice(law, ratio, dimension);
                const EvenCount even(ratio, law);
                const MpsWeight weight(ratio, 1, law);
                for (int row = 0; row < 4; ++row) {
                    double sum = 0, outward = 0;
                    const Arrangement square{"", dimension, 1, 1, 1, {{0, 0, 0}}};
                    for_places(square, [&](const Vec3& x) {
                        if (x.y <= row) {
                            const double w = weight.value(norm_squared(x));
                            sum += even.of_pair(norm(x), w);
                            outward -= norm(x) > 0 ? w * x.y / norm(x) : 0;
                        }
                    });
                    const double n0 = mps_lattice(law, ratio, 1, dimension).number_density;
                    EXPECT_NEAR(sum / lattice.full + lattice.lack(outward / n0), 1, row < 2 ? 1e-6 : 3e-3)
                        << ratio << ' ' << dimension << ' ' << row;
                }
            }
        }
    }
}

}  // namespace
}  // namespace riprap::fluid
