// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Exact answers and limit equilibrium for planar DDA.

namespace riprap::validation::dda {

void planar_rotation(const CaseSetting& setting, CaseReport& report);
void planar_pendulum(const CaseSetting& setting, CaseReport& report);
void planar_incline(const CaseSetting& setting, CaseReport& report);
void planar_tip_or_slide(const CaseSetting& setting, CaseReport& report);
void planar_shaken_block(const CaseSetting& setting, CaseReport& report);
void planar_stacks(const CaseSetting& setting, CaseReport& report);
void planar_dragged_block(const CaseSetting& setting, CaseReport& report);
void planar_rocking(const CaseSetting& setting, CaseReport& report);
void planar_toppling(const CaseSetting& setting, CaseReport& report);
void planar_plane_failure(const CaseSetting& setting, CaseReport& report);
void planar_arch(const CaseSetting& setting, CaseReport& report);
void planar_keystone(const CaseSetting& setting, CaseReport& report);
void planar_column(const CaseSetting& setting, CaseReport& report);
void planar_bar_impact(const CaseSetting& setting, CaseReport& report);
void planar_cantilever(const CaseSetting& setting, CaseReport& report);
void planar_disc(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::dda
