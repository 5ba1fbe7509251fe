// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/body/may_move.hpp"
#include "riprap/contact/law/hertz.hpp"
#include "riprap/contact/law/linear_spring.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Stiffest pair that a material takes part in.
contact::ContactPair stiffest_pair(const SphereModel& model, MaterialId material) {
    contact::ContactPair stiffest;
    for (std::int32_t other = 0; other < model.table.size(); ++other) {
        const contact::ContactPair& pair = model.table.pair(material, MaterialId{other});
        stiffest.modulus = std::max(stiffest.modulus, pair.modulus);
        stiffest.normal_stiffness = std::max(stiffest.normal_stiffness, pair.normal_stiffness);
    }
    return stiffest;
}

double smallest_radius(const SphereSet& spheres, std::size_t body) {
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t s = spheres.begin[body]; s < spheres.begin[body + 1]; ++s) {
        least = std::min(least, spheres.radius[at(s)]);
    }
    return least;
}

double fastest(const body::BodyState& state) {
    const double squared = parallel::reduce(
        state.size(), 0.0, [&](std::int64_t i) { return norm_squared(state.velocity[at(i)]); },
        [](double a, double b) { return std::max(a, b); });
    return std::sqrt(squared);
}

/// Least effective mass that a sphere may meet at the surface of a body that moves and is no sphere, 1/m_e = 1/m +
/// R^2/I, R the farthest point from the centre of mass and I the least principal moment; infinity without such [kg].
double lightest_face(const SphereModel& model) {
    const body::BodySet& bodies = model.bodies;
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (!may_move(bodies, at(b)) || model.spheres.count_of(b) > 0) {
            continue;
        }
        double reach = 0;
        for (std::int32_t p = bodies.part_begin[at(b)]; p < bodies.part_begin[at(b) + 1]; ++p) {
            const body::Part& part = bodies.parts[at(p)];
            reach = std::max(reach, norm(part.local.position) + model.shapes.view(part.shape).circumradius);
        }
        const Vec3& moments = bodies.principal_moments[at(b)];
        const double moment = bodies.is_planar ? moments.z : std::min({moments.x, moments.y, moments.z});
        least = std::min(least, 1 / (1 / bodies.mass[at(b)] + reach * reach / moment));
    }
    return least;
}

}  // namespace

double rayleigh_time(double radius, double density, double youngs_modulus, double poisson_ratio) {
    const double shear_modulus = youngs_modulus / (2 * (1 + poisson_ratio));
    return M_PI * radius * std::sqrt(density / shear_modulus) / (0.1631 * poisson_ratio + 0.8766);
}

SphereStep step_limit(const SphereModel& model, const body::BodyState& state, double gravity) {
    SphereStep step{std::numeric_limits<double>::infinity(), {}, "no sphere can touch another"};
    const double speed = 2 * fastest(state), face = lightest_face(model);
    std::vector<contact::ContactPair> pairs;
    for (std::int32_t m = 0; m < model.table.size(); ++m) {
        pairs.push_back(stiffest_pair(model, MaterialId{m}));
    }
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        if (!may_move(model.bodies, at(b)) || model.spheres.count_of(b) == 0) {
            continue;
        }
        const double radius = smallest_radius(model.spheres, at(b)), mass = model.bodies.mass[at(b)];
        const contact::ContactPair& pair = pairs[at(model.bodies.material[at(b)].value)];
        const double v = std::max({speed, std::sqrt(4 * gravity * radius), 1e-6});
        const double beside_face = mass / (1 + mass / face);  // effective mass against a body that is no sphere
        double duration = 0;
        if (model.settings.normal == contact::NormalLaw::linear) {
            duration = contact::linear_contact_time(pair.normal_stiffness, std::min(0.5 * mass, beside_face), 0);
        } else {
            duration = std::min(contact::hertz_contact_time(pair.modulus, 0.5 * radius, 0.5 * mass, v),
                                contact::hertz_contact_time(pair.modulus, radius, beside_face, v));
        }
        // N springs side by side: an impact lasts N^(-2/5) as long by Hertz, N^(-1/2) on linear springs.
        const bool adds_up =
            model.settings.sharing == contact::Sharing::dashpots || model.settings.sharing == contact::Sharing::sum;
        const double flat = adds_up ? model.spheres.flat_count[at(b)] : 1;
        duration *= std::pow(flat, model.settings.normal == contact::NormalLaw::linear ? -0.5 : -0.4);
        const double limit = duration / model.settings.steps_per_contact;
        if (limit < step.limit) {
            step = {limit, BodyId{b}, "duration of an impact of " + model.bodies.name(BodyId{b})};
        }
    }
    return step;
}

}  // namespace riprap::solid::sphere_dem
