// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// The planar solids of [Ding2021].

namespace riprap::validation::ding {

void planar_air_cannon(const CaseSetting& setting, CaseReport& report);
void planar_air_cannon_level(const CaseSetting& setting, CaseReport& report);
void planar_cross_section(const CaseSetting& setting, CaseReport& report);
void planar_train_speed(const CaseSetting& setting, CaseReport& report);
void planar_incident_angle(const CaseSetting& setting, CaseReport& report);
void planar_ice_shape(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::ding
