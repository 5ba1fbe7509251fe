// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "riprap/body/gravity.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/io/csv_reader.hpp"

namespace riprap::view {

/// The files of one moment; empty where there is none.
struct FrameFiles {
    double time{0};  ///< [s]
    std::filesystem::path bodies, water, contacts;
};

/// The place of a gauge: a point, or a line from `point` to `end`.
struct GaugePlace {
    std::string name, kind;
    Vec3 point;               ///< [m]
    std::optional<Vec3> end;  ///< [m]
};

/// Water that stands still, its level given.
struct StillWater {
    struct Basin {
        Vec3 low, high;               ///< corners of its box [m]
        std::optional<double> level;  ///< along "against gravity"; empty = its top [m]
    };
    struct LevelAt {
        double time, level;  ///< [s], [m]
    };
    std::vector<Basin> basins;
    std::vector<LevelAt> levels;  ///< of all basins, times ascending; empty = each keeps its own
};

/// Stones that water flows through, of a planar scene: corners in order [m].
struct PorousZone {
    std::vector<Vec3> corners;
    double porosity{0};  ///< [-]
};

/// A run folder without the content of its frames.
struct RecordedRun {
    std::filesystem::path root;
    std::string title;
    std::string source;  ///< publication that the case is taken from; empty where it names none
    std::string status;  ///< "finished", "interrupted", "failed", or "not finished"
    std::vector<FrameFiles> frames;
    io::CsvTable probes, ledger;
    std::vector<std::string> body_names;  ///< empty while the run goes on
    std::vector<double> body_mass;        ///< [kg]; as long as body_names
    std::vector<std::string> material_names;
    std::string case_text, resolved_text;
    std::string summary_json, ticket_json;  ///< as written; empty when missing or no JSON
    Vec3 gravity;                           ///< at full strength, before it turns [m/s^2]
    body::Gravity gravity_law;              ///< gravity over time
    std::vector<GaugePlace> gauges;         ///< fixed in space
    StillWater still_water;                 ///< no basin: there is none
    std::vector<std::string> dry_names;     ///< of bodies of the case that water does not see (wet = false)
    std::vector<PorousZone> porous;
    bool is_planar{false};
    std::vector<std::string> warnings;  ///< of the run itself, about its results
    std::vector<std::string> notices;   ///< what could not be read, for the user
};

}  // namespace riprap::view
