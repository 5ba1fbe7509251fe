// SPDX-License-Identifier: Apache-2.0
#include "riprap/material/material_set.hpp"

#include <algorithm>
#include <cmath>

namespace riprap::material {

double mix(Mixing rule, double a, double b) {
    switch (rule) {
        case Mixing::minimum:
            return std::min(a, b);
        case Mixing::maximum:
            return std::max(a, b);
        case Mixing::mean:
            return 0.5 * (a + b);
        case Mixing::geometric:
            return std::sqrt(a * b);
        case Mixing::harmonic:
            return a + b > 0 ? 2 * a * b / (a + b) : 0;
    }
    return 0;
}

namespace {
/// The mean of two stiffnesses given in N/m; where only one is given, that one: 0 means none, not soft.
double mix_literal(double a, double b) { return a > 0 && b > 0 ? mix(Mixing::mean, a, b) : std::max(a, b); }
}  // namespace

void mix_pairs(MaterialSet& set, Mixing friction_rule, Mixing cohesion_rule) {
    set.pairs.clear();
    for (const Material& a : set.materials) {
        for (const Material& b : set.materials) {
            set.pairs.push_back({.shear_ratio = mix(Mixing::mean, a.shear_ratio, b.shear_ratio),
                                 .shear_stiffness = mix_literal(a.shear_stiffness, b.shear_stiffness),
                                 .friction = mix(friction_rule, a.friction, b.friction),
                                 .cohesion = mix(cohesion_rule, a.cohesion, b.cohesion),
                                 .tensile_strength = mix(cohesion_rule, a.tensile_strength, b.tensile_strength),
                                 .damping_ratio = mix(Mixing::mean, a.damping_ratio, b.damping_ratio),
                                 .has_torsion = a.has_torsion && b.has_torsion});
        }
    }
}

}  // namespace riprap::material
