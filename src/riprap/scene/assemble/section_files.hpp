// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "riprap/geometry/dda_files/dda_files.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// The geometry file of a section, its notes among those of the case. Nothing, with problems, when it is refused.
std::optional<geometry::DdaGeometry> read_geometry_file(CaseBuild& build, const Value& path);

/// The analysis file of a section. What it says is noted; where the case says otherwise about the material named
/// `material`, the solid method or gravity there is a warning.
std::optional<geometry::DdaAnalysis> read_analysis_file(CaseBuild& build, const Value& path, MaterialId material);

}  // namespace riprap::scene
