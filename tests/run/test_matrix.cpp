// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/matrix.hpp"

namespace riprap::run {
namespace {

// An answer that is due after the end left nothing to compare.
TEST(Matrix, compares_the_quantity_at_the_end_where_its_answer_is_not_due_yet) {
    const MatrixResult result =
        run_matrix({"cases/hello_block/case.toml", {"end=0.1", "expect.0.reduce=\"at\"", "expect.0.at=0.5"}, ""});
    EXPECT_EQ(result.quantity, "block.displacement.x");
    const double way = 0.5 * (4.905 - 8.496 * std::tan(20 * M_PI / 180)) * 0.1 * 0.1;  // [m]
    EXPECT_EQ(result.entries.front().status, "ran");
    EXPECT_NEAR(result.entries.front().value, way, 0.05 * way);
}

}  // namespace
}  // namespace riprap::run
