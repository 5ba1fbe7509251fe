// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/law/coulomb.hpp"
#include "riprap/contact/law/mindlin.hpp"
#include "riprap/contact/law/tanh_friction.hpp"
#include "riprap/core/chosen.hpp"

namespace riprap::contact {

/// Frictions of polyhedra: one line registers a law. Beside its word and keys (core/chosen.hpp) it has
///
///     LinearContact respond(normal, pair, kinematics, before, after, row)
///
/// which answers a NormalContact with all forces (see coulomb.hpp, and normal_push.hpp for what laws have in common),
/// and `reads`: the properties of materials that the law reads besides those of every law (FacesOnFaces::reads).
using Frictions = Chosen<  //
    Coulomb,               //
    TanhFriction           //
    >;

/// Frictions of spheres, likewise: `respond(SlidingContact<T>, TangentialSpring<T>&)` for one contact or for eight.
using SphereFrictions = Chosen<  //
    Mindlin,                     //
    TanhFriction                 //
    >;

}  // namespace riprap::contact
