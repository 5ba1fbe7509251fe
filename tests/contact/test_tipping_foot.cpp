// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "riprap/contact/elastic_foot.hpp"

namespace riprap::contact {
namespace {

/// A box that stands on a half-space and is about to tip over its lower edge.
struct StandingBlock {
    double width, height;  ///< along the slope and normal to it [m]; 1 m long
    double density;        ///< [kg/m^3]
    double stiffness;      ///< k_n [Pa]

    /// Foot of the block: a half-space has no field of its own, so K = k_n/r of the block alone.
    ElasticFoot foot() const {
        return {.width = width,
                .length = 1,
                .centre_height = 0.5 * height,
                .weight = density * width * height * 9.81,
                .stiffness = stiffness / (0.5 * std::min({width, height, 1.0}))};
    }
};

/// A box pressed into a plane, turned by `tilt` about its lower edge, which is `depth` below the plane. Pressure on
/// the plane is k_n phi, phi the distance to the nearest face of the box over its inscribed radius.
struct PressedBox {
    StandingBlock block;
    double depth, tilt;

    double pressure(double x) const {  // x from the edge, forwards
        const double s = std::sin(tilt), c = std::cos(tilt);
        const double above = x * s + depth * c, ahead = x * c - depth * s;
        const double radius = 0.5 * std::min({block.width, block.height, 1.0});
        return block.stiffness * std::max(0.0, std::min({above, -ahead, block.width + ahead})) / radius;
    }
    struct Resultant {
        double force, centre;  ///< [N], [m] from the edge
    };
    Resultant resultant() const {
        const double s = std::sin(tilt), c = std::cos(tilt), b = block.width;
        const double front = depth * s / c, back_depth = depth - b * s;
        const double back = back_depth > 0 ? -b * c + back_depth * s / c : -depth * c / s;
        std::vector<double> ends{back, front};  // pressure is linear between these
        for (const double x : {depth * (s - c) / (s + c), (b - depth * (s + c)) / (s - c)}) {
            if (x > back && x < front) {
                ends.push_back(x);
            }
        }
        std::sort(ends.begin(), ends.end());
        double force = 0, moment = 0;
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const double x0 = ends[i], x1 = ends[i + 1], middle = 0.5 * (x0 + x1), w = (x1 - x0) / 6;
            force += w * (pressure(x0) + 4 * pressure(middle) + pressure(x1));
            moment += w * (x0 * pressure(x0) + 4 * middle * pressure(middle) + x1 * pressure(x1));
        }
        return {force, moment / force};
    }
};

/// Distance of the contact force from the line of the weight [m]: the block can rest where this reaches zero for some
/// tilt.
double margin(const StandingBlock& block, double slope, double tilt) {
    const double load = block.density * block.width * block.height * 9.81 * std::cos(slope);
    double low = 1e-9, high = 0.1 * block.width;
    for (int i = 0; i < 100; ++i) {
        const double depth = std::sqrt(low * high);
        (PressedBox{block, depth, tilt}.resultant().force > load ? high : low) = depth;
    }
    const double x = -0.5 * block.width * std::cos(tilt) + 0.5 * block.height * std::sin(tilt);
    const double z = -low + 0.5 * block.width * std::sin(tilt) + 0.5 * block.height * std::cos(tilt);
    return PressedBox{block, low, tilt}.resultant().centre - (x + z * std::tan(slope));
}

double largest_margin(const StandingBlock& block, double slope) {
    double largest = -1;
    for (int i = 0; i <= 200; ++i) {
        largest = std::max(largest, margin(block, slope, 1e-4 * std::pow(300.0, i / 200.0)));
    }
    return largest;
}

TEST(Tipping, pressure_of_the_distance_field_under_a_tilted_block_fails_at_the_slope_of_the_strip_formula) {
    const double degree = M_PI / 180;
    for (const double ratio : {0.2, 0.4, 0.8}) {
        const StandingBlock block{ratio * 0.5, 0.5, 2500, 1e9};
        const double slope = tipping_slope(block.foot());
        EXPECT_GT(largest_margin(block, slope - 0.005 * degree), 0) << ratio;
        EXPECT_LT(largest_margin(block, slope + 0.005 * degree), 0) << ratio;
        EXPECT_LT(slope, std::atan(ratio) - 0.5 * degree) << ratio;
    }
}

}  // namespace
}  // namespace riprap::contact
