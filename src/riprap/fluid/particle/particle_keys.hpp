// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/key.hpp"

namespace riprap::fluid {

/// Keys that every fluid of particles has, bound to the members of S with these names.
template <class S>
KeyList<S> particle_keys() {
    return {
        key::number(&S::spacing, "spacing", dimension::length, key::positive(), "Distance of particles at the start.")
            .required(),
        key::number(&S::smoothing_ratio, "smoothing_ratio", dimension::plain, key::between(1, 3),
                    "Smoothing length over spacing; the kernel ends at twice that."),
        key::number(&S::rest_density, "density", dimension::density, key::positive(), "At rest, without pressure.")};
}

}  // namespace riprap::fluid
