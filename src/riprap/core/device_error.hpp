// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace riprap {

/// A device refused something; the message says what was asked, the device's reason and what may help.
class DeviceError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace riprap
