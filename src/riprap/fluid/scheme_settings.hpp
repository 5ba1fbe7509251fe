// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

namespace riprap::fluid {

/// The schemes of particle fluids: one line registers a scheme. Its settings are ParticleSettings with its own added,
/// it has a make_scheme(settings), and `fluid.method` chooses it by the name that its settings carry.
using SchemeSettings = std::variant<  //
    SphSettings,                      //
    WcmpsSettings,                    //
    MpsSettings                       //
    >;

/// Returns what all schemes have.
inline const ParticleSettings& base_of(const SchemeSettings& settings) {
    return std::visit([](const auto& own) -> const ParticleSettings& { return own; }, settings);
}
inline ParticleSettings& base_of(SchemeSettings& settings) {
    return std::visit([](auto& own) -> ParticleSettings& { return own; }, settings);
}

/// Tells whether all that is dissipated is booked in the step in which it is.
inline bool books_every_step(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.books_every_step; }, settings);
}
/// Tells whether the first steps after bodies were let go grow from little.
inline bool starts_slowly(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.starts_slowly; }, settings);
}
/// Tells whether water of this scheme may enter and leave.
inline bool takes_openings(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.takes_openings(own); }, settings);
}
/// Tells whether the scheme reads BoundaryParticles::normal.
inline bool takes_normals(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.takes_normals(own); }, settings);
}
/// Tells whether the scheme reads BoundaryParticles::outward_area.
inline bool takes_outward_area(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.takes_outward_area(own); }, settings);
}
/// Tells whether water of this scheme presses in joints between faces.
inline bool takes_joints(const SchemeSettings& settings) {
    return std::visit([](const auto& own) { return own.traits.takes_joints(own); }, settings);
}

}  // namespace riprap::fluid
