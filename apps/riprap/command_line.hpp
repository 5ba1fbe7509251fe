// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "built_in.hpp"

namespace riprap {

/// Reads the command line and does what it asks. Returns the exit code; errors of the input come as exceptions.
int command_line(const Words& words, const BuiltIn& built_in);

}  // namespace riprap
