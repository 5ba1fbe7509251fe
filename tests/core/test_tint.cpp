// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "riprap/core/tint.hpp"

namespace riprap {
namespace {

/// The far end of a pseudo-terminal: what a program that runs in a window writes to.
class Terminal {
 public:
    Terminal() : near_(posix_openpt(O_RDWR | O_NOCTTY)) {
        if (near_ >= 0 && grantpt(near_) == 0 && unlockpt(near_) == 0) {
            far_ = std::fopen(ptsname(near_), "w");
        }
    }
    ~Terminal() {
        if (far_ != nullptr) {
            std::fclose(far_);
        }
        close(near_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    std::FILE* file() const { return far_; }

 private:
    int near_;
    std::FILE* far_{nullptr};
};

TEST(Tint, ColoursWordsOnlyWhereItIsAskedFor) {
    EXPECT_EQ(tinted("passed", Tint::good, true), "\033[32mpassed\033[0m");
    EXPECT_EQ(tinted("failed", Tint::bad, true), "\033[31mfailed\033[0m");
    EXPECT_EQ(tinted("warning:", Tint::caution, true), "\033[33mwarning:\033[0m");
    EXPECT_EQ(tinted("passed", Tint::good, false), "passed");
}

TEST(Tint, IsForTerminalsThatShowColoursAndReadersWhoDoNotRefuseThem) {
    const Terminal terminal;
    if (terminal.file() == nullptr) {
        GTEST_SKIP() << "no pseudo-terminals here";
    }
    unsetenv("NO_COLOR");
    setenv("TERM", "xterm", 1);
    EXPECT_TRUE(shows_colours(terminal.file()));
    setenv("TERM", "dumb", 1);
    EXPECT_FALSE(shows_colours(terminal.file()));
    setenv("TERM", "xterm", 1);
    setenv("NO_COLOR", "1", 1);
    EXPECT_FALSE(shows_colours(terminal.file()));
    setenv("NO_COLOR", "", 1);
    EXPECT_TRUE(shows_colours(terminal.file()));
    std::FILE* const file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    EXPECT_FALSE(shows_colours(file));
    std::fclose(file);
    unsetenv("NO_COLOR");
}

}  // namespace
}  // namespace riprap
