// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/hydrostatic/hydrostatic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/coupling/hydrostatic/basins.hpp"
#include "riprap/coupling/hydrostatic/held_faces.hpp"
#include "riprap/coupling/hydrostatic/joint_cover.hpp"
#include "riprap/coupling/hydrostatic/pressure_on_polygon.hpp"

namespace riprap::coupling {

std::vector<KeyProblem> HydrostaticSettings::prepare(const FieldScene& scene) {
    up = scene.up;
    levels = scene.levels;
    is_dry = scene.is_dry;
    is_planar = scene.domain.dimension == 2;
    for (const FillRegion& region : scene.regions) {
        Basin basin = basin_of(region, scene.domain, scene.up);
        basin.level = std::min(basin.level, top_of(region, scene.domain, scene.up));
        basins.push_back(std::move(basin));
    }
    return {};
}

double HydrostaticSettings::level_at(const Basin& basin, double time) const {
    if (levels.empty()) {
        return basin.level;
    }
    const auto next = std::find_if(levels.begin(), levels.end(), [&](const LevelAt& row) { return row.time > time; });
    if (next == levels.begin()) {
        return levels.front().level;
    }
    const LevelAt before = *(next - 1);
    return next == levels.end()
               ? before.level
               : before.level + (next->level - before.level) * (time - before.time) / (next->time - before.time);
}

namespace {

Vec3 middle_of(const std::vector<Vec3>& corners) {
    Vec3 sum{};
    for (const Vec3& x : corners) {
        sum += x;
    }
    return sum / static_cast<double>(corners.size());
}

/// Pressure on one panel of a body that moves, about its centre of mass.
struct PanelPush {
    PressureIntegral pressure;
    Vec3 normal;
};

/// Adds up the pressure on what stands in water of a face of a fixed or driven body, as if its joints were open.
PanelPush push_on_held(const FluidScene& scene, const HydrostaticSettings& settings, const body::Motion& motion,
                       const std::vector<Vec3>& arms, const Vec3& center, double weight, double time) {
    std::vector<Vec3> face;
    for (const Vec3& arm : arms) {
        face.push_back(center + arm);
    }
    PanelPush push{{}, normal_of(arms)};
    for (WetPiece& piece : wet_pieces(scene, settings, motion, face, lies_on_share * settings.spacing)) {
        for (Vec3& x : piece.corner) {
            x -= center;
        }
        const double level = settings.level_at(*piece.basin, time) - dot(center, settings.up);
        const PressureIntegral pressure = pressure_on_polygon(piece.corner, settings.up, level, weight);
        push.pressure.of_pressure += pressure.of_pressure;
        push.pressure.of_moment += pressure.of_moment;
    }
    return push;
}

}  // namespace

HydrostaticFluid::HydrostaticFluid(const FluidScene& scene, const Settings& settings, const FluidState& /*state*/,
                                   Fields& /*fields*/, Scratch& scratch)
    : scene_(&scene), settings_(&settings), scratch_(&scratch) {
    if (!scratch.is_made) {
        scratch.panels =
            cut_faces(scene, settings,
                      settings.uplift == Uplift::full ? std::numeric_limits<double>::infinity() : settings.spacing);
        scratch.is_made = true;
    }
}

void HydrostaticFluid::load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) {
    const auto bodies = at(scene_->bodies.size());
    const std::vector<Panel>& panels = scratch_->panels;
    const double weight = settings_->rest_density * norm(scene_->gravity.at(span.middle()));
    const std::vector<double> cover =
        settings_->uplift == Uplift::full ? std::vector<double>{} : joint_shares(*scene_, *settings_, middle, panels);
    std::vector<PanelPush> pushes(panels.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(panels.size()), 64, [&](std::int64_t index) {
        const Panel& panel = panels[at(index)];
        const auto b = at(panel.body);
        std::vector<Vec3> arms;
        for (const Vec3& corner : panel.corner) {
            arms.push_back(arm_of(middle, b, corner));
        }
        const Vec3& center = middle.pose[b].position;
        if (!body::may_move(scene_->bodies, b)) {
            pushes[at(index)] = push_on_held(*scene_, *settings_, middle, arms, center, weight, span.middle());
            return;
        }
        const Vec3 place = center + middle_of(arms);
        const HydrostaticSettings::Basin* basin = nearest_basin(*settings_, place);
        const double share = cover.empty() ? 1 : cover[at(index)];
        // a face on the side of a region stays wet as its block strains
        const double slack = lies_on_share * settings_->spacing;
        const bool is_open = share >= 1 && basin != nullptr && distance_from(*basin, *settings_, place) > slack;
        if (basin == nullptr || share <= 0) {
            return;
        }
        if (is_open && (settings_->uplift != Uplift::full || !lies_on_another(*scene_, *settings_, middle, panel))) {
            return;  // a dry face
        }
        const double level = settings_->level_at(*basin, span.middle()) - dot(center, settings_->up);
        pushes[at(index)] = {share * pressure_on_polygon(arms, settings_->up, level, weight), normal_of(arms)};
    });
    loads.pressure.clear(bodies, middle.deforms());
    loads.viscous.clear(bodies, middle.deforms());
    scratch_->power = 0;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const auto b = at(panels[i].body);
        const PressureIntegral& p = pushes[i].pressure;
        const Vec3& n = pushes[i].normal;
        loads.pressure.force[b] -= p.of_pressure * n;
        loads.pressure.torque[b] -= cross(p.of_moment, n);
        if (middle.deforms()) {
            loads.pressure.pull[b] += -1.0 * symmetric_product(n, p.of_moment);
        }
    }
    for (std::size_t b = 0; b < bodies; ++b) {
        scratch_->power += dot(loads.pressure.force[b], middle.velocity[b]) +
                           dot(loads.pressure.torque[b], middle.angular_velocity[b]);
        if (middle.deforms()) {
            scratch_->power += contract(loads.pressure.pull[b], middle.stretch_rate[b]);
        }
    }
}

Outcome HydrostaticFluid::kick(const TimeSpan& span, FluidStep& report) {
    report.balance.work_on_solids = span.dt * scratch_->power;
    report.balance.work_external = report.balance.work_on_solids;  // the work that keeps the level
    return {};
}

namespace {

/// Still water as gauges read it.
class StillReader : public fluid::WaterReader {
 public:
    explicit StillReader(const GaugeQuery<HydrostaticFluid>& query) : query_(query) {}
    double pressure(const Vec3& x) const override {
        return std::max(0.0, query_.settings.rest_density * norm(query_.scene.gravity.at(query_.time)) * depth(x));
    }
    Vec3 velocity(const Vec3& /*x*/) const override { return {}; }
    double level(const Vec3& x, const Vec3& /*up*/) const override { return std::max(0.0, depth(x)); }

 private:
    /// Of a place below the surface [m]; 0 where there is no basin.
    double depth(const Vec3& x) const {
        const HydrostaticSettings& settings = query_.settings;
        const HydrostaticSettings::Basin* basin = nearest_basin(settings, x);
        const bool is_wet = basin != nullptr && distance_from(*basin, settings, x) == 0;
        return is_wet ? settings.level_at(*basin, query_.time) - dot(x, settings.up) : 0;
    }

    const GaugeQuery<HydrostaticFluid>& query_;
};

}  // namespace

fluid::GaugeReading HydrostaticFluid::read(const GaugeQuery<HydrostaticFluid>& query) {
    return query.gauge.kind->read(query.gauge, StillReader(query));
}

}  // namespace riprap::coupling
