// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/fluid_method.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/fluid_traits.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/no_fluid_settings.hpp"

namespace riprap::coupling {

/// A scene without a fluid: FluidMethod that does nothing.
class NoFluid final : public FluidMethod {
 public:
    using Settings = NoFluidSettings;
    using Fields = NoFields;
    struct Scratch {
        std::size_t bytes() const { return 0; }
    };
    static constexpr FluidTraits<Settings> traits{
        .is_there = false, .leads = false, .books_every_step = [](const Settings&) { return true; }};

    NoFluid(const FluidScene& /*scene*/, const Settings& /*settings*/, const FluidState& /*state*/, Fields& /*fields*/,
            Scratch& /*scratch*/) {}
    Outcome begin(const TimeSpan& /*span*/, const body::Motion& /*now*/, const body::Motion& /*middle*/,
                  FluidStep& /*report*/) override {
        return {};
    }
    void load(const TimeSpan& /*span*/, const body::Motion& /*middle*/, FluidLoads& /*loads*/) override {}
    Outcome kick(const TimeSpan& /*span*/, FluidStep& /*report*/) override { return {}; }
    static fluid::GaugeReading read(const GaugeQuery<NoFluid>& /*query*/) {
        return {std::numeric_limits<double>::quiet_NaN()};
    }
};

}  // namespace riprap::coupling
