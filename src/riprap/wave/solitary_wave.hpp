// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::wave {

/// A solitary wave over a flat bed, first order of Boussinesq [Goring1978, ch. 3]:
///
///     eta(x, t) = H sech^2(K (x - c t)),   K = sqrt(3 H / (4 d^3)),   c = sqrt(g (d + H)).
///
/// Good up to H/d of about 0.3; it breaks near 0.78.
struct SolitaryWave {
    double height;   ///< H [m]
    double depth;    ///< d of still water [m]
    double gravity;  ///< g [m/s^2]

    double celerity() const;      ///< c [m/s]
    double shape_number() const;  ///< K [1/m]
    /// Surface above still water at a distance from the crest [m].
    double elevation(double from_crest) const;
    /// Velocity along the bed averaged over the depth, c eta / (d + eta), exact by continuity [m/s].
    double mean_velocity(double from_crest) const;
    /// Volume above still water per metre of crest: 2 H / K [m^2].
    double volume() const;
};

}  // namespace riprap::wave
