// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// Makes delta_sph with the loops of a device: on the GPU in use where the program was built for one and finds it, else
/// on the host, with the same bits.
std::unique_ptr<ParticleScheme> make_device_scheme(const SphSettings& settings);
/// The same on the host, wherever there is a device.
std::unique_ptr<ParticleScheme> make_device_scheme_on_host(const SphSettings& settings);
/// Tells whether make_device_scheme takes a device.
bool has_device();
/// Returns the name of that device, or "none" and why.
std::string device_name();

}  // namespace riprap::fluid
