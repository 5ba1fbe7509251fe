// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/ledger_advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "riprap/run/remedy/contact_need.hpp"
#include "riprap/run/remedy/remedy_text.hpp"
#include "riprap/scene/warnings/narrow_gaps.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/settings.hpp"

namespace riprap::run {

namespace {

constexpr double shorter = 0.25;

/// Overlap over the inscribed radius above which the law of a contact is far from that of a shallow one [-], and the
/// one that is aimed at.
constexpr double deep = 0.3, shallow = 0.1;

bool is_above_bound(const Refused& refused) {
    return refused.model.time.force_time_step ||
           refused.report.dt > std::min(refused.report.dt_bound, refused.report.fluid_dt_bound);
}

std::string automatic_step(const sim::Model& model) {
    return assignment("time_step", "auto") + (model.time.force_time_step ? " and force_time_step = false" : "");
}

/// Is water pressed together by more than a weakly compressible model may?
bool is_compressed(const Refused& refused) {
    constexpr double most = 1.05;
    const coupling::ParticleFluid* const water = refused.model.particles();
    return water != nullptr &&
           std::any_of(refused.before.fluid.density.begin(), refused.before.fluid.density.end(),
                       [limit = most * water->settings().rest_density](double density) { return density > limit; });
}

/// True where the water is on a grid whose steps the case has shortened already: what is left then is due to the cells.
bool has_short_steps_on_grid(const sim::Model& model) {
    constexpr double shortened = 0.7;
    const auto* const grid = std::get_if<coupling::GridFluidSettings>(&model.fluid);
    return grid != nullptr && grid->courant < shortened * coupling::GridFluidSettings{}.courant;
}

std::string shorter_water_step(const Refused& refused) {
    const double courant = sim::courant(refused.model);
    if (refused.model.time.is_automatic() && has_short_steps_on_grid(refused.model)) {
        return fmt::format("{}, as shorter steps did not",
                           assignment_below("fluid.spacing", 0.5 * sim::fluid_spacing(refused.model)));
    }
    return !refused.model.time.is_automatic() ? automatic_step(refused.model)
           : courant > 0                      ? assignment_below("fluid.courant", 0.5 * courant)
                                              : shorter_step(refused);
}

/// Largest strain of a block, in the step before this one and in it [-].
double largest_strain(const Refused& refused) {
    double largest = 0;
    for (const body::BodyState* const bodies : {&refused.before.bodies, &refused.after.bodies}) {
        for (const Sym3& u : bodies->stretch) {
            for (const double part : {u.xx - 1, u.yy - 1, u.zz - 1, u.xy, u.xz, u.yz}) {
                largest = std::isfinite(part) ? std::max(largest, std::abs(part)) : largest;
            }
        }
    }
    return largest;
}

/// Energy goes with the square of the strain: the modulus with which blocks that are strained too far for the linear
/// elasticity of the method take up the same energy; empty where they are not.
std::string stiffer_blocks(const Refused& refused) {
    constexpr double far = 0.05, near = 0.02;
    const double strain = largest_strain(refused);
    const auto* const elasticity = sim::elasticity_of(refused.model.solid);
    if (elasticity == nullptr || !(strain > far)) {
        return "";
    }
    return fmt::format("{}: a block is strained by {:.2g}, where the method takes small strains",
                       assignment("solid.youngs_modulus", std::pow(strain / near, 2) * elasticity->youngs_modulus),
                       strain);
}

}  // namespace

double fastest_fluid(const Refused& refused) {
    double fastest = 0;
    for (const Vec3& v : refused.before.fluid.velocity) {
        fastest = std::max(fastest, norm(v));
    }
    return std::isfinite(refused.report.max_fluid_speed) ? std::max(fastest, refused.report.max_fluid_speed) : fastest;
}

std::string faster_sound(const Refused& refused) {
    const fluid::ParticleSettings& settings = refused.model.particles()->settings();
    const Vec3 gravity = refused.model.gravity.at(refused.before.time);
    Vec3 low = settings.domain.high, high = settings.domain.low;
    for (const Vec3& x : refused.before.fluid.position) {
        low = min(low, x);
        high = max(high, x);
    }
    const double square = std::pow(fastest_fluid(refused), 2) + 2 * std::abs(dot(gravity, high - low));
    const double speed = std::max(10 * std::sqrt(square), 2 * settings.sound_speed);
    return assignment("fluid.sound_speed", speed) + ", ten times the speed that the water may come to";
}

std::string shorter_step(const Refused& refused) {
    const sim::Model& model = refused.model;
    if (!model.time.is_automatic()) {
        return is_above_bound(refused) ? automatic_step(model)
                                       : assignment_below("time_step", shorter * model.time.time_step);
    }
    const double* const step = sim::step_of(model.solid);
    return step != nullptr ? assignment_below("solid.step", shorter * *step)
                           : assignment_below("time_step_factor", shorter * model.time.factor);
}

namespace {

/// Returns the spacing with which two rows of particles fit into the narrowest gap between bodies; empty where there is
/// no gap of half a spacing to two, in which single particles are caught and thrown about whatever the step.
std::string two_rows_in_gaps(const Refused& refused) {
    constexpr double least = 0.5;  // spacings: a narrower gap would take more than 16 times the particles
    if (refused.model.particles() == nullptr) {
        return "";
    }
    const scene::NarrowGaps gaps = scene::find_narrow_gaps(refused.model, refused.before);
    if (gaps.pairs == 0 || gaps.narrowest < least) {
        return "";
    }
    const body::BodySet& bodies = refused.model.bodies;
    return fmt::format("{} fits two rows of particles into the gap between '{}' and '{}'",
                       assignment_below("fluid.spacing", 0.5 * gaps.narrowest * sim::fluid_spacing(refused.model)),
                       bodies.name(gaps.a), bodies.name(gaps.b));
}

}  // namespace

std::string made_advice(const Refused& refused) {
    if (is_compressed(refused)) {
        return faster_sound(refused);
    }
    const std::string finer = two_rows_in_gaps(refused);
    return finer.empty() ? shorter_water_step(refused) : finer;
}

std::string ledger_advice(const Refused& refused) {
    const sim::Ledger& ledger = refused.report.ledger;
    if (!refused.model.time.is_automatic() && is_above_bound(refused)) {
        return automatic_step(refused.model);
    }
    if (refused.report.max_potential > deep) {
        if (std::string advice = stiffness_advice(refused, shallow); !advice.empty()) {
            return advice;
        }
    }
    if (std::string advice = stiffer_blocks(refused); !advice.empty()) {
        return advice;
    }
    const double share = std::abs(ledger.residual) / std::max(ledger.turnover, ledger.kinetic + ledger.fluid.kinetic);
    if (const double usual = sim::OutputSettings{}.ledger_tolerance; share < usual && share > 0) {
        return fmt::format("{}, which the methods keep by default, or a shorter step",
                           assignment("output.ledger_tolerance", usual));
    }
    const double of_fluid = std::max(std::abs(ledger.fluid.residual), std::abs(ledger.fluid.coupling_gap));
    if (refused.model.has_fluid() &&
        of_fluid > std::abs(ledger.residual - ledger.fluid.residual - ledger.fluid.coupling_gap)) {
        return is_compressed(refused) ? faster_sound(refused) : shorter_water_step(refused);
    }
    return shorter_step(refused);
}

}  // namespace riprap::run
