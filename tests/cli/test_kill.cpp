// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "cli/run_fixture.hpp"
#include "riprap/core/timer.hpp"

namespace riprap {
namespace {

class Kills : public RunFixture {};

/// SIGKILL at any moment - reading the case, making the folder, between the two renames of a checkpoint, in the middle
/// of a row - and the run, started again, ends as if nothing had happened. 20 kills; 200 with RIPRAP_FULL=1.
TEST_F(Kills, LoseNothing) {
    const int kills_wanted = std::getenv("RIPRAP_FULL") != nullptr ? 200 : 20;
    const Timer timer;
    const Whole whole = whole_run("2");
    const double whole_seconds = timer.seconds();

    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> moment(0, 0.8 * whole_seconds);
    int kills = 0, finished = 0;
    while (kills < kills_wanted || finished == 0) {
        const std::string threads = std::to_string(1 + random() % 3);
        const Program program(folder.path(),
                              {"run", case_file(), "--out", out("killed"), "--resume", "--threads", threads});
        if (kills < kills_wanted) {
            std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
            program.send(SIGKILL);
        }
        const Ending ending = program.wait();
        if (ending.code == -SIGKILL) {
            ++kills;
            continue;
        }
        ASSERT_EQ(ending.code, 0) << "after " << kills << " kills: " << ending.err;
        ++finished;
        ASSERT_NO_FATAL_FAILURE(expect_same(whole, "killed"));
        if (kills < kills_wanted) {
            std::filesystem::remove_all(out("killed"));
        }
    }
    RecordProperty("kills", kills);
    RecordProperty("runs_finished", finished);
}

}  // namespace
}  // namespace riprap
