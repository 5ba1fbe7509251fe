// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/config.hpp"

namespace riprap::fluid {

/// Tells what flow does to compression as density is carried from rho_(n-1/2) to rho_(n+1/2), and what the forces of
/// both kicks do along the velocities v_n between them. They are one and the same where steps are equally long and
/// pressure changes little within one; what is left is energy that the scheme makes or takes (docs/theory/sph.md, 6).
struct FlowWork {
    double stored{0};            ///< by the update [J]
    double before{0}, after{0};  ///< power of the forces of the last kick and of the next one, with a minus [W]

    template <class By>
    RIPRAP_HD static void join(FlowWork& a, const FlowWork& b, const By& by) {
        by.add(a.stored, b.stored);
        by.add(a.before, b.before);
        by.add(a.after, b.after);
    }
    /// Returns what the forces do beyond what compression stores, dt_(n-1)/2 before + dt_n/2 after - stored [J].
    /// @param dt    of the update, (dt_(n-1) + dt_n)/2; dt_0/2 in the first step [s]
    /// @param next  dt_n, the length of the kick that follows [s]
    double beyond(double dt, double next) const { return (dt - 0.5 * next) * before + 0.5 * next * after - stored; }
};

}  // namespace riprap::fluid
