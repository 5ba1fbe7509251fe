// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap {

/// Reads the command line and does what it asks. Returns the exit code; errors of the input come as exceptions.
int command_line(int argument_count, char** arguments);

}  // namespace riprap
