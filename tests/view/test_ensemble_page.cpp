// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/ensemble/ensemble.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/sweep_page.hpp"

namespace riprap::view {
namespace {

constexpr const char* flying = R"(
gravity = [0, 0, -10]
end = 0.02
seed = 7
[material.rock]
density = 2500.0
normal_stiffness = 1.0e5
[[body]]
name = "stone"
shape = { cube = 0.1 }
position = [0, 0, 1]
velocity = [1.0, 0, 0]
material = "rock"
[output]
probe_interval = 0.01
vtk = false
[[output.probe]]
body = "stone"
quantity = "position"
[[spread]]
key = "body.stone.velocity.0"
low = 1.0
high = 2.0
)";

/// Returns the data in the script element of a page.
nlohmann::json study_of(const std::filesystem::path& page) {
    const std::string text = io::read_file(page, std::size_t{16} << 20U), mark = R"(id="study">)";
    const std::size_t start = text.find(mark) + mark.size();
    return nlohmann::json::parse(text.substr(start, text.find("</script>", start) - start));
}

TEST(EnsemblePage, has_drawn_values_curves_and_the_band_from_least_to_largest_member) {
    const TemporaryFolder place;
    io::write_file(place.path() / "case.toml", flying);
    run::EnsembleOptions options;
    options.run.case_path = (place.path() / "case.toml").string();
    options.run.out = place.path() / "ensemble";
    options.run.threads = 1;
    options.run.silent = options.run.quiet = true;
    options.members = 3;
    if (!has_page()) {
        GTEST_SKIP() << "this build carries no page";
    }
    ASSERT_EQ(run::run_ensemble(options), 0);
    const nlohmann::json study = study_of(write_ensemble_page(options.run.out));
    ASSERT_EQ(study["runs"].size(), 3U);
    double least = 2, most = 1;
    for (const nlohmann::json& member : study["runs"]) {
        const double speed = std::stod(member["set"]["body.stone.velocity.0"].get<std::string>());
        EXPECT_NEAR(member["curves"]["stone.position.x"].back().get<double>(), 0.02 * speed, 1e-7);
        least = std::min(least, speed);
        most = std::max(most, speed);
    }
    EXPECT_NEAR(study["bands"]["stone.position.x.low"].back().get<double>(), 0.02 * least, 1e-7);
    EXPECT_NEAR(study["bands"]["stone.position.x.high"].back().get<double>(), 0.02 * most, 1e-7);
    EXPECT_LT(study["bands"]["stone.position.x.p10"].back(), study["bands"]["stone.position.x.p90"].back());
    EXPECT_EQ(study["units"]["body.stone.velocity.0"], "m/s");
    EXPECT_EQ(study["bands"]["time"].size(), study["bands"]["stone.position.x.mean"].size());
}

}  // namespace
}  // namespace riprap::view
