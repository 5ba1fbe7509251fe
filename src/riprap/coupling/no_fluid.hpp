// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/fluid_report.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/no_fluid_settings.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"

namespace riprap::coupling {

/// A scene without a fluid: FluidMethod that does nothing.
class NoFluid {
 public:
    using Settings = NoFluidSettings;
    using Fields = NoFields;
    struct Scratch {
        std::size_t bytes() const { return 0; }
    };
    static constexpr bool is_there = false;
    static constexpr bool leads = false;
    static bool books_every_step(const Settings& /*settings*/) { return true; }

    NoFluid(const FluidScene& /*scene*/, const Settings& /*settings*/, const FluidState& /*state*/, Fields& /*fields*/,
            Scratch& /*scratch*/) {}
    StepLimit limit() const { return {}; }
    void tidy(std::int64_t /*step*/) {}
    void drive(const TimeSpan& /*span*/, std::vector<Vec3>& /*correction*/) {}
    Outcome begin(const TimeSpan& /*span*/, const body::Motion& /*now*/, const body::Motion& /*middle*/,
                  FluidStep& /*report*/) {
        return {};
    }
    void load(const TimeSpan& /*span*/, const body::Motion& /*middle*/, FluidLoads& /*loads*/) {}
    Outcome kick(const TimeSpan& /*span*/, FluidStep& /*report*/) { return {}; }
    Outcome end(const TimeSpan& /*span*/, FluidStep& /*report*/) { return {}; }
    std::span<const double> feedback() const { return {}; }
    static constexpr unsigned offers = fluid::reading::none;
    static fluid::GaugeReading read(const GaugeQuery<NoFluid>& /*query*/) {
        return {std::numeric_limits<double>::quiet_NaN()};
    }
};

}  // namespace riprap::coupling
