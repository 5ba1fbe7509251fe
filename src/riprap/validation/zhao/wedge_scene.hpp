// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation::zhao {

/// A wedge in the groove of two planes whose line of intersection l plunges by `plunge`; x forward, z up.
/// l = (cos, 0, -sin), m = (sin, 0, cos); each plane opens from m by its own half angle.
struct WedgeSetting {
    double plunge;                   ///< theta [rad]
    double left_angle, right_angle;  ///< half angles of the groove, between m and each plane [rad]
    double density, stiffness, shear_ratio, friction;
    double length{2}, depth{0.5};  ///< of the wedge along l and along m [m]; its top is parallel to l
    double shake{0};               ///< amplitude A of the ground's horizontal acceleration [m/s^2]; 0 = at rest
    double period{1};              ///< of the shaking [s]
};

/// Exact answers of a rigid wedge on two planes.
struct WedgeTheory {
    Vec3 along, across;            ///< l and m
    double load_left, load_right;  ///< N/W of each plane when W cos(theta) presses on both [-]
    double acceleration;           ///< g (sin - mu (N1 + N2)/W), at least 0 [m/s^2]
};
WedgeTheory wedge_theory(const WedgeSetting& setting);

/// The wedge at rest in its groove, pressed in by the part of gravity across l until nothing moves any more (mass
/// damping, switched off again); then gravity is whole. The wedge begins to move at the returned trial's time.
class WedgeTrial {
 public:
    explicit WedgeTrial(const WedgeSetting& setting);

    Trial trial;
    BodyId wedge;
    WedgeTheory theory;
    double start;         ///< when gravity became whole [s]
    Vec3 start_position;  ///< [m]
    Quat start_orientation;

    /// Displacement since the start relative to the (shaken) ground [m] and relative velocity [m/s].
    Vec3 displacement() const;
    Vec3 velocity() const;
    /// Turn since the start [rad].
    double rotation() const;

 private:
    BodyId ground_;
    Vec3 ground_start_;
};

}  // namespace riprap::validation::zhao
