// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/figures/spreads.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "riprap/scene/assemble/random_stream.hpp"

namespace riprap::run {

std::vector<Spread> spreads_of(const scene::LoadedCase& loaded) {
    std::vector<Spread> spreads;
    for (const nlohmann::json& row :
         nlohmann::json::parse(loaded.resolved_json).value("spread", nlohmann::json::array())) {
        Spread spread{row.at("key").get<std::string>()};
        if (row.contains("mean")) {
            spread.is_normal = true;
            spread.mean = row.at("mean").get<double>();
            spread.deviation = row.at("deviation").get<double>();
        } else {
            spread.low = row.at("low").get<double>();
            spread.high = row.at("high").get<double>();
        }
        spreads.push_back(std::move(spread));
    }
    return spreads;
}

std::string text_of(const Spread& spread) {
    return spread.is_normal
               ? fmt::format("{} {:.6g} with a deviation of {:.6g}", spread.key, spread.mean, spread.deviation)
               : fmt::format("{} from {:.6g} to {:.6g}", spread.key, spread.low, spread.high);
}

double draw(const Spread& spread, std::uint64_t seed, std::int64_t member) {
    scene::RandomStream stream(seed, spread.key, static_cast<std::uint64_t>(member));
    if (!spread.is_normal) {
        return stream.uniform(spread.low, spread.high);
    }
    const double radius = std::sqrt(-2 * std::log(1 - stream.uniform()));  // Box and Muller
    return spread.mean + spread.deviation * radius * std::cos(2 * std::numbers::pi * stream.uniform());
}

}  // namespace riprap::run
