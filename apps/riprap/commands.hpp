// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap {

/// `riprap version`
int print_version(bool as_json);

}  // namespace riprap
