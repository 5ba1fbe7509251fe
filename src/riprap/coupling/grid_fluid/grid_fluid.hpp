// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/account.hpp"
#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/coupling/field_scene.hpp"
#include "riprap/coupling/fluid_method.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/coupling/fluid_traits.hpp"
#include "riprap/coupling/gauge_query.hpp"
#include "riprap/coupling/grid_fluid/fields.hpp"
#include "riprap/coupling/grid_fluid/pressed_pocket.hpp"
#include "riprap/coupling/grid_fluid/settings.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/fluid/grid/grid_step.hpp"
#include "riprap/fluid/grid/read.hpp"
#include "riprap/fluid/grid/shown_water.hpp"

namespace riprap::coupling {

/// Returns the waves that each side which lets waves out absorbs: "the high side of x absorbs waves of kd below 0.314:
/// longer than 120 m, of periods above 15.8 s, in 6 m of water".
std::vector<std::string> absorbed_ranges(const GridFluidSettings& settings);

/// Says how many cells the grid has: "80 x 60 cells, the narrowest 0.01 m wide"; empty before it is made.
std::string cells_text(const GridFluidSettings& settings);

/// Water and air on fixed cells that bodies are cut out of: FluidMethod (docs/theory/grid.md, 10). Bodies stand where
/// they are at mid-step and move as they do at its end, v_(n+1) = v_(n+1/2) + a dt/2, so that a pressure solve answers
/// the acceleration of light bodies in full. Kinetic and potential energy are means of both ends of a step; what they
/// lose beyond the work on bodies and through sides is booked as dissipated: viscosity, resistance of stones and what
/// the schemes take.
class GridFluid final : public FluidMethod {
 public:
    using Settings = GridFluidSettings;
    using Fields = GridFluidFields;
    struct Scratch {
        fluid::grid::GridScratch grid;
        std::vector<std::vector<geometry::Polyhedron>> shapes;  ///< parts of bodies, body frame
        std::optional<BodyCutter> cutter;
        std::vector<GridBody> bodies;
        CutBodies cut;
        std::vector<double> at_start;  ///< water fraction then; empty where water is not carried [-]
        std::vector<PressedPocket> pressed;
        std::vector<double> feedback;  ///< added mass over mass of bodies, as far as they are wet [-]
        std::vector<GridLoad> loads;
        fluid::grid::Energy before;
        double due_before{0};  ///< work on bodies until the middle of the step [J]
        Vec3 momentum_before{};
        double power{0};  ///< of the last loads on all bodies [W]
        linear::PoissonReport solve;
        std::int64_t iterations{0};  ///< of the pressure in the step, all passes
        std::size_t bytes() const;
    };
    static std::span<const Account> accounts();

    GridFluid(const FluidScene& scene, const Settings& settings, const FluidState& state, Fields& fields,
              Scratch& scratch);

    StepLimit limit() const override;
    Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                  FluidStep& report) override;
    void load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) override;
    Outcome kick(const TimeSpan& span, FluidStep& report) override;
    /// Refuses a step by the end of which more than a splash has left through the open top.
    Outcome end(const TimeSpan& span, FluidStep& report) override;
    std::span<const double> feedback() const override { return scratch_->feedback; }

    /// Reads a gauge of any kind. Without scratch, bodies are cut anew.
    static fluid::GaugeReading read(const GaugeQuery<GridFluid>& query);
    /// Says how much water has left through the open top and was let go; empty where none has.
    static std::string let_go_text(const Settings& settings, const Fields& fields);
    static fluid::ShownFluid shown(const ShownQuery<Settings>& query);
    static constexpr FluidTraits<Settings> traits{
        .offers = fluid::reading::all,
        .spacing = [](const Settings& settings) { return settings.spacing; },
        .cell_width = [](const Settings& settings) { return settings.grid.mesh.smallest_width(); },
        .domain = [](const Settings& settings) { return &settings.scene.domain; },
        .courant = [](const Settings& settings) { return settings.courant; },
        .accounts = &accounts,
        .let_go_text = &let_go_text,
        .absorbed_ranges = &absorbed_ranges,
        .cells_text = &cells_text,
        .shown = &shown,
        .shows_surface = true};

 private:
    const FluidScene* scene_;
    const Settings* settings_;
    const CouplingState* coupling_;
    Fields* fields_;
    Scratch* scratch_;
};

}  // namespace riprap::coupling
