// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "riprap/core/parallel.hpp"
#include "riprap/run/drive/run_case.hpp"

namespace riprap::run {
namespace {

// A job of two cores on a node of a cluster took all of the node, whatever OMP_NUM_THREADS said.
TEST(UseThreads, follows_the_environment_where_no_number_is_given) {
    const int before = parallel::thread_count();
    const char* given = std::getenv("OMP_NUM_THREADS");
    const std::string kept = given != nullptr ? given : "";
    unsetenv("OMP_NUM_THREADS");
    use_threads(0);
    const int all = parallel::thread_count();
    for (const auto& [text, count] :
         {std::pair{"3", 3}, {"5,2", 5}, {"0", all}, {"-4", all}, {"many", all}, {"", all}}) {
        setenv("OMP_NUM_THREADS", text, 1);
        use_threads(0);
        EXPECT_EQ(parallel::thread_count(), count) << text;
    }
    use_threads(7);
    EXPECT_EQ(parallel::thread_count(), 7);
    if (given != nullptr) {
        setenv("OMP_NUM_THREADS", kept.c_str(), 1);
    } else {
        unsetenv("OMP_NUM_THREADS");
    }
    parallel::set_thread_count(before);
}

}  // namespace
}  // namespace riprap::run
