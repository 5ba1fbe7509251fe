// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <variant>

#include "riprap/core/key.hpp"
#include "riprap/core/kind_list.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

// Velocities of water that a formula gives at every place and time, in the x-y plane and without divergence. Each is a
// struct with
//
//     double stream(const Vec3& x, double t, double nu) const;   // psi [m^2/s]
//     Vec3 velocity(const Vec3& x, double t, double nu) const;   // u = d psi/dy, v = - d psi/dx [m/s]
//
// where nu is the kinematic viscosity of the water [m^2/s], and with its word, a few words and its formula for the
// manual, and its keys. One line in FlowLaws registers a flow.

/// Vortices in a square pattern that viscosity slows down [Taylor1937], an exact solution:
///
///     u = U sin kx cos ky exp(-2 nu k^2 t),  v = -U cos kx sin ky exp(-2 nu k^2 t),  k = 2 pi/L.
struct TaylorGreenFlow {
    static constexpr std::string_view word = "taylor_green", brief = "Vortices in a square pattern.",
                                      help =
                                          "u = U sin kx cos ky exp(-2 nu k^2 t), v = -U cos kx sin ky exp(-2 nu k^2 "
                                          "t), k = 2 pi/wave_length: exact for a viscous fluid.";
    double speed{1};        ///< U [m/s]
    double wave_length{1};  ///< L [m]
    static KeyList<TaylorGreenFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// Steady flow along x behind a row of bars a distance L apart [Kovasznay1948], an exact solution:
///
///     u = U (1 - e^(b x/L) cos(2 pi y/L)),  v = U b/(2 pi) e^(b x/L) sin(2 pi y/L),  Re = U L/nu,
///     b = Re/2 - sqrt(Re^2/4 + 4 pi^2).
struct KovasznayFlow {
    static constexpr std::string_view word = "kovasznay", brief = "Steady flow behind a row of bars.",
                                      help =
                                          "u = U (1 - e^(b x/L) cos(2 pi y/L)), v = U b/(2 pi) e^(b x/L) sin(2 pi "
                                          "y/L), b = Re/2 - sqrt(Re^2/4 + 4 pi^2), Re = U L/nu, L = wave_length: exact "
                                          "for a viscous fluid.";
    double speed{1};        ///< U [m/s]
    double wave_length{1};  ///< L [m]
    static KeyList<KovasznayFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// Turns as a solid does about an axis along z: psi = -rate r^2/2.
struct RotationFlow {
    static constexpr std::string_view word = "rotation", brief = "A turn as of a solid.",
                                      help = "u = -rate (y - y_c), v = rate (x - x_c).";
    Vec3 center;     ///< a point of the axis [m]
    double rate{0};  ///< [rad/s]
    static KeyList<RotationFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// One vortex in a square box that stretches what it carries and turns back at half of its period [Rider1998]:
///
///     psi = -U L/pi sin^2(pi X) sin^2(pi Y) cos(pi t/T),  X = (x - x_0)/L,  Y = (y - y_0)/L.
struct VortexFlow {
    static constexpr std::string_view word = "vortex", brief = "One vortex in a square box that turns back.",
                                      help =
                                          "u = -U sin^2(pi X) sin(2 pi Y) cos(pi t/period), v = U sin(2 pi X) sin^2(pi "
                                          "Y) cos(pi t/period), X and Y the distances from `low` over `length`.";
    Vec3 low{};        ///< corner of the box [m]
    double length{1};  ///< of its sides, L [m]
    double speed{1};   ///< U [m/s]
    double period{1};  ///< T, after which all is where it was [s]
    static KeyList<VortexFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// Strain without a turn: psi = -rate (x - x_c) (y - y_c).
struct StrainFlow {
    static constexpr std::string_view word = "strain", brief = "Stretches along y, shortens along x.",
                                      help = "u = -rate (x - x_c), v = rate (y - y_c).";
    Vec3 center{};   ///< where it stands still [m]
    double rate{0};  ///< of stretching along y [1/s]
    static KeyList<StrainFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// First-order standing wave on water of even depth, potential flow while its surface is flat at t = 0 [Lamb1932]:
///
///     u = -U sin kX cosh kY/sinh kd cos(2 pi t/T),  v = U cos kX sinh kY/sinh kd cos(2 pi t/T),  k = 2 pi/L,
///
/// X and Y the distances from a point of the bed under a crest to come. Of a wave a cos kX sin(2 pi t/T) it has U = 2
/// pi a/T, and of one that gravity drives (2 pi/T)^2 = g k tanh kd.
struct StandingWaveFlow {
    static constexpr std::string_view
        word = "standing_wave",
        brief = "A standing wave of small height, when its surface is flat.",
        help =
            "u = -U sin kX cosh kY/sinh kd cos(2 pi t/period), v = U cos kX sinh kY/sinh kd cos(2 pi t/period), k = 2 "
            "pi/wave_length, d = depth, X and Y the distances from `low`: a wave a cos kX sin(2 pi t/period) has U = 2 "
            "pi a/period.";
    Vec3 low{};             ///< point of the bed under a crest to come [m]
    double speed{1};        ///< U, of the surface there [m/s]
    double wave_length{1};  ///< L [m]
    double depth{1};        ///< d [m]
    double period{1};       ///< T [s]
    static KeyList<StandingWaveFlow> keys();
    double stream(const Vec3& x, double t, double nu) const;
    Vec3 velocity(const Vec3& x, double t, double nu) const;
};

/// Flows that a case names, in the order of the manual.
using FlowLaws = KindList<TaylorGreenFlow, KovasznayFlow, RotationFlow, VortexFlow, StrainFlow, StandingWaveFlow>;
using Flow = FlowLaws::VariantWith<>;

/// Velocity of a flow [m/s].
inline Vec3 velocity_of(const Flow& flow, const Vec3& x, double t, double nu) {
    return std::visit([&](const auto& law) { return law.velocity(x, t, nu); }, flow);
}
/// Stream function of a flow [m^2/s].
inline double stream_of(const Flow& flow, const Vec3& x, double t, double nu) {
    return std::visit([&](const auto& law) { return law.stream(x, t, nu); }, flow);
}

}  // namespace riprap::fluid
