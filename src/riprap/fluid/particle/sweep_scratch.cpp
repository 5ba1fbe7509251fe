// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_scratch.hpp"

namespace riprap::fluid {

SweepScratch::SweepScratch() : data_(std::make_unique<SweepScratchData>()) {}
SweepScratch::~SweepScratch() = default;
SweepScratch::SweepScratch(SweepScratch&&) noexcept = default;
SweepScratch& SweepScratch::operator=(SweepScratch&&) noexcept = default;

}  // namespace riprap::fluid
