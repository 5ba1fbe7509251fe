// SPDX-License-Identifier: Apache-2.0
#pragma once

// Particles of water over time, in few bytes. Every coordinate is rounded to a multiple of one step, so it comes back
// with an error of at most half a step; pressure and speed are one of 256 values each between two bounds. What is
// stored is the difference between a number and a guess of it from the frames before (0: none, 1: as in the last
// frame, 2: continued at the same pace) and, where that pays, from the difference of the particle before it: particles
// are in the order of their ids, so neighbours at the start are neighbours in the list. Arithmetic is modulo 2^16,
// which loses nothing. Groups of frames can be read alone. page/src/water.js reads the same.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::view {

/// Most frames of one group; the first of each is stored without its past.
inline constexpr std::size_t frames_per_group = 25;

/// The particles of one frame, in the order of their ids.
struct WaterFrame {
    std::vector<std::int32_t> id;
    std::vector<Vec3> position;   ///< [m]
    std::vector<float> pressure;  ///< [Pa]
    std::vector<float> speed;     ///< [m/s]
};

/// Scale of the stored integers.
struct WaterScale {
    Vec3 origin;                               ///< of number 0 of each coordinate [m]
    double step{0};                            ///< of a coordinate [m]
    double pressure_low{0}, pressure_high{1};  ///< of numbers 0 and 255 [Pa]; what lies beyond is shown as the bound
    double speed_high{1};                      ///< of number 255; 0 is rest [m/s]
};

/// x, y, z, pressure, speed.
inline constexpr std::size_t water_channels = 5;

/// One frame as numbers.
struct WaterNumbers {
    std::vector<std::int32_t> id;
    std::array<std::vector<std::uint16_t>, water_channels> channel;
};

WaterNumbers to_numbers(const WaterFrame& frame, const WaterScale& scale);

/// One group of frames. A frame whose particles are not those of the frame before is stored without its past.
std::string encode_group(std::span<const WaterNumbers> frames);

/// The largest step that keeps 2^16 numbers for each coordinate within `extent` [m], or `wanted` where that is larger.
double coordinate_step(double extent, double wanted);

}  // namespace riprap::view
