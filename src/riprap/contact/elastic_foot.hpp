// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::contact {

/// A rigid block, or a stack of blocks taken as one, that stands on a flat foot whose contact is elastic.
struct ElasticFoot {
    double width;          ///< b of the foot, in the direction of tipping [m]
    double length;         ///< l of the foot, across it [m]
    double centre_height;  ///< c of the centre of mass above the foot [m]
    double weight;         ///< W of all that the foot carries [N]
    double stiffness;      ///< K = k_a/r_a + k_b/r_b per area of foot (docs/theory/time-step.md) [N/m^3]
};

/// Slope at which it tips [rad]: less than the rigid block's atan(b/(2 c)), because its foot is elastic.
///
/// Near tipping the force N normal to the foot rests on a strip of width 3 x, x behind the edge, whose pressure grows
/// linearly to the edge: the edge is 2 N/(3 K l x) deep and the tilt 2 N/(9 K l x^2). A tilt theta moves the weight
/// towards the edge by H theta/2, H = 2 c (1 + tan^2 slope), since the centre moves c theta along the slope and b
/// theta/2 off it. Rest asks that the weight, without the tilt, pass x + H N/(9 K l x^2) inside the edge. That is
/// least, 1.5 x, for x^3 = 2 H N/(9 K l):
///
///     b/2 - c tan(slope) = 1.5 (2 H N/(9 K l))^(1/3),    N = W cos(slope).
///
/// The loss of slope goes with K^(-1/3): a tenth of it costs a thousand times the stiffness and 32 times the steps.
/// Zero where the block does not stand on level ground. Left out: the field of a block falls to zero towards its edges
/// within a depth of them; integrating it over the tilted foot changes the slope by 0.004 degrees at most for blocks of
/// 0.1 to 0.4 m by 0.5 m (tests). Joints above the foot lean too and take some more.
double tipping_slope(const ElasticFoot& foot);

}  // namespace riprap::contact
