// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/key.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/material/property.hpp"

namespace riprap::material {

/// A key of a case that gives a property.
/// @tparam To  Material or PairProperties
template <class To>
struct PropertyKey {
    Property property;
    BoundKey<To> key;
};

/// Keys of [material.NAME] but the density. Names and members of all properties are here and nowhere else; who reads
/// them is said by the physics (PropertyUse).
std::vector<PropertyKey<Material>> material_keys();
/// Keys of [[contact.pair]], for the values that a pair of materials has.
std::vector<PropertyKey<PairProperties>> pair_keys();

/// Tells whether a material gives a property that has no default.
bool is_given(const Material& material, Property property);

}  // namespace riprap::material
