// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::validation::rigid {

/// A box that stands on a half-space and is about to tip over its lower edge.
struct StandingBlock {
    double width, height;  ///< along the slope and normal to it [m]; 1 m long
    double density;        ///< [kg/m^3]
    double stiffness;      ///< k_n [Pa]
};

/// Slope at which it tips [rad], less than atan(width/height) because its base is elastic.
///
/// Near tipping the force N normal to the base rests on a strip of width 3 x, x behind the edge, whose pressure grows
/// linearly to the edge: the edge is 2 N/(3 K x) deep and the tilt 2 N/(9 K x^2), K = k_n/r the stiffness per area of
/// base [N/m^3] (a half-space has no field of its own). A tilt theta moves the weight towards the edge by H theta/2,
/// H = h (1 + tan^2 slope), since the centre moves h theta/2 along the slope and b theta/2 off it. Rest asks that the
/// weight, without the tilt, pass x + H N/(9 K x^2) inside the edge. That is least, 1.5 x, for x^3 = 2 H N/(9 K):
///
///     b/2 - (h/2) tan(slope) = 1.5 (2 H N/(9 K))^(1/3),    N = m g cos(slope).
///
/// Left out: the field of the block falls to zero towards its edges within a depth of them. Integrating the field
/// numerically over the tilted base changes the slope by 0.004 degrees at most for the blocks tested here.
double tipping_slope(const StandingBlock& block);

/// Horizontal acceleration of a level base, over gravity, at which it tips [-]: the same with N = m g, and with the
/// acceleration over gravity for tan(slope).
double tipping_acceleration(const StandingBlock& block);

/// Tilt of the block against its base on the slope at that moment, 2 N/(9 K x^2) [rad].
double tipping_tilt(const StandingBlock& block);

}  // namespace riprap::validation::rigid
