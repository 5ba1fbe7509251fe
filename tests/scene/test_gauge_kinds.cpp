// SPDX-License-Identifier: Apache-2.0
// A gauge that means nothing in the fluid of the case is refused at its word; the fluid says which those are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "riprap/fluid/gauge/gauge_kinds.hpp"
#include "scene/case_fixture.hpp"

namespace riprap::scene {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::string domain = "domain = { low = [0.0, 0.0], high = [1.0, 1.0] }\n";

/// A basin in the plane with a gauge; most problems of the case are of no interest here.
std::string basin(const std::string& method, const std::string& kind, const std::string& more = "") {
    return "gravity = [0.0, -9.81]\nend = 0.1\ndimension = 2\n[material.rock]\ndensity = 2500.0\n"
           "normal_stiffness = 1e7\n[[body]]\nname = \"floor\"\nmaterial = \"rock\"\nfixed = true\n"
           "shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }\n"
           "[fluid]\nmethod = \"" +
           method + "\"\nspacing = 0.05\n" + more +
           "[[fluid.region]]\nlevel = 0.5\n"
           "[[output.gauge]]\nname = \"g\"\npoint = [0.5, 0.25]\nkind = \"" +
           kind + "\"\n";
}

TEST(GaugeKinds, still_water_has_no_flow_to_read_and_the_fluids_that_have_are_named) {
    EXPECT_THAT(
        test::problems_of(basin("hydrostatic", "flow", domain)),
        Contains(testing::AllOf(HasSubstr("case.toml:21:8: the fluid 'hydrostatic' has no 'flow' to read at the "
                                          "gauge 'g'"),
                                HasSubstr("pressure, velocity, level, or fluid.method = sph, wcmps, mps, "
                                          "grid"))));
}

TEST(GaugeKinds, of_every_fluid_are_refused_exactly_where_it_does_not_read_them) {
    for (const fluid::GaugeKind* of : fluid::gauge_kinds()) {
        const std::string kind(of->word);
        const auto refusal = Contains(HasSubstr("' to read at the gauge 'g'"));
        const bool is_still = kind == "pressure" || kind == "velocity" || kind == "level";
        if (is_still) {
            EXPECT_THAT(test::problems_of(basin("hydrostatic", kind, domain)), Not(refusal)) << kind;
        } else {
            EXPECT_THAT(test::problems_of(basin("hydrostatic", kind, domain)), refusal) << kind;
        }
        for (const std::string method : {"sph", "wcmps", "mps", "grid"}) {
            const bool is_of_cells = kind == "turbulent_energy" || kind == "flow_error" || kind == "changed";
            const bool is_read = !is_of_cells || method == "grid";
            if (is_read) {
                EXPECT_THAT(test::problems_of(basin(method, kind, domain)), Not(refusal)) << method << " " << kind;
            } else {
                EXPECT_THAT(test::problems_of(basin(method, kind, domain)), refusal) << method << " " << kind;
            }
        }
    }
}

}  // namespace
}  // namespace riprap::scene
