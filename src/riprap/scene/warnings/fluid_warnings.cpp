// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/warnings/fluid_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/body/may_move.hpp"
#include "riprap/fluid/sph/courant_bound.hpp"
#include "riprap/fluid/sph/device/device_sph.hpp"
#include "riprap/scene/case/placed_part.hpp"

namespace riprap::scene {

namespace {

/// Tells whether water touches two opposite faces that are less than `thickness` apart.
bool is_between_water(const PlacedPart& part, const std::vector<Vec3>& water, double spacing, double thickness) {
    const std::int32_t count = part.shape.face_count;
    std::vector<std::uint8_t> is_wet(static_cast<std::size_t>(count), 0);
    for (const Vec3& x : water) {
        if (const std::int32_t face = face_before(part, x, touching * spacing); face >= 0) {
            is_wet[static_cast<std::size_t>(face)] = 1;
        }
    }
    for (std::int32_t i = 0; i < count; ++i) {
        for (std::int32_t j = 0; j < i; ++j) {
            if (is_wet[static_cast<std::size_t>(i)] != 0 && is_wet[static_cast<std::size_t>(j)] != 0 &&
                dot(part.shape.normal(i), part.shape.normal(j)) < -0.9 &&
                part.shape.offset[i] + part.shape.offset[j] < thickness) {
                return true;
            }
        }
    }
    return false;
}

/// All bodies of one entry of the case: their thinnest part.
struct ThinEntry {
    std::int32_t name;
    const body::Part* part;
    double thickness;  ///< [m]
    bool is_free;
};

std::vector<ThinEntry> thin_entries(const CaseBuild& build, const coupling::ParticleFluid& fluid, double least) {
    const body::BodySet& bodies = build.model.bodies;
    std::vector<ThinEntry> entries;
    std::vector<std::int32_t> of_name(bodies.names.size(), -1);
    for (const body::Part& part : bodies.parts) {
        const auto b = static_cast<std::size_t>(part.body.value);
        const double thickness = 2 * build.model.shapes.view(part.shape).inscribed_radius;
        if (fluid.is_dry[b] != 0 || thickness >= least) {
            continue;
        }
        std::int32_t& entry = of_name[static_cast<std::size_t>(bodies.name_id[b])];
        if (entry < 0) {
            entry = static_cast<std::int32_t>(entries.size());
            entries.push_back({bodies.name_id[b], &part, thickness, bodies.drive[b] == body::Drive::free});
        } else if (ThinEntry& known = entries[static_cast<std::size_t>(entry)]; thickness < known.thickness) {
            known.part = &part;
            known.thickness = thickness;
        }
    }
    return entries;
}

/// "'gate', 'A1', 'A2' and 2 more"
std::string names_of(const CaseBuild& build, const std::vector<ThinEntry>& entries) {
    constexpr std::size_t most = 4;
    const std::size_t shown = entries.size() > most ? most - 1 : entries.size();
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        text += i == 0 ? "" : i + 1 == entries.size() ? " and " : ", ";
        text += fmt::format("'{}'", build.model.bodies.names[static_cast<std::size_t>(entries[i].name)]);
    }
    return shown < entries.size() ? text + fmt::format(" and {} more", entries.size() - shown) : text;
}

/// The largest number of three digits that is no larger.
double floor_of(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return std::floor(value / unit * (1 + 1e-12)) * unit;
}

/// @param text  what follows from it, with a place for "it" or "them"
void warn_of(CaseBuild& build, const std::vector<ThinEntry>& entries, double spacing, double layers,
             std::string_view text) {
    if (entries.empty()) {
        return;
    }
    const auto is_thinner = [](const ThinEntry& a, const ThinEntry& b) { return a.thickness < b.thickness; };
    const auto [low, high] = std::minmax_element(entries.begin(), entries.end(), is_thinner);
    const std::string thinnest = fmt::format("{:.3g}", low->thickness / spacing);
    const std::string thickest = fmt::format("{:.3g}", high->thickness / spacing);
    const bool is_one = entries.size() == 1;
    warn_at(build, entries.front().name,
            fmt::format(
                "{} {} {} spacings thick: {}; fluid.spacing = {:.3g} or less would do", names_of(build, entries),
                is_one ? "is" : "are", thinnest == thickest ? thinnest : thinnest + " to " + thickest,
                fmt::format(fmt::runtime(text), is_one ? "it" : "them", layers), floor_of(low->thickness / layers)));
}

/// Steps at which sound grows on a lattice (docs/theory/sph.md, 8).
void warn_of_courant(CaseBuild& build, const fluid::SphSettings& sph) {
    if (sph.scheme != fluid::SphScheme::delta_sph) {
        return;
    }
    const double bound = courant_bound(sph);
    if (sph.courant > bound) {
        build.warnings.push_back(
            fmt::format("courant = {:.3g}: with density_diffusion = {:.3g} and {} short waves of sound grow on a "
                        "lattice from {:.2f} on; a smaller courant, or less of either, is stable",
                        sph.courant, sph.density_diffusion,
                        sph.gradient_correction ? fmt::format("acoustic_damping = {:.3g}", sph.acoustic_damping)
                                                : "no acoustic_damping, as gradient_correction is off,",
                        bound));
    }
}

/// Warns of the limits of Müller's scheme (docs/theory/sph.md, 9).
void warn_of_muller(CaseBuild& build, const fluid::SphSettings& sph) {
    if (sph.scheme != fluid::SphScheme::muller) {
        return;
    }
    build.warnings.emplace_back(
        "scheme = \"muller\" has a state equation of its own and neither diffusion of density, corrected gradients, "
        "damping of sound nor shifting; its energies do not add up, and the ledger ends the run unless "
        "output.ledger_tolerance is 1");
    constexpr double least_alpha = 0.1, known_ratio = 1.2;
    const double alpha = sph.viscosity.get<fluid::ArtificialViscosity>().alpha;
    if (alpha < least_alpha || std::abs(sph.smoothing_ratio - known_ratio) > 1e-9) {
        build.warnings.push_back(fmt::format(
            "scheme = \"muller\" with artificial_alpha = {:.3g} and smoothing_ratio = {:.3g}: short waves grow; "
            "still water is known to hold with artificial_alpha of at least {} at smoothing_ratio = {}",
            alpha, sph.smoothing_ratio, least_alpha, known_ratio));
    }
}

/// What keeps water from two clocks (docs/theory/sph.md, 12); empty: nothing.
std::string reason_for_one_clock(const CaseBuild& build, const coupling::ParticleFluid& fluid) {
    if (fluid.wall == coupling::WallTreatment::penalty) {
        return "walls are those of wall = \"penalty\"";
    }
    if (!fluid.open.empty()) {
        return "water enters or leaves";
    }
    const body::BodySet& bodies = build.model.bodies;
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        const auto index = static_cast<std::size_t>(b);
        if (bodies.drive[index] != body::Drive::fixed || body::may_move(bodies, index)) {
            return fmt::format("'{}' may move", bodies.name(BodyId{b}));
        }
    }
    return {};
}

void warn_of_one_clock(CaseBuild& build, const fluid::SphSettings& sph, const coupling::ParticleFluid& fluid) {
    if (sph.sound_steps == 1) {
        return;
    }
    if (const std::string reason = reason_for_one_clock(build, fluid); !reason.empty()) {
        build.warnings.push_back(
            fmt::format("fluid.sound_steps = {} has no effect, as {}: each step has a geometry "
                        "of its own",
                        sph.sound_steps, reason));
    }
}

}  // namespace

void warn_at(CaseBuild& build, std::int32_t name, std::string text) {
    const SourcePlace& place = build.names[build.model.bodies.names[static_cast<std::size_t>(name)]];
    build.warnings.push_back(to_string(Diagnostic{place, std::move(text), ""}));
}

void warn_of_thin_bodies(CaseBuild& build, const coupling::ParticleFluid& fluid, const fluid::ParticleState& water) {
    constexpr double layers = 4;  // spacings: two layers under each of two opposite faces
    const double spacing = fluid.settings().spacing, least = (layers - 1e-6) * spacing;
    std::vector<ThinEntry> between, beside;
    for (const ThinEntry& entry : thin_entries(build, fluid, least)) {
        const bool is_between =
            entry.is_free || is_between_water(placed(build, *entry.part), water.position, spacing, least);
        (is_between ? between : beside).push_back(entry);
    }
    warn_of(build, between, spacing, layers,
            "below {1} water on opposite sides feels each other through {0}, and its forces on {0} are rough");
    warn_of(build, beside, spacing, layers,
            "that is no harm while water stays on one side, but should it come to the other side as well, each would "
            "feel the other through {0} (below {1})");
}

void warn_of_scheme(CaseBuild& build, const fluid::SphSettings& sph, const coupling::ParticleFluid& fluid) {
    warn_of_muller(build, sph);
    warn_of_one_clock(build, sph, fluid);
    warn_of_courant(build, sph);
    if (sph.is_on_device() && !fluid::has_device()) {
        build.warnings.push_back(
            fmt::format("fluid.runs_on = \"device\", but this program finds {} (docs/howto/device.md): the host "
                        "computes the bits of "
                        "one, several times as slowly as with runs_on = \"host\"",
                        fluid::device_name()));
    }
}

}  // namespace riprap::scene
