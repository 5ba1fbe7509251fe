// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "riprap/body/body_set.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid::affine {

/// Stands in settings for a contact stiffness or a step that the case leaves to its blocks, from reading the key until
/// the bodies are known. No key has this value.
inline constexpr double left_to_blocks = std::numeric_limits<double>::quiet_NaN();

/// A contact point of default stiffness that carries a whole block gives way by this part of half its edge [-].
/// A block of rock with faces of 1 m then has 1e8 N/m, the default of blocks of every size before.
inline constexpr double springs_per_radius = 2000;

/// Default step over the time in which a block on one such point swings by a radian [-]; 1 ms for that block.
inline constexpr double step_per_radian = 0.2;

/// Largest default modulus of explicit_dda, that of the other methods [Pa].
inline constexpr double modulus_of_rock = 5e9;

/// Modulus over the pressure rho a R of a block under its pull, above which its strain is nothing: 2.5e-6 [-]. That of
/// rock for the block above.
inline constexpr double modulus_per_pressure = 4e5;

/// Pull of a block where nothing in the scene weighs, moves or is loaded, and least pull in scenes without gravity that
/// water or driven bodies move: standard gravity [m/s^2].
inline constexpr double standard_pull = 9.81;

/// Stiffness of a contact point and time step that follow from the blocks that forces move,
///
///     k = 2000 max(F/R),    dt = 0.2 min(sqrt(R/(2000 a))),    E = min(5 GPa, 4e5 max(rho a R)),
///     F = max(m a, g min(M, m (1 + H/(2 R)))),
///
/// F: load on a block: its own, or the weight of the blocks that may stand on it [N]; M: mass of all blocks that may
/// move [kg]; H: height of the highest of their centres above the lowest [m]; m: mass, of a metre of thickness in the
/// plane [kg]; R: half the edge of a cube, in the plane of a square, as large as the block, so that slivers of a cut
/// slope count by their volume [m]; rho: mass over volume [kg/m^3]; E: modulus of explicit_dda, whose steps resolve the
/// waves in blocks [Pa]; a: the largest of gravity, loads and tension of bolts over m, and v^2/(4 R), which stops the
/// block within its width 2 R from the speed v of its fastest corner at the start [m/s^2].
///
/// A scene s times as large that goes by the same numbers of Froude has k s in the plane, k s^2 in space and dt
/// sqrt(s): depths of contacts are the same shares of blocks, and steps the same shares of times.
struct DefaultScales {
    double stiffness{0};                            ///< [N/m]
    double step{0};                                 ///< [s]
    double modulus{0};                              ///< [Pa]
    std::string of_stiffness, of_step, of_modulus;  ///< what they follow from, for people
};

/// @param bodies     at the start
/// @param has_water  which moves bodies besides
DefaultScales default_scales(const SolidScene& scene, const body::BodyState& bodies, bool has_water);

}  // namespace riprap::solid::affine
