// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/obj.hpp"

#include "surface_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    riprap::geometry::read_and_audit(data, size, riprap::geometry::read_obj);
    return 0;
}
