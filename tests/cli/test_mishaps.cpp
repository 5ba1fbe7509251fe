// SPDX-License-Identifier: Apache-2.0
// Inputs and surroundings that brought the program down, held it up or went unnoticed.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <cctype>

#include "cli/run_fixture.hpp"
#include "io/older_checkpoint.hpp"
#include "riprap/core/timer.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Mishaps : public RunFixture {
 protected:
    static std::string pool(const std::string& spacing, const std::string& more = {}) {
        return "dimension = 2\ngravity = [0, -9.81]\nend = 0.01\n"
               "[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1e7\n"
               "[fluid]\nspacing = " +
               spacing +
               "\ndomain = { low = [-0.5, -0.5], high = [2, 2] }\n"
               "[[fluid.region]]\nbox = { low = [0, 0], high = [1, 1] }\n"
               "[[body]]\nname = 'ground'\nmaterial = 'rock'\nfixed = true\nshape = { half_space = { normal = [0, 1] } "
               "}\n"
               "[[body]]\nname = 'left'\nmaterial = 'rock'\nfixed = true\nshape = { half_space = { normal = [1, 0] } "
               "}\n"
               "[[body]]\nname = 'right'\nmaterial = 'rock'\nfixed = true\n"
               "shape = { half_space = { normal = [-1, 0], offset = -1 } }\n" +
               more;
    }
};

TEST_F(Mishaps, ASignalThatWasIgnoredWhenTheRunBeganStaysIgnored) {
    // As nohup starts it. The handler of the run took its place, and the hang-up of the terminal stopped the run.
    const Program program(folder.path(), {"run", case_file(), "--out", out("a")}, [] { signal(SIGHUP, SIG_IGN); });
    wait_for_steps("a");
    program.send(SIGHUP);
    EXPECT_EQ(program.wait().code, 0);
    EXPECT_EQ(summary_of("a").at("status"), "finished");
}

TEST_F(Mishaps, ATableThatIsRemovedDuringARunIsNoSuccess) {
    for (const char* name : {"probes.csv", "ledger.csv"}) {
        const Program program(folder.path(), {"run", case_file(), "--out", out("a"), "--force", "--set", "end=10000"});
        wait_for_steps("a");
        std::filesystem::remove(in("a", name));
        const Ending ending = program.wait();
        EXPECT_EQ(ending.code, 5) << name;
        EXPECT_THAT(ending.err, AllOf(HasSubstr(name), HasSubstr("removed or replaced")));
        std::filesystem::remove_all(out("a"));
    }
}

TEST_F(Mishaps, ATableThatIsCutOrAddedToDuringARunIsNoSuccess) {
    // A row of zero bytes stood where the file had been cut, and the run ended with 0.
    for (const char* name : {"probes.csv", "ledger.csv"}) {
        for (const bool is_cut : {true, false}) {
            const Program program(folder.path(),
                                  {"run", case_file(), "--out", out("a"), "--force", "--set", "end=10000"});
            wait_for_steps("a");
            if (is_cut) {
                std::filesystem::resize_file(in("a", name), 10);
            } else {
                std::ofstream(in("a", name), std::ios::app) << "1,2,3\n";
            }
            const Ending ending = program.wait();
            EXPECT_EQ(ending.code, 5) << name;
            EXPECT_THAT(ending.err, AllOf(HasSubstr(name), HasSubstr("another program changed it")));
            std::filesystem::remove_all(out("a"));
        }
    }
}

TEST_F(Mishaps, TheTableOfBodiesOfARunAtItsEndIsMendedAndThatIsTold) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=20"}).code, 0);
    const std::string whole = text_of(folder / "a" / "bodies.csv");
    for (const std::size_t kept : {std::size_t{0}, whole.size() / 2}) {
        std::ofstream(folder / "a" / "bodies.csv") << whole.substr(0, kept);
        const Ending told = run({"resume", out("a")});
        EXPECT_EQ(told.code, 0) << told.err;
        EXPECT_THAT(told.out, HasSubstr("bodies.csv' was missing or cut and is written again"));
        const std::string mended = text_of(folder / "a" / "bodies.csv");
        EXPECT_EQ(std::count(mended.begin(), mended.end(), '\n'), std::count(whole.begin(), whole.end(), '\n'));
        EXPECT_EQ(mended.substr(0, mended.find('\n')), whole.substr(0, whole.find('\n')));
    }
    EXPECT_THAT(run({"resume", out("a")}).out, Not(HasSubstr("written again")));
}

TEST_F(Mishaps, APipeInPlaceOfTheTableOfBodiesDoesNotHoldUpARunAtItsEnd) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=20"}).code, 0);
    const std::filesystem::path table = folder / "a" / "bodies.csv";
    std::filesystem::remove(table);
    ASSERT_EQ(::mkfifo(table.c_str(), 0600), 0);
    const Ending ending = run({"resume", out("a")});
    EXPECT_TRUE(ending.code == 0 || ending.code == 5) << ending.code << ending.err;
    EXPECT_TRUE(ending.code == 5 || std::filesystem::is_regular_file(table));
}

TEST_F(Mishaps, ALatestCheckpointThatCannotBeReadIsPassedOverForThePrevious) {
    const Whole whole = whole_run("1");
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=20"}).code, 0);
    ASSERT_EQ(run({"resume", out("a"), "--max-steps", "40"}).code, 0);
    std::filesystem::remove(in("a", "checkpoint/latest"));
    std::filesystem::create_directory(in("a", "checkpoint/latest"));  // reading it fails as a bad sector does
    const Ending ending = run({"resume", out("a"), "--max-steps", "-1"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.err, HasSubstr("continuing from the checkpoint before"));
    EXPECT_EQ(summary_of("a").at("state_hash"), whole.hash);
}

TEST_F(Mishaps, ACheckpointOfAnOlderVersionGoesOnFromItsFolderAndSaysSo) {
    const Whole whole = whole_run("1");
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=20"}).code, 0);
    make_older(in("a", "checkpoint/latest"), 1);
    const Ending other = run({"run", case_file(), "--out", out("a"), "--resume"});
    EXPECT_EQ(other.code, 6);
    EXPECT_THAT(other.err, AllOf(HasSubstr("older Riprap"), HasSubstr("riprap resume")));
    const Ending ending = run({"resume", out("a"), "--max-steps", "-1"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.err, HasSubstr("is of Riprap 0.1 and 0.2"));
    EXPECT_EQ(summary_of("a").at("state_hash"), whole.hash);
}

TEST_F(Mishaps, NothingThatACaseOrAFileNameHoldsIsObeyedByTheTerminal) {
    const auto is_plain = [](const std::string& text) {
        return std::none_of(text.begin(), text.end(), [](char c) {
            return std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\n' && c != '\t';
        });
    };
    const std::string evil = "\x1b]0;pwn\x07\x1b[2J";
    const std::string in_toml = R"(\u001b]0;pwn\u0007\u001b[2J)";
    const std::vector<std::string> cases{
        "title = \"" + in_toml + "\"\n" + case_text().substr(case_text().find("gravity")),
        case_text() + "\"" + in_toml + "\" = 1\n", case_text() + "[material.\"" + in_toml + "\"]\ndensity = 1\n"};
    for (const std::string& text : cases) {
        const std::string file = write_case("evil.toml", text);
        for (const char* command : {"check", "run"}) {
            const Ending ending =
                run(std::string(command) == "run" ? std::vector<std::string>{"run", file, "--out", out("a")}
                                                  : std::vector<std::string>{"check", file});
            EXPECT_EQ(ending.code, 3);
            EXPECT_THAT(ending.err, HasSubstr("control characters"));
            EXPECT_TRUE(is_plain(ending.err) && is_plain(ending.out)) << ending.err;
        }
    }
    const std::string named = write_case("a" + evil + ".toml", case_text() + "[nonsense]\n");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"check", named},
          {"check", named + ".not"},
          {"run", case_file(), "--out", out("b" + evil), "--set", "max_steps=1"},
          {"resume", out("c" + evil)},
          {"plot", out("c" + evil)},
          {evil}}) {
        const Ending ending = run(words);
        EXPECT_TRUE(is_plain(ending.err) && is_plain(ending.out)) << ending.out << ending.err;
    }
}

TEST_F(Mishaps, CheckTellsARefusalWhereRefusalsAreTold) {
    const std::string file = write_case("fast.toml", falling_blocks_text() + "\n[solid]\nmax_speed = 0.5\n");
    const Ending ending = run({"check", file});
    EXPECT_EQ(ending.code, 4);
    EXPECT_THAT(ending.err, HasSubstr("is refused"));
    EXPECT_THAT(ending.out, Not(HasSubstr("refused")));
}

TEST_F(Mishaps, AnAdviceIsAboutTheReasonOfTheRefusal) {
    const std::string file = write_case("unsolved.toml", pool("0.05"));
    const Ending unsolved = run({"run", file, "--out", out("a"), "--set", "fluid.method=\"mps\"", "--set",
                                 "fluid.max_iterations=1", "--set", "fluid.tolerance=1e-12"});
    EXPECT_EQ(unsolved.code, 4);
    EXPECT_THAT(unsolved.err, HasSubstr("after 1 iterations, residual "));
    EXPECT_THAT(unsolved.err, HasSubstr("\n  what helps: fluid.max_iterations = 1000\n"));
    EXPECT_THAT(unsolved.err, Not(HasSubstr("leaves the domain")));
    const Ending fast = run(
        {"run", write_case("fast.toml", falling_blocks_text() + "\n[solid]\nmax_speed = 0.5\n"), "--out", out("b")});
    EXPECT_EQ(fast.code, 4);
    EXPECT_THAT(fast.err, HasSubstr("\n  what helps: solid.max_speed = "));
}

TEST_F(Mishaps, AGaugeAlongALineWithoutEndIsRefusedAndALongOneHoldsNothingUp) {
    const std::string gauge = "[[output.gauge]]\nname = 'g'\nkind = 'surface'\npoint = [0.5, 0.2]\nend = ";
    const std::string endless = write_case("endless.toml", pool("0.05", gauge + "[1e300, 1e300]\n"));
    const Ending refused = run({"run", endless, "--out", out("a")});
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("endless.toml:"));
    const std::string far = write_case("long.toml", pool("0.05", gauge + "[0.5, 1e5]\n"));
    EXPECT_EQ(run({"run", far, "--out", out("b")}).code, 0);
}

TEST_F(Mishaps, MoreParticlesThanTheMemoryHoldsAreRefusedBeforeItIsTaken) {
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    GTEST_SKIP() << "the sanitizer itself takes more addresses than the limit";
#endif
#endif
    const std::string file = write_case("many.toml", pool("0.001"));  // a million
    const Ending ending = Program(folder.path(), {"check", file}, [] {
                              const rlimit limit{600'000'000, 600'000'000};
                              setrlimit(RLIMIT_AS, &limit);
                          }).wait();
    EXPECT_EQ(ending.code, 3);
    EXPECT_THAT(ending.err, AllOf(HasSubstr("many.toml:"), HasSubstr("hold 1000000 particles"), HasSubstr("memory")));
}

/// A connection to the address that --serve prints; closes itself.
class Connection {
 public:
    explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() { ::close(socket_); }
    std::string ask(const std::string& request) const {
        EXPECT_EQ(::send(socket_, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
        std::string answer;
        char buffer[4096];
        for (ssize_t count = 0; (count = ::recv(socket_, buffer, sizeof buffer, 0)) > 0;) {
            answer.append(buffer, static_cast<std::size_t>(count));
        }
        return answer;
    }

 private:
    int socket_;
};

TEST_F(Mishaps, VisitorsThatSayNothingDoNotKeepOthersFromThePage) {
    // Six of them held the page up for 13 s, one after the other.
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "max_steps=5"}).code, 0);
    const Program program(folder.path(), {"view", out("a"), "--serve"});
    std::string told;
    for (int i = 0; i < 1000 && told.find("shows the run") == std::string::npos; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        told = text_of(folder / "stdout");
    }
    const std::size_t at = told.find("127.0.0.1:");
    ASSERT_NE(at, std::string::npos) << told;
    const int port = std::stoi(told.substr(at + 10));
    std::vector<std::unique_ptr<Connection>> silent;
    for (int i = 0; i < 6; ++i) {
        silent.push_back(std::make_unique<Connection>(port));
    }
    const Timer timer;
    const std::string answer = Connection(port).ask("GET /none HTTP/1.1\r\nHost: localhost\r\n\r\n");
    EXPECT_THAT(answer, HasSubstr("404"));
    EXPECT_LT(timer.seconds(), 5);  // a visitor has 2 s to ask, six of them 12 s
    program.send(SIGTERM);
    program.wait();
}

}  // namespace
}  // namespace riprap
