// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/field_scene.hpp"
#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/keys/words.hpp"

namespace riprap::scene {

/// fluid.flow: one table for each flow that has a name.
const Table& flow_table();

/// [[fluid.side]].
const Table& side_table();
const Words<coupling::SideRule::Kind>& side_kinds();

}  // namespace riprap::scene
