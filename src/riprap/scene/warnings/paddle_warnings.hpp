// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/fill.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Warns of paddles that make waves with
/// - no water at their face;
/// - a depth other than that of the water at their face, by more than a spacing. Says nothing where regions of
///   different levels touch it;
/// - a wave of less than four spacings from crest to trough, which the water can hardly carry;
/// - a face that draws back out of the domain of the water, along an axis, without what absorption adds: water that
///   follows it ends the run.
void warn_of_paddles(CaseBuild& build, const coupling::ParticleFluid& fluid, const coupling::Filling& filling);

/// Warns of the first two of these.
void warn_of_water_at_paddles(CaseBuild& build, double spacing, const coupling::Filling& filling);

}  // namespace riprap::scene
