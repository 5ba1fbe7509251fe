// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/case_trial.hpp"

#include "riprap/scene/read_case.hpp"

namespace riprap::validation {

Trial trial_of(const CaseSetting& setting, std::span<const std::string> overrides) {
    scene::LoadedCase loaded = scene::read_case((setting.folder / "case.toml").string(), overrides);
    Trial trial(std::move(loaded.model), std::move(loaded.state));
    trial.tell(setting.after_step);
    return trial;
}

}  // namespace riprap::validation
