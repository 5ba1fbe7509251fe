// SPDX-License-Identifier: Apache-2.0
// Cost of one contact of two cubes, per call: touching (both sides, force and moment; with and without the energy)
// and apart with a remembered direction. Prints the median of several runs over many poses.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>
#include <vector>

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/geometry/shape_set.hpp"
#include "riprap/geometry/shapes.hpp"

namespace {

using riprap::Pose;
using riprap::Quat;
using riprap::Vec3;
namespace contact = riprap::contact;

struct Case {
    const char* name;
    double gap;   ///< between the facing faces [m]; negative = overlap
    double turn;  ///< size of the random rotations of the upper cube [rad]
    bool with_energy;
};

void print_microseconds_per_pair(const Case& setup, const riprap::geometry::ConvexView& cube) {
    constexpr int pairs = 512, repeats = 15;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    const contact::Frame below = contact::to_frame(Pose{});
    std::vector<contact::Frame> above;
    for (int i = 0; i < pairs; ++i) {
        const Vec3 turn = setup.turn * Vec3{any(random), any(random), 10 * any(random)};
        above.push_back(contact::to_frame(
            {{0.3 * any(random), 0.3 * any(random), 1 + setup.gap}, riprap::from_rotation_vector(turn)}));
    }
    std::vector<contact::SeparatingCache> caches(pairs);
    const contact::DistancePotentialOptions options{.with_energy = setup.with_energy};
    std::vector<double> times;
    int touching = 0;
    for (int r = 0; r < repeats; ++r) {
        const std::clock_t start = std::clock();  // processor time: other processes do not count
        for (int turn = 0; turn < 10; ++turn) {
            for (std::size_t i = 0; i < above.size(); ++i) {
                contact::NormalContact result;
                touching += find_contact(cube, above[i], 1, cube, below, 1, options, caches[i], result) ? 1 : 0;
            }
        }
        times.push_back(1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / (10.0 * pairs));
    }
    std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
    std::printf("%-34s %7.3f us   (%.0f %% touching)\n", setup.name, times[repeats / 2],
                100.0 * touching / (10.0 * pairs * repeats));
}

}  // namespace

int main() {
    riprap::geometry::ShapeSet shapes;
    const auto view = shapes.view(shapes.add_convex(riprap::geometry::cube(1)));
    for (const Case& setup :
         {Case{"face on face, aligned", -1e-3, 0, false}, Case{"face on face, aligned, energy", -1e-3, 0, true},
          Case{"face on face, tilted", -1e-3, 1e-3, false}, Case{"face on face, tilted, energy", -1e-3, 1e-3, true},
          Case{"any attitude", 0.05, 0.5, false}, Case{"any attitude, energy", 0.05, 0.5, true},
          Case{"apart, remembered direction", 0.01, 1e-3, false}}) {
        print_microseconds_per_pair(setup, view);
    }
}
