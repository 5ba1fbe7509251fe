// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/registry.hpp"

#include <vector>

#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"

namespace riprap::validation {

std::span<const ValidationCase> all_cases() {
    static const std::vector<ValidationCase> cases = [] {
        std::vector<ValidationCase> all = file_cases();
        const std::vector<ValidationCase> crossed = cross::scenes();
        all.insert(all.end(), crossed.begin(), crossed.end());
        return all;
    }();
    return cases;
}

}  // namespace riprap::validation
