// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <system_error>

#include "riprap/core/error.hpp"
#include "riprap/view/serve.hpp"

namespace riprap::view {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string page() { return "<html>a run</html>"; }

std::string get(const std::string& path, const std::string& host) {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\nAccept: */*\r\n\r\n";
}

TEST(Serve, GivesThePageToVisitorsOfThisMachine) {
    for (const char* host : {"127.0.0.1:8123", "localhost:8123", "localhost"}) {
        const std::string answer = answer_to(get("/", host), page);
        EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 OK\r\n"));
        EXPECT_THAT(answer, HasSubstr("Content-Length: 18\r\n"));
        EXPECT_THAT(answer, HasSubstr("\r\n\r\n<html>a run</html>"));
    }
}

TEST(Serve, RefusesAPageElsewhereThatGivesItselfThisAddress) {
    EXPECT_THAT(answer_to(get("/", "evil.example"), page), StartsWith("HTTP/1.1 403"));
    EXPECT_THAT(answer_to("GET / HTTP/1.1\r\n\r\n", page), StartsWith("HTTP/1.1 403"));
}

TEST(Serve, HasOnePageAndTakesNothing) {
    EXPECT_THAT(answer_to(get("/../etc/passwd", "localhost"), page), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(answer_to("POST / HTTP/1.1\r\nHost: localhost\r\n\r\n", page), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(answer_to("", page), StartsWith("HTTP/1.1 403"));
}

TEST(Serve, TellsTheVisitorWhyARunCannotBeShown) {
    const auto broken = []() -> std::string { throw FileError("'x' holds no run"); };
    EXPECT_THAT(answer_to(get("/", "localhost"), broken), HasSubstr("'x' holds no run"));
}

TEST(Serve, SurvivesWhateverGoesWrongWithThePage) {
    const auto without_memory = []() -> std::string { throw std::bad_alloc(); };
    EXPECT_THAT(answer_to(get("/", "localhost"), without_memory), StartsWith("HTTP/1.1 500"));
    const auto forbidden = []() -> std::string {
        throw std::filesystem::filesystem_error("frames", std::make_error_code(std::errc::permission_denied));
    };
    EXPECT_THAT(answer_to(get("/", "localhost"), forbidden), HasSubstr("frames"));
}

}  // namespace
}  // namespace riprap::view
