// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "riprap/body/body_set.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/sea_absorption.hpp"
#include "riprap/wave/solitary_wave.hpp"

namespace riprap::coupling {

/// Absorption of waves that come back to a piston while it makes its own [SchafferKlopman2000]. The surface in front of
/// it, less what its own motion makes there, is a wave that arrives with amplitude a; a correction of its velocity
///
///     u = -G (eta - eta_own),   eta_own = H/2 cos(wt + phase - k x) r + C_e(x) X     (regular waves)
///                               eta_own = H sech^2(K (c (t - t_0) - x))              (solitary wave)
///
/// sends off the opposite of what a resting paddle would reflect. G = w/(H/S) for regular waves, with H/S the transfer
/// function at their frequency, so it is exact there at any depth; sqrt(g/d), its shallow limit, for solitary waves and
/// for paddles that only absorb. C_e(x) = sum_j 4 sin^2(k_j d)/(2 k_j d + sin 2 k_j d) exp(-k_j x) are the evanescent
/// modes of the piston, w^2 = -g k_j tan(k_j d), X its displacement by its own motion. The modes that the correction
/// makes are C_e(x) (-u'/w^2), its acceleration: taking them off as well turns the law into u + G C_e/w^2 u' = -G
/// (...), a delay (absorption_delay). Where waves are regular the correction also returns to zero within five periods,
/// so that the mean level does not carry the paddle away.
///
/// A sea has its own law (wave::AbsorptionLaw), which answers all its frequencies.
struct PaddleAbsorption {
    BodyId body;
    Vec3 direction{1, 0, 0};  ///< where the waves go [-]
    Vec3 foot{};              ///< of the paddle's face, at its place at rest [m]
    Vec3 up{0, 0, 1};         ///< [-]
    double gravity{9.81};     ///< g [m/s^2]
    double depth{0};          ///< d of still water [m]
    double still{0};          ///< what the gauge reads at the start [m]
    double start{0};          ///< of the motion [s]
    std::optional<wave::LinearWave> regular;
    double phase{0}, ramp{0};  ///< of the regular wave [rad], [s]
    std::optional<wave::SolitaryWave> solitary;
    double solitary_crest{0};  ///< t_0: when its crest would pass the place at rest [s]
    std::optional<wave::IrregularWave> sea;
    double sea_period{0};     ///< of its peak [s]
    wave::AbsorptionLaw law;  ///< of a sea; see prepare_sea
    wave::OwnSurface own;     ///< surface of the sea that the paddle itself makes
};

/// Distance of the gauge from the face, in spacings: outside of the support of the face's own layers.
inline constexpr double absorption_gauge_distance = 4;

/// Finds the law of a paddle that makes a sea, and the surface that it makes, for the place of the gauge.
void prepare_sea(PaddleAbsorption& paddle, double spacing);

/// Height of the surface above the foot, in front of a paddle that is `shift` from its place at rest [m]; 0 where dry.
double surface_at_paddle(const PaddleAbsorption& paddle, double shift, const fluid::ParticleSettings& settings,
                         const fluid::ParticleState& water);

/// The correction of velocity that the law asks for, that of a sea without its delay [m/s].
/// @param reading  of surface_at_paddle [m]
/// @param driven   displacement of the paddle by its own motion along `direction` [m]
/// @param offset   what corrections have moved it so far [m]
double absorbing_velocity(const PaddleAbsorption& paddle, double time, double reading, double driven, double offset,
                          double gauge_distance);

/// Time within which a correction follows the law: G C_e(x)/w^2 of regular waves, and never less than a long wave needs
/// for one spacing [s].
double absorption_delay(const PaddleAbsorption& paddle, double spacing, double gauge_distance);

/// Sets how fast the corrections of all absorbing paddles go over the next step.
/// @param surge  per body: how fast the correction of a paddle that makes a sea changes; empty without one [m/s^2]
void absorb_waves(std::span<const PaddleAbsorption> paddles, const body::BodySet& bodies, double time, double dt,
                  const fluid::ParticleSettings& settings, const fluid::ParticleState& water,
                  std::vector<double>& surge, body::BodyState& state);

}  // namespace riprap::coupling
