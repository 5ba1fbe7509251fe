// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/solid_scene.hpp"
#include "riprap/solid/sphere_dem/sphere_dem_settings.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"

namespace riprap::solid::sphere_dem {

/// Spheres for every body that can move freely; other bodies keep their faces, and have samples in their edges. Samples
/// lie flush with the faces of a part, small ones in its edges and corners; planar bodies are sampled around their
/// section. Bodies that the scene gives spheres have those, whether they move or not.
/// @param problems  gets those of bodies whose samples are too many or none; such a body is one sphere
SphereSet sample_bodies(const SolidScene& scene, const SphereDemSettings& settings,
                        std::vector<SceneProblem>* problems = nullptr);

/// Returns the radius of the samples: that of the settings, or a third of the least inscribed radius [m].
double radius_of_samples(const body::BodySet& bodies, const geometry::ShapeSet& shapes,
                         const SphereDemSettings& settings);

/// Pairs of all materials of a scene: elastic constants of the settings, friction of the scene's own pairs.
contact::ContactTable pair_table(const material::MaterialSet& materials, const SphereDemSettings& settings);

/// Cohesion of all pairs of materials, row after row [Pa]; empty where no pair has any.
std::vector<double> cohesion_table(const material::MaterialSet& materials);

}  // namespace riprap::solid::sphere_dem
