// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/complete_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "riprap/body/may_move.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/sim/complete_settings.hpp"

namespace riprap::scene {

namespace {

/// Largest arm of a normal of the surface about the centre of mass, at most sqrt(R^2 - r^2) of the farthest point and
/// the inscribed sphere; none of a ball [m].
double arm_of_normals(const sim::Model& model, std::int32_t body) {
    double largest = 0;
    for (std::int32_t p = model.bodies.part_begin[at(body)]; p < model.bodies.part_begin[at(body) + 1]; ++p) {
        const body::Part& part = model.bodies.parts[at(p)];
        const geometry::ConvexView shape = model.shapes.view(part.shape);
        if (shape.vertex_count == 0) {
            continue;  // a half-space
        }
        const double offset = norm(part.local.position), r = shape.circumradius, inside = shape.inscribed_radius;
        largest = std::max(largest, offset + std::sqrt(std::max(0.0, r * r - inside * inside)));
    }
    return largest;
}

/// Speed at which a driven body comes upon free ones: of its surface as it turns, and of its centre where a free body
/// is in its way; the largest of 256 moments of the run and of its motion [m/s].
double driven_speed(const sim::Model& model, const sim::State& state, std::int32_t body) {
    constexpr int moments = 256;
    const body::DrivenBody& driven = model.bodies.driven_bodies[at(model.bodies.driven[at(body)])];
    const body::PrescribedMotion& motion = model.bodies.motions[at(driven.motion)];
    const double begin = std::max(0.0, motion.start), end = std::min(model.time.end, motion.stop);
    const double arm = arm_of_normals(model, body);
    double fastest = 0;
    for (int i = 0; i <= moments; ++i) {
        const body::DrivenState now = body::evaluate(motion, driven.start, begin + (end - begin) * i / moments);
        double along = norm(now.velocity);
        if (along > fastest) {  // else it changes nothing
            const Meeting met = first_met(model, state, BodyId{body}, now.velocity / along);
            along = met.part >= 0 && model.bodies.drive[at(met.other.value)] == body::Drive::free ? along : 0;
        }
        fastest = std::max(fastest, along + arm * norm(now.angular_velocity));
    }
    return fastest;
}

/// Speed after a fall along gravity onto the first body below, with that of the surface as the body turns [m/s].
double fall_speed(const sim::Model& model, const sim::State& state, std::int32_t body) {
    const Vec3 gravity = model.gravity.value, velocity = state.bodies.velocity[at(body)];
    const double spin =
        arm_of_normals(model, body) * norm(body::angular_velocity(model.bodies, state.bodies, BodyId{body}));
    const double pull = norm(gravity), start = norm(velocity) + spin;
    const Meeting met = pull > 0 ? first_met(model, state, BodyId{body}, gravity / pull) : Meeting{};
    if (met.part < 0) {
        return start;
    }
    double own = std::numeric_limits<double>::infinity();
    for (std::int32_t p = model.bodies.part_begin[at(body)]; p < model.bodies.part_begin[at(body) + 1]; ++p) {
        own = std::min(own, model.shapes.view(model.bodies.parts[at(p)].shape).inscribed_radius);
    }
    const double way = std::max(0.0, met.distance - own), at_end = start + pull * model.time.end;
    return std::min(at_end, std::sqrt(start * start + 2 * pull * way));
}

/// A key of [solid] and its value.
struct KeyedStiffness {
    const char* key{nullptr};  ///< none where the method has no such springs
    const char* unit{""};
    double value{0};  ///< [Pa] or [N/m]
};

KeyedStiffness stiffness_of(const sim::SolidSettings& solid) {
    const auto* const spheres = std::get_if<solid::SphereDemSettings>(&solid);
    if (spheres == nullptr) {
        return {};
    }
    return spheres->laws.normal == contact::NormalLaw::hertz
               ? KeyedStiffness{"youngs_modulus", "Pa", spheres->youngs_modulus}
               : KeyedStiffness{"spring_stiffness", "N/m", spheres->spring_stiffness};
}

}  // namespace

double impact_speed(const sim::Model& model, const sim::State& state) {
    constexpr double most_pairs = 2e7;  // of bodies and parts, as of find_hard_impacts
    const body::BodySet& bodies = model.bodies;
    const auto looked_at =
        static_cast<std::int64_t>(std::min<double>(bodies.size(), most_pairs / std::max(1, bodies.part_count())));
    std::vector<double> speed(at(bodies.size()), 0);
    parallel::for_each_uneven(looked_at, 16, [&](std::int64_t i) {
        const auto body = static_cast<std::int32_t>(i);
        if (may_move(bodies, at(i))) {  // a held body falls when it is let go
            speed[at(i)] = fall_speed(model, state, body);
        }
        if (bodies.drive[at(i)] == body::Drive::driven) {
            speed[at(i)] = std::max(speed[at(i)], driven_speed(model, state, body));
        }
    });
    double fastest = 0;
    for (const double one : speed) {
        fastest = std::max(fastest, one);
    }
    return fastest;
}

void complete_solid(CaseBuild& build) {
    sim::Model& model = build.model;
    const KeyedStiffness before = stiffness_of(model.solid);
    if (before.key == nullptr) {
        return;
    }
    model.solid = sim::completed_settings(model, build.state.bodies, impact_speed(model, build.state));
    const KeyedStiffness after = stiffness_of(model.solid);
    if (before.value != after.value) {
        build.notes.push_back(
            fmt::format("solid.{} is {:.3g} {}, as the scene asks for", after.key, after.value, after.unit));
    }
}

std::string completed_toml(const LoadedCase& loaded) {
    std::vector<Diagnostic> problems;
    Value root = parse_toml(loaded.resolved_toml, "the resolved case", problems);
    Value* solid = root.find("solid");
    const KeyedStiffness stiffness = stiffness_of(loaded.model.solid);
    if (const Value* old = stiffness.key != nullptr && solid != nullptr ? solid->find(stiffness.key) : nullptr;
        old != nullptr && old->is_text()) {
        solid->set(stiffness.key, Value::of(stiffness.value));
    }
    return write_toml(root);
}

}  // namespace riprap::scene
