// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "riprap/core/chosen_keys.hpp"
#include "riprap/core/key.hpp"
#include "riprap/fluid/particle/particle_keys.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

using namespace key;

namespace {

using S = SphSettings;

KeyList<S> scheme_keys() {
    return {
        choice(&S::scheme, "scheme", {{"delta_sph", SphScheme::delta_sph}, {"muller", SphScheme::muller}},
               "Form of SPH: with diffusion of density and shifting of particles; or that of Mueller et al. "
               "(2003), density by summation, for comparison: it needs an artificial_alpha of 0.1 or more."),
        choice(&S::runs_on, "runs_on", {{"host", RunsOn::host}, {"device", RunsOn::device}},
               "Where the water is computed. `device`: on a GPU, where the program was built with RIPRAP_CUDA and "
               "finds one; else the same numbers, to the bit, come from the host, several times as slowly.")
            .read_with("scheme", {"delta_sph"}),
        choice(&S::state_equation, "state_equation", {{"tait", StateEquation::tait}, {"linear", StateEquation::linear}},
               "Equation of state.")
            .read_with("scheme", {"delta_sph"}),
        number(&S::tait_exponent, "tait_exponent", dimension::plain, between(1, 10), "Exponent of the Tait equation.")
            .read_with("scheme", {"delta_sph"})
            .read_with("state_equation", {"tait"})};
}

KeyList<S> particle_order_keys() {
    return {number(&S::density_diffusion, "density_diffusion", dimension::plain, between(0, 1),
                   "Strength of the diffusion of density.")
                .read_with("scheme", {"delta_sph"}),
            number(&S::acoustic_damping, "acoustic_damping", dimension::plain, between(0, 1),
                   "Strength of the bulk viscosity that damps sound inside the water; 0 = off.")
                .read_with("scheme", {"delta_sph"})
                .read_with("gradient_correction", {"true"}),
            boolean(&S::gradient_correction, "gradient_correction",
                    "Inside the water density follows the divergence of velocity, not the arrangement of particles; "
                    "false for comparison. Laid out for smoothing_ratio = 1.5.")
                .read_with("scheme", {"delta_sph"}),
            number(&S::shifting, "shifting", dimension::plain, between(0, 100),
                   "Strength of the shifting of particles; 0 = off.")
                .read_with("scheme", {"delta_sph"}),
            integer(&S::sound_steps, "sound_steps", 1, 8,
                    "Most time steps, which are those of sound, on one geometry of neighbours, weights and slow "
                    "forces; 1 = each has its own. No more than bring the fastest water a quarter of a smoothing "
                    "length on; one while a wall or body may move, or water comes and goes.")
                .read_with("scheme", {"delta_sph"})
                .read_with("runs_on", {"host"}),
            number(&S::courant, "courant", dimension::plain, above(0, 1),
                   "Share of the time that sound needs through a smoothing length that a step may last; a warning "
                   "tells where a lattice would be unstable."),
            integer(&S::sort_interval, "sort_interval", 1, 1e6,
                    "Steps between sorts of the particles by place: part of the result, as sums follow the order.")};
}

/// The inside of the water, particles caught between walls and joints are told by sums of the kernel whose values hold
/// at h/dp = 1.5 (docs/theory/sph.md, 4; tearing.hpp).
std::vector<KeyProblem> problems_of(const S& settings) {
    constexpr double least = 1.4, most = 1.6;
    std::vector<KeyProblem> problems;
    if (settings.scheme == SphScheme::delta_sph &&
        (settings.smoothing_ratio < least || settings.smoothing_ratio > most)) {
        problems.push_back(
            {"smoothing_ratio",
             "smoothing_ratio is off 1.5, at which surfaces, joints and particles between walls are known",
             "1.4 to 1.6 with scheme = \"delta_sph\""});
    }
    const bool has_whole_powers =
        settings.state_equation != StateEquation::tait || settings.tait_exponent == std::floor(settings.tait_exponent);
    if (settings.is_on_device() && !has_whole_powers) {
        problems.push_back({"tait_exponent", "host and device round powers that are not whole in two ways",
                            "a whole tait_exponent with runs_on = \"device\""});
    }
    return problems;
}

}  // namespace

MethodKeys<SphSettings> SphSettings::keys() {
    return {.help = "smoothed particle hydrodynamics, weakly compressible",
            .keys = particle_keys<S>() + scheme_keys() + chosen(&S::viscosity, "viscosity", "Viscosity of the water") +
                    particle_order_keys(),
            .scene_keys = {"sound_speed", "expected_speed", "wall", "joint_pressure", "domain", "region", "flow",
                           "jitter", "sponge", "inflow", "outflow"},
            .check = problems_of};
}

}  // namespace riprap::fluid
