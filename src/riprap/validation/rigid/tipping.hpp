// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/elastic_foot.hpp"

namespace riprap::validation::rigid {

/// A box that stands on a half-space and is about to tip over its lower edge.
struct StandingBlock {
    double width, height;  ///< along the slope and normal to it [m]; 1 m long
    double density;        ///< [kg/m^3]
    double stiffness;      ///< k_n [Pa]

    /// Foot of the block: a half-space has no field of its own, so K = k_n/r of the block alone.
    contact::ElasticFoot foot() const;
};

}  // namespace riprap::validation::rigid
