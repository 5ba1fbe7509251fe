// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/solid/affine/block_contacts.hpp"

namespace riprap::solid::affine {

/// Says why blocks and contacts that were read from a file are not those of so many bodies; empty where they are.
std::string misfit(const BlockState& blocks, const BlockContactHistory& contacts, std::int32_t bodies);

}  // namespace riprap::solid::affine
