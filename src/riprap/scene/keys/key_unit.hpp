// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap::scene {

/// Unit of the numbers at a path of a case file: "deg" for "material.rock.friction_angle_deg", whose key ends in it,
/// "m/s" for "body.stone.velocity.0", by the table of keys; empty where the key takes none, or there is no such key.
std::string unit_of_key(std::string_view path);

}  // namespace riprap::scene
