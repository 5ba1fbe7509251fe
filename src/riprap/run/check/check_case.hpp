// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/run/remedy/predicted_contact.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/scene/warnings/narrow_gaps.hpp"

namespace riprap::run {

/// Extent of the run of a case, found out without running it: the case is read and checked whole, and one step is
/// tried on a copy of its State.
struct CaseCheck {
    std::string title;
    std::int64_t bodies{0}, free_bodies{0}, parts{0}, shapes{0};
    bool is_planar{false};
    double mass{0};             ///< of free bodies [kg]
    std::int64_t particles{0};  ///< of water
    std::int64_t samples{0};    ///< of boundary particles
    double water_mass{0};       ///< [kg]; in a planar scene per metre of width
    double filled_volume{0};    ///< that the particles stand for [m^3]; in a planar scene [m^2]
    double trimmed_volume{0};   ///< of the room in regions, outside of solids, that holds no water; in the same unit
    double narrow_volume{0};    ///< part of trimmed_volume that is too narrow for particles
    double sound_speed{0};      ///< of water [m/s]
    std::string sound_speed_reason;
    struct FaceGauge {
        std::string gauge, body;
        Vec3 normal;  ///< of the face, out of the body, at the start [-]
    };
    scene::NarrowGaps gaps;                 ///< that particles do not fit into well
    std::array<std::string, 2> beside_gap;  ///< bodies at the first of them
    std::vector<FaceGauge> face_gauges;     ///< what each wall_pressure found
    std::vector<scene::PaddleWave> waves;   ///< that paddles are to make
    std::vector<std::string> sides;         ///< of the domain that absorb waves, and which
    std::vector<std::string> spreads;       ///< numbers that differ between the members of an ensemble
    struct EarlyTipping {
        std::string body;
        std::int64_t above;     ///< bodies that stand on it
        double rigid, elastic;  ///< slopes at which a rigid body and one with the stiffness of the case tip [deg]
        double stiffness;       ///< normal_stiffness with which the two agree to 0.1 degrees [Pa]
        std::vector<std::string_view> others;  ///< solid methods whose bodies tip about their edges
        double lean;                           ///< largest of gravity off the normal of its foot during the run [deg]
    };
    std::optional<EarlyTipping> tipping;  ///< of the body that tips earliest by the elasticity of its foot
    struct Overlap {
        std::string body, other;
        PredictedOverlap found;
    };
    std::optional<Overlap> overlap;  ///< the largest that the stiffness allows
    struct Impact {
        std::string body, other;
        ImpactStep found;
    };
    std::optional<Impact> impact;  ///< that the step of an implicit method damps most
    double time_step{0};           ///< [s]
    double time_step_limit{0};     ///< [s]
    std::string limited_by;
    double end{0};  ///< [s]
    std::int64_t steps{0};
    std::int64_t substeps{1};     ///< of the bodies within the first step of the water
    double substep{0};            ///< that those are of, or less [s]
    std::string substeps_reason;  ///< what they follow from
    std::int64_t frames{0};
    bool is_tried{true};       ///< the first step was computed; else what is at time 0 is not known
    std::int64_t contacts{0};  ///< at time 0
    double max_overlap{0};     ///< at time 0 [m]
    double max_potential{0};   ///< at time 0, of the inscribed radius [-]
    std::size_t memory_bytes{0};
    std::size_t output_bytes{0};     ///< predicted for all frames and tables
    std::string refusal;             ///< what the tried step was refused for; empty = accepted
    std::vector<std::string> notes;  ///< what was read from other programs' files
    std::vector<std::string> warnings;

    /// Tells whether steps can be counted, and are not more than any machine takes.
    bool has_countable_steps() const;
    /// Steps, as a number that need not be countable.
    double estimated_steps() const;
};

/// Bodies above which `check` computes no step of a method that solves equations for all of them: that takes minutes
/// and gigabytes.
inline constexpr std::int64_t most_solved_by_check = 10'000;

/// Angle by which a body tips early above which `check` warns [deg], where gravity comes to lean by more than a share
/// of the angle at which it tips [-]: upright blocks that nothing tips are no reason for a warning.
inline constexpr double early_tipping = 0.25, leans = 0.5;
/// Share of the speed of an impact that comes back below which `check` warns [-].
inline constexpr double least_back = 0.95;

/// @throws CaseError with every problem of the case
CaseCheck check_case(const scene::LoadedCase& loaded);

/// For people, warnings in colour if asked, and as one JSON object.
std::string check_text(const CaseCheck& check, bool is_coloured = false);
std::string check_json(const CaseCheck& check);

/// Lines of `check`, which are warnings where they are of much.
std::string text_of(const CaseCheck::EarlyTipping& tipping);
std::string text_of(const CaseCheck::Overlap& overlap);
std::string text_of(const CaseCheck::Impact& impact);

/// "1.5 GB", "20 kB"
std::string size_text(double bytes);

}  // namespace riprap::run
