// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/page_template.hpp"
#include "riprap/view/read_run.hpp"
#include "view/stirred_run.hpp"

namespace riprap::view {
namespace {

// The budget that the manual states, whole where the tests are long and one part in 125 of it where they are short:
// fewer frames and particles that guess each other as well.
TEST(PageSize, A100000ParticlesInMotionOver200FramesTakeLessThan60MB) {
    if (page_template().empty()) {
        GTEST_SKIP() << "this build carries no page";
    }
    const bool is_full = std::getenv("RIPRAP_FULL") != nullptr;
    const int per_side = is_full ? 47 : 16, frame_count = is_full ? 200 : 40;
    const TemporaryFolder folder;
    write_stirred_run(folder / "run", per_side, frame_count);

    const PageContent content = pack_run(read_run(folder / "run"), default_budget);
    const std::string page = page_of(content);

    const double particle_frames = static_cast<double>(per_side) * per_side * per_side * frame_count;
    const double share = particle_frames / (100'000.0 * 200.0);
    const double run_bytes = static_cast<double>(page.size() - page_template().size());
    std::printf("%.2f MB of page, %.3f bytes for a particle and frame\n", 1e-6 * static_cast<double>(page.size()),
                run_bytes / particle_frames);
    EXPECT_LE(run_bytes, share * static_cast<double>(default_budget));
    EXPECT_LE(page.size(), default_budget);
    const auto water = nlohmann::json::parse(content.contents_json)["water"];
    EXPECT_EQ(water["stride"], 1);
    EXPECT_LE(water["step"].get<double>(), StirredWater::spacing / (is_full ? 16 : 32));
    EXPECT_EQ(nlohmann::json::parse(content.contents_json)["times"].size(), static_cast<std::size_t>(frame_count));
}

// The budget is of the file, not of what is packed into it.
TEST(PageSize, ASmallBudgetHoldsForTheWholePage) {
    if (page_template().empty()) {
        GTEST_SKIP() << "this build carries no page";
    }
    const TemporaryFolder folder;
    write_stirred_run(folder / "run", 12, 30);
    for (const std::size_t room : {200'000U, 60'000U}) {
        const std::size_t budget = page_template().size() + room;
        EXPECT_LE(page_of(pack_run(read_run(folder / "run"), budget)).size(), budget);
    }
}

// Every page begins with the code that shows a run.
TEST(PageSize, ThePageWithoutARunTakesLessThanAMegabyte) { EXPECT_LT(page_template().size(), 1'000'000U); }

}  // namespace
}  // namespace riprap::view
