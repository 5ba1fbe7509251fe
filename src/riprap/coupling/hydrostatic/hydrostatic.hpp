// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "riprap/core/fields.hpp"
#include "riprap/coupling/fluid_method.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/fluid_traits.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/hydrostatic/settings.hpp"

namespace riprap::coupling {

/// A fluid at rest under gravity: FluidMethod. It presses on faces with
///
///     p = rho |g| (level - up . x) where positive,
///
/// integrated exactly over each face, or over each of its panels where joints are sought: force -n int p dA, torque
/// -(int p r dA) x n, pull -sym(n (int p r dA)^T), r from the centre of mass. So a body under water is lighter
/// by the weight of its volume of water, to round-off, and a floating body finds its draft. It has no inertia: no added
/// mass, no waves, no damping; its work on bodies is booked as external.
class HydrostaticFluid final : public FluidMethod {
 public:
    using Settings = HydrostaticSettings;
    using Fields = NoFields;
    /// A flat convex piece of a face.
    struct Panel {
        std::int32_t body;
        std::vector<Vec3> corner;  ///< counter-clockwise seen from outside, body frame [m]
        Vec3 normal;               ///< outward, body frame [-]
    };
    struct Scratch {
        std::vector<Panel> panels;  ///< of bodies that forces may move; a function of Model
        double power{0};            ///< of the last loads on all bodies [W]
        bool is_made{false};
        std::size_t bytes() const { return panels.size() * (sizeof(Panel) + 4 * sizeof(Vec3)); }
    };
    /// Gauges read what means something in still water.
    static constexpr FluidTraits<Settings> traits{
        .leads = false, .offers = fluid::reading::pressure | fluid::reading::velocity | fluid::reading::level};

    HydrostaticFluid(const FluidScene& scene, const Settings& settings, const FluidState& state, Fields& fields,
                     Scratch& scratch);

    Outcome begin(const TimeSpan& /*span*/, const body::Motion& /*now*/, const body::Motion& /*middle*/,
                  FluidStep& /*report*/) override {
        return {};
    }
    void load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) override;
    Outcome kick(const TimeSpan& span, FluidStep& report) override;
    static fluid::GaugeReading read(const GaugeQuery<HydrostaticFluid>& query);

 private:
    const FluidScene* scene_;
    const HydrostaticSettings* settings_;
    Scratch* scratch_;
};

}  // namespace riprap::coupling
