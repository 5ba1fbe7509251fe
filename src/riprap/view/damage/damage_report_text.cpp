// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv.hpp"
#include "riprap/view/damage/damage_report.hpp"
#include "riprap/view/plot_svg.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

std::string zone_name(const ZoneDamage& zone) {
    return std::isfinite(zone.low) ? fmt::format("{:.4g} to {:.4g} m", zone.low, zone.high) : "all levels";
}

Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) {
        list.push_back(json_of(value));
    }
    return list;
}

}  // namespace

std::string damage_text(const DamageReport& report) {
    std::string text =
        fmt::format("damage between {:.6g} and {:.6g} s: {} units, D_n50 = {:.4g} m, strip of {:.4g} m\n", report.from,
                    report.to, report.units.size(), report.diameter, report.width);
    text += fmt::format("{:<18} {:>6} {:>9} {:>7} {:>7} {:>8} {:>11} {:>13} {:>8}\n", "zone", "units", "> 0.5 D_n",
                        "> 1 D_n", "> 2 D_n", "N_od", "eroded [m^2]", "deposited", "S_d");
    for (const ZoneDamage& zone : report.zones) {
        text += fmt::format("{:<18} {:>6} {:>9} {:>7} {:>7} {:>8.3g} {:>11.4g} {:>13.4g} {:>8.3g}\n", zone_name(zone),
                            zone.units, zone.moved_half, zone.moved, zone.moved_twice, zone.number, zone.eroded,
                            zone.deposited, zone.damage);
    }
    for (const std::string& notice : report.notices) {
        text += notice + '\n';
    }
    return text;
}

std::string damage_json(const DamageReport& report) {
    Json json{{"from", report.from},
              {"to", report.to},
              {"diameter", report.diameter},
              {"width", report.width},
              {"is_planar", report.is_planar}};
    json["zones"] = Json::array();
    for (const ZoneDamage& zone : report.zones) {
        json["zones"].push_back({{"low", json_of(zone.low)},
                                 {"high", json_of(zone.high)},
                                 {"units", zone.units},
                                 {"moved_half", zone.moved_half},
                                 {"moved", zone.moved},
                                 {"moved_twice", zone.moved_twice},
                                 {"N_od", zone.number},
                                 {"eroded", zone.eroded},
                                 {"deposited", zone.deposited},
                                 {"S_d", zone.damage}});
    }
    json["units"] = Json::array();
    for (const UnitDamage& unit : report.units) {
        json["units"].push_back({{"name", unit.name},
                                 {"diameter", unit.diameter},
                                 {"level", unit.level},
                                 {"displacement", unit.displacement},
                                 {"turned", unit.turned},
                                 {"largest_speed", unit.largest_speed}});
    }
    json["profile"] = {{"place", report.place}, {"before", json_of(report.before)}, {"after", json_of(report.after)}};
    json["notices"] = report.notices;
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

namespace {

std::string zones_csv(const DamageReport& report) {
    std::string text =
        "low [m],high [m],units,moved_half,moved,moved_twice,N_od [-],eroded [m^2],deposited [m^2],S_d [-]\n";
    for (const ZoneDamage& zone : report.zones) {
        const double none = std::nan("");
        const std::vector<double> row{std::isfinite(zone.low) ? zone.low : none,
                                      std::isfinite(zone.high) ? zone.high : none,
                                      static_cast<double>(zone.units),
                                      static_cast<double>(zone.moved_half),
                                      static_cast<double>(zone.moved),
                                      static_cast<double>(zone.moved_twice),
                                      zone.number,
                                      zone.eroded,
                                      zone.deposited,
                                      zone.damage};
        text += io::csv_row(row) + '\n';
    }
    return text;
}

std::string units_csv(const DamageReport& report) {
    std::string text = "name,D_n [m],level [m],displacement [m],displacement [D_n],turned [deg],largest_speed [m/s]\n";
    for (const UnitDamage& unit : report.units) {
        const std::vector<double> row{unit.diameter,
                                      unit.level,
                                      unit.displacement,
                                      unit.displacement / unit.diameter,
                                      unit.turned * 180 / std::numbers::pi,
                                      unit.largest_speed};
        std::string name = "\"";
        for (const char c : unit.name) {
            name += c == '"' ? "\"\"" : std::string(1, c);
        }
        text += fmt::format("{}\",{}\n", name, io::csv_row(row));
    }
    return text;
}

std::string profile_csv(const DamageReport& report) {
    const std::vector<io::CsvColumn> columns{{"place", "m"}, {"before", "m"}, {"after", "m"}};
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t i = 0; i < report.place.size(); ++i) {
        const std::vector<double> row{report.place[i], report.before[i], report.after[i]};
        text += io::csv_row(row) + '\n';
    }
    return text;
}

}  // namespace

std::vector<std::filesystem::path> write_damage(const std::filesystem::path& folder, const DamageReport& report) {
    io::make_folder(folder);
    io::write_file(folder / "damage.csv", zones_csv(report));
    io::write_file(folder / "damage_units.csv", units_csv(report));
    io::write_file(folder / "damage_profile.csv", profile_csv(report));
    Plot plot;
    plot.title = "Profile before and after";
    plot.subtitle =
        fmt::format("S_d = {:.3g}, N_od = {:.3g}, D_n50 = {:.4g} m, {:.6g} to {:.6g} s", report.zones.front().damage,
                    report.zones.front().number, report.diameter, report.from, report.to);
    plot.x.label = "along the slope [m]";
    plot.y.label = "level [m]";
    plot.has_equal_scales = true;
    plot.curves.push_back({"before", report.place, report.before, CurveStyle::line, 0});
    plot.curves.push_back({"after", report.place, report.after, CurveStyle::dashed, 1});
    write_svg(folder / "damage.svg", plot);
    return {folder / "damage.csv", folder / "damage_units.csv", folder / "damage_profile.csv", folder / "damage.svg"};
}

}  // namespace riprap::view
