// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/bench/result.hpp"

namespace riprap::bench {

// machine.cpp
void machine(const Setting& setting, std::vector<Result>& results);

// contact.cpp
void contact_cube_cube(const Setting& setting, std::vector<Result>& results);
void contact_with_energy(const Setting& setting, std::vector<Result>& results);
void contact_cached_miss(const Setting& setting, std::vector<Result>& results);

// pile.cpp
void pile_735_cubes(const Setting& setting, std::vector<Result>& results);
void pile_1k(const Setting& setting, std::vector<Result>& results);
void pile_10k(const Setting& setting, std::vector<Result>& results);
void pile_100k(const Setting& setting, std::vector<Result>& results);
void pile_voronoi(const Setting& setting, std::vector<Result>& results);

// sph.cpp
void sph_h1732(const Setting& setting, std::vector<Result>& results);
void sph_h12(const Setting& setting, std::vector<Result>& results);

// water.cpp
void water_schemes(const Setting& setting, std::vector<Result>& results);

// step.cpp
void step_dam_break(const Setting& setting, std::vector<Result>& results);
void step_floes(const Setting& setting, std::vector<Result>& results);
void step_rubble(const Setting& setting, std::vector<Result>& results);
void step_slide(const Setting& setting, std::vector<Result>& results);

// linear.cpp
void linear_product(const Setting& setting, std::vector<Result>& results);
void linear_pcg(const Setting& setting, std::vector<Result>& results);

// spheres.cpp
void spheres_10k(const Setting& setting, std::vector<Result>& results);
void spheres_100k(const Setting& setting, std::vector<Result>& results);

// grid.cpp
void grid_dambreak(const Setting& setting, std::vector<Result>& results);

// broadphase.cpp
void broadphase_slope(const Setting& setting, std::vector<Result>& results);

// dda_3d.cpp
void dda_implicit_3400(const Setting& setting, std::vector<Result>& results);
void dda_explicit(const Setting& setting, std::vector<Result>& results);
void dda_explicit_100k(const Setting& setting, std::vector<Result>& results);

// planar_dda.cpp
void dda_planar(const Setting& setting, std::vector<Result>& results);

}  // namespace riprap::bench
