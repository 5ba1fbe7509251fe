// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/remedy_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/settings.hpp"

namespace riprap::run {

namespace {

/// Rounds to two digits, away from zero or towards it.
std::string two_digits(double value, bool is_up) {
    if (!(value > 0) || !std::isfinite(value)) {
        return fmt::format("{:g}", value);
    }
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1), digits = value / unit;
    constexpr double round_off = 1e-9;
    return fmt::format("{:.2g}", unit * (is_up ? std::ceil(digits - round_off) : std::floor(digits + round_off)));
}

}  // namespace

std::string assignment(std::string_view key, double value) {
    return fmt::format("{} = {}", key, two_digits(value, true));
}
std::string assignment(std::string_view key, std::string_view word) { return fmt::format("{} = \"{}\"", key, word); }
std::string assignment_below(std::string_view key, double value) {
    return fmt::format("{} = {}", key, two_digits(value, false));
}

namespace {

/// "material.rock.normal_stiffness = 3e7", of the materials of both bodies.
std::string of_materials(const sim::Model& model, BodyId a, BodyId b, double factor) {
    std::string text;
    for (const BodyId body : {a, b}) {
        const material::Material& own = model.materials[model.bodies.material[static_cast<std::size_t>(body.value)]];
        const std::string one =
            assignment(fmt::format("material.{}.normal_stiffness", own.name), factor * own.normal_stiffness);
        if (text.find(one) == std::string::npos) {
            text += (text.empty() ? "" : " and ") + one;
        }
    }
    return text;
}

}  // namespace

std::string stiffness_text(const sim::Model& model, BodyId a, BodyId b, bool is_of_faces, double factor) {
    if (const auto* elasticity = sim::elasticity_of(model.solid)) {
        return elasticity->stiffness_per_area
                   ? assignment("solid.contact_stiffness_per_area", factor * *elasticity->stiffness_per_area)
                   : assignment("solid.contact_stiffness", factor * elasticity->contact_stiffness);
    }
    if (const auto* spheres = std::get_if<solid::SphereDemSettings>(&model.solid); spheres != nullptr && !is_of_faces) {
        return spheres->laws.normal == contact::NormalLaw::hertz
                   ? assignment("solid.youngs_modulus", factor * spheres->youngs_modulus)
                   : assignment("solid.spring_stiffness", factor * spheres->spring_stiffness);
    }
    return of_materials(model, a, b, factor);
}

}  // namespace riprap::run
