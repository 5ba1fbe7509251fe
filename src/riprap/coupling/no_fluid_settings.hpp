// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap {
struct NoFields;  // core/fields.hpp
}

namespace riprap::coupling {

class NoFluid;

/// Settings of a scene without a fluid.
struct NoFluidSettings {
    using Method = NoFluid;
    using Fields = NoFields;
};

}  // namespace riprap::coupling
