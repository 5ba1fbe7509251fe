// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap {

/// Memory that this process may still take without making the machine swap or being ended: the least of what the
/// system calls available, what `ulimit -v` leaves and what a control group leaves; infinite where none is known [B].
double available_memory();

}  // namespace riprap
