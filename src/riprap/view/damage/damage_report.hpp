// SPDX-License-Identifier: Apache-2.0
#pragma once

// Damage of an armour layer: units that moved, and what is eroded, by zones.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "riprap/view/recorded_run.hpp"

namespace riprap::view {

struct DamageRequest {
    std::string units{};  ///< beginning of the names of the armour units; empty: all bodies that are free at the start
    std::vector<std::pair<double, double>> zones{};  ///< levels [m]; empty: one of all
    std::optional<double> from{}, to{};              ///< times [s]; default: first and last frame
    Vec3 along{1, 0, 0};                             ///< horizontal, up the slope
    std::optional<double> width{};                   ///< of the strip across [m]; default: that of the units
};

struct UnitDamage {
    std::string name;
    double diameter;       ///< D_n, cube root of the volume; in the plane root of the area [m]
    double level;          ///< of the centre before [m]
    double displacement;   ///< between both times [m]
    double turned;         ///< between both times [rad]
    double largest_speed;  ///< in any frame between [m/s]
};

/// Damage of one range of levels.
struct ZoneDamage {
    double low, high;  ///< [m]
    std::size_t units;
    std::size_t moved_half, moved, moved_twice;  ///< by more than 0.5, 1 and 2 D_n
    double number;                               ///< N_od = moved / (width / D_n50) [-]
    double eroded, deposited;                    ///< A_e, and what came on top [m^2]
    double damage;                               ///< S_d = A_e / D_n50^2 [-]
};

struct DamageReport {
    double from, to;         ///< times of the frames [s]
    double diameter, width;  ///< D_n50 and width of the strip [m]; in the plane the width is one D_n50
    bool is_planar;
    std::vector<UnitDamage> units;
    std::vector<ZoneDamage> zones;
    std::vector<double> place, before, after;  ///< profiles; not a number where there is no body [m]
    std::vector<std::string> notices;
};

/// Compares two frames of a run. A unit is displaced where it moved by more than its D_n. The profiles are those of a
/// round foot of half D_n50 on all bodies, at stations D_n50/20 apart, averaged over the width. A station counts for
/// the zone that its level before lies in. @throws BadRequest, FileError
DamageReport damage_report(const RecordedRun& run, const DamageRequest& request);

/// For people, as one JSON object, and as files in a folder: damage.csv, damage_units.csv, damage_profile.csv,
/// damage.svg.
std::string damage_text(const DamageReport& report);
std::string damage_json(const DamageReport& report);
std::vector<std::filesystem::path> write_damage(const std::filesystem::path& folder, const DamageReport& report);

}  // namespace riprap::view
