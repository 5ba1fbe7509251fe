// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/ground.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"

namespace riprap::coupling {

/// Shares out the samples of still bodies that overlap, as walls do in the corner of a tank: every piece of solid
/// belongs to the body in which it lies deepest.
///
/// A sample stands for a cell of one spacing about it, its edges along the normal and along the seam. It keeps the
/// share of its volume that the piece of the cell in its own part of the solid has, found at points within the cell,
/// and goes where that is nothing. The volumes of both sides of a seam add up to that of the solid whatever the angle
/// and however the rows of either side meet it. Where cells of several bodies have one middle, equally deep in all, the
/// first of these keeps what all of them own of it and the others leave theirs: in a tank that a lattice fits, the
/// corner is that lattice.
///
/// Differs from keeping whole samples where they lie deepest: then a seam gains or lacks up to a row of samples in each
/// layer, and water under pressure goes through the gap.
///
/// Also finds which samples lie in a vertex (SampleSet::is_in_vertex).
/// @param grounds  of the scene (body::find_grounds)
void share_seams(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& state,
                 const SampleSettings& settings, std::span<const body::Ground> grounds, SampleSet& samples);

}  // namespace riprap::coupling
