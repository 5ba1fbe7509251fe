// SPDX-License-Identifier: Apache-2.0
#pragma once

// Words of choices with what they stand for: the key table takes the words, the reader the values.

#include <cstdint>
#include <string_view>
#include <vector>

#include "riprap/core/key.hpp"
#include "riprap/coupling/field_scene.hpp"
#include "riprap/geometry/polyhedra/armour_units.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

template <class E>
using Words = std::vector<key::Word<E>>;

namespace form {
template <class E>
Form choice(const Words<E>& words) {
    return choice(key::texts_of(words));
}
}  // namespace form

/// The value of the word that the resolved `table` gives.
template <class E>
E get_word(const Value& table, std::string_view name, const Words<E>& words) {
    return key::value_of(words, get_text(table, name));
}

/// A direction along an axis.
struct Way {
    int axis;
    bool is_towards_high;
};

const Words<Way>& ways();
const Words<double>& length_units();  ///< metres in a unit
const Words<material::Mixing>& mixing_rules();
const Words<coupling::WavesAtSide::Kind>& side_waves();
const Words<geometry::ArmourUnit>& armour_units();
const Words<fluid::grid::PorousClosure>& porous_closures();

}  // namespace riprap::scene
