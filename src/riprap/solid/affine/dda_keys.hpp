// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "riprap/contact/law/joint_laws.hpp"
#include "riprap/core/chosen_keys.hpp"
#include "riprap/material/property.hpp"
#include "riprap/solid/affine/default_scales.hpp"
#include "riprap/solid/affine/elasticity.hpp"

// Keys of a case and properties of materials that all DDA methods read.

namespace riprap::solid::affine {

/// A positive number that the case may leave to its blocks by "auto", its default: the member is then left_to_blocks,
/// until the bodies are known. What the member is without a case stays what engines have without one.
template <class S>
BoundKey<S> number_or_left(double S::*member, std::string_view name, const Dimension& dimension,
                           std::string_view help) {
    BoundKey<S> bound = key::number(member, name, dimension, key::positive(), help);
    bound.row.words = {"auto"};
    bound.get = [member](const S& s) {
        return std::isnan(s.*member) || s.*member == S{}.*member ? KeyValue() : KeyValue(s.*member);
    };
    bound.set = [member](S& s, const KeyValue& value) {
        const double* given = std::get_if<double>(&value);
        s.*member = given != nullptr ? *given : left_to_blocks;
    };
    return bound;
}

/// The key `step` of implicit methods.
template <class S>
BoundKey<S> wanted_step() {
    return number_or_left(
        &S::step, "step", dimension::time,
        "Time step; shorter where contacts do not settle. \"auto\": 0.2 sqrt(R/(2000 a)) of the block "
        "for which that is least, R half its edge, a what gravity, loads or its speed at the "
        "start give it.");
}

/// Returns the keys of the joint law: none where there is no choice.
template <class Engine>
KeyList<Engine> joint_keys() {
    if constexpr (contact::JointLaws::count > 1) {
        return key::chosen(&Engine::joint_law, "joint_law", "Strength of a contact point in shear");
    } else {
        return {};
    }
}

/// Returns the keys that fill Elasticity.
KeyList<Elasticity> elastic_keys();

/// Returns those of blocks in space, whose contact points stand for areas.
KeyList<Elasticity> elastic_keys_in_space();

/// Returns those of explicit_dda, whose step follows from the waves in blocks: it leaves Young's modulus to them.
KeyList<Elasticity> elastic_keys_of_waves();

/// Refuses two stiffnesses of contacts at once.
std::vector<KeyProblem> problems_of(const Elasticity& elasticity);

/// Returns the properties of materials that contact points read.
/// @param has_dashpots  the method damps its contact points
std::vector<material::PropertyUse> contact_uses(bool has_dashpots);

}  // namespace riprap::solid::affine
