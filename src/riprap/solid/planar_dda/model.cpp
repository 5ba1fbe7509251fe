// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/state.hpp"

namespace riprap::solid::planar_dda {

std::string Model::name_of(std::int32_t block) const {
    return at(block) < names.size() ? names[at(block)] : fmt::format("block {}", block);
}

void Model::set_joint(std::int32_t material_a, std::int32_t material_b, const Joint& joint) {
    joints.resize(materials.size() * materials.size());
    joints[at(material_a) * materials.size() + at(material_b)] = joint;
    joints[at(material_b) * materials.size() + at(material_a)] = joint;
}

Settings settings_for(double half_extent, double displacement_ratio) {
    Settings settings;
    settings.displacement_limit = displacement_ratio * half_extent;
    settings.close_tolerance = settings.open_tolerance = 1e-11 * half_extent;
    settings.multiplier_tolerance = 1e-10 * half_extent;
    return settings;
}

geometry::Outcome<std::int32_t> Builder::add_block(std::span<const Vec2> corners, std::int32_t material,
                                                   bool is_fixed) {
    const geometry::Outcome<geometry::Polygon> outcome = geometry::make_polygon(corners);
    if (!outcome) {
        return outcome.problems();
    }
    const geometry::Polygon& polygon = outcome.value();
    Model& model = *model_;
    const auto block = model.block_count();
    const geometry::PolygonMoments moments = geometry::moments_of(polygon);
    const auto first = static_cast<std::int32_t>(model.corner.size());
    const auto count = static_cast<std::int32_t>(polygon.size());
    double perimeter = 0;
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t next = (k + 1) % count, before = (k + count - 1) % count;
        model.corner.push_back(polygon[at(k)] - moments.centroid);
        model.corner_block.push_back(block);
        model.corner_next.push_back(first + next);
        model.corner_before.push_back(first + before);
        const double turn = cross(polygon[at(k)] - polygon[at(before)], polygon[at(next)] - polygon[at(k)]);
        model.is_convex.push_back(turn > 0 ? 1 : 0);
        perimeter += norm(polygon[at(next)] - polygon[at(k)]);
    }
    model.corner_begin.push_back(first + count);
    model.material.push_back(material);
    model.is_fixed.push_back(is_fixed ? 1 : 0);
    model.area.push_back(moments.area);
    model.mass.push_back(model.materials[at(material)].density * moments.area * model.thickness);
    model.moment_xx.push_back(moments.xx / moments.area);
    model.moment_yy.push_back(moments.yy / moments.area);
    model.moment_xy.push_back(moments.xy / moments.area);
    model.width.push_back(2 * moments.area / perimeter);
    State& state = *state_;
    state.x.push_back(moments.centroid.x);
    state.y.push_back(moments.centroid.y);
    state.stretch_xx.push_back(1);
    state.stretch_yy.push_back(1);
    state.stretch_xy.push_back(0);
    state.rates.resize(state.rates.size() + 6, 0.0);
    for (auto* field : {&state.angle, &state.stress_x, &state.stress_y, &state.stress_xy}) {
        field->push_back(0);
    }
    return block;
}

Vec2 Builder::local_of(std::int32_t block, const Vec2& at_place) const {
    return at_place - Vec2{state_->x[at(block)], state_->y[at(block)]};
}

void Builder::fix_point(std::int32_t block, const Vec2& at_place, double stiffness) {
    model_->fixed_points.push_back({block, local_of(block, at_place), at_place, stiffness});
}

void Builder::add_load(std::int32_t block, const Vec2& at_place, const Vec2& force) {
    model_->point_loads.push_back({block, local_of(block, at_place), force});
}

void Builder::add_bolt(std::int32_t first, const Vec2& first_at, std::int32_t second, const Vec2& second_at,
                       double stiffness, double pretension) {
    const double length = norm(second_at - first_at);
    model_->bolts.push_back({first, second, local_of(first, first_at), local_of(second, second_at), stiffness,
                             length - pretension / stiffness});
}

std::int32_t Builder::add_measured_point(std::int32_t block, const Vec2& at_place) {
    model_->measured_points.push_back({block, local_of(block, at_place)});
    return static_cast<std::int32_t>(model_->measured_points.size()) - 1;
}

std::vector<geometry::GeometryProblem> problems_of(const Model& model) {
    std::vector<geometry::GeometryProblem> problems;
    double stiffest = 0;
    for (std::size_t m = 0; m < model.materials.size(); ++m) {
        const Material& material = model.materials[m];
        stiffest = std::max(stiffest, material.youngs_modulus);
        const double largest = model.plane == PlaneState::strain ? 0.5 : 1.0;
        if (!(material.density > 0) || !(material.youngs_modulus > 0)) {
            problems.push_back({fmt::format("material {}: density {}, Young's modulus {}", m, material.density,
                                            material.youngs_modulus),
                                "positive numbers"});
        }
        if (!(material.poisson_ratio > -1 && material.poisson_ratio < largest)) {
            problems.push_back({fmt::format("material {}: Poisson's ratio {}", m, material.poisson_ratio),
                                fmt::format("between -1 and {}", largest)});
        }
    }
    const double limit = 1e6 * stiffest * model.thickness;
    std::vector<double> told;  // pairs of materials mostly have the same stiffness
    for (const Joint& joint : model.joints) {
        for (const auto& [name, stiffness] : {std::pair{"contact_stiffness", joint.normal_stiffness},
                                              std::pair{"shear stiffness", joint.shear_stiffness}}) {
            if (!(stiffness > 0 && stiffness <= limit) &&
                std::find(told.begin(), told.end(), stiffness) == told.end()) {
                told.push_back(stiffness);
                problems.push_back({fmt::format("{} is {:.3g} N/m", name, stiffness),
                                    fmt::format("above 0, at most {:.3g} N/m (1e6 E times the thickness)", limit)});
            }
        }
    }
    return problems;
}

}  // namespace riprap::solid::planar_dda
