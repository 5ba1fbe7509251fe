// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap::scene {

/// The wave that a paddle is to make, by the theory its motion follows (docs/theory/waves.md). What a kind of wave does
/// not have is 0.
struct PaddleWave {
    std::string paddle;             ///< name of the body
    std::string_view kind{"none"};  ///< word of a case
    double height{0};               ///< H, crest to trough; of a solitary wave above still water [m]
    double depth{0};                ///< d that the case gives [m]
    double period{0};               ///< T of a regular wave [s]
    double length{0};               ///< L of a regular wave [m]
    double celerity{0};             ///< c [m/s]
    double stroke{0};               ///< way of the paddle from end to end, of a flap at still water [m]
};

/// "regular, 0.1 m high in 0.6 m of water, 2 s, 4.62 m long (kd = 0.816), 2.31 m/s, stroke 0.14 m"
std::string text_of(const PaddleWave& wave);

}  // namespace riprap::scene
