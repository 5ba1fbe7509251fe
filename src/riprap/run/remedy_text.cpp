// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

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
    return std::visit(
        [&](const auto& settings) -> std::string {
            if constexpr (requires { settings.elasticity.stiffness_per_area; }) {
                return settings.elasticity.stiffness_per_area
                           ? assignment("solid.contact_stiffness_per_area",
                                        factor * *settings.elasticity.stiffness_per_area)
                           : assignment("solid.contact_stiffness", factor * settings.elasticity.contact_stiffness);
            } else if constexpr (requires { settings.spring_stiffness; }) {
                if (!is_of_faces) {
                    return settings.laws.normal == contact::NormalLaw::hertz
                               ? assignment("solid.youngs_modulus", factor * settings.youngs_modulus)
                               : assignment("solid.spring_stiffness", factor * settings.spring_stiffness);
                }
            }
            return of_materials(model, a, b, factor);
        },
        model.solid);
}

}  // namespace riprap::run
