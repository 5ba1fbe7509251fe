// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/material/property.hpp"
#include "riprap/solid/affine/body_bridge.hpp"

// Keys of a case and properties of materials that all DDA methods read.

namespace riprap {
template <class S>
class KeyList;      // core/key.hpp
struct KeyProblem;  // likewise
}  // namespace riprap

namespace riprap::solid::affine {

/// Returns the keys that fill Elasticity.
KeyList<Elasticity> elastic_keys();

/// Returns those of blocks in space, whose contact points stand for areas.
KeyList<Elasticity> elastic_keys_in_space();

/// Refuses two stiffnesses of contacts at once.
std::vector<KeyProblem> problems_of(const Elasticity& elasticity);

/// Returns the properties of materials that contact points read.
/// @param has_dashpots  the method damps its contact points
std::vector<material::PropertyUse> contact_uses(bool has_dashpots);

}  // namespace riprap::solid::affine
