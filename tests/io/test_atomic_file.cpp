// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <functional>
#include <initializer_list>
#include <iterator>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST(AtomicFile, ACommittedFileHoldsEveryByteAndLeavesNoOtherFile) {
    const TemporaryFolder folder;
    const std::string text(3'000'000, 'r');
    write_file(folder / "a", "old");
    write_file(folder / "a", text);
    EXPECT_EQ(read_file(folder / "a", 1U << 24U), text);
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(AtomicFile, WithoutACommitTheOldFileStays) {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    {
        AtomicFile file(folder / "a");
        file.write("new");
        file.flush();
    }
    EXPECT_EQ(read_file(folder / "a", 100), "old");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

TEST(AtomicFile, AFileAboveItsLimitIsNotRead) {
    const TemporaryFolder folder;
    write_file(folder / "a", "twelve bytes");
    EXPECT_THAT(message_of([&] { read_file(folder / "a", 11); }), HasSubstr("limit of 11"));
    EXPECT_EQ(read_file(folder / "a", 12).size(), 12U);
}

TEST(AtomicFile, AMissingFileAndAFolderAreNamed) {
    const TemporaryFolder folder;
    EXPECT_THAT(message_of([&] { read_file(folder / "missing", 10); }),
                AllOf(HasSubstr("missing"), HasSubstr("No such file"), HasSubstr("check that the path exists")));
    EXPECT_THAT(message_of([&] { read_file(folder.path(), 10); }), HasSubstr("not a regular file"));
}

TEST(AtomicFile, AFileWhereAFolderIsNeededIsNamed) {
    const TemporaryFolder folder;
    write_file(folder / "file", "x");
    EXPECT_THAT(message_of([&] { make_folder(folder / "file"); }), HasSubstr("file"));
    EXPECT_THAT(message_of([&] { write_file(folder / "file/inside", "x"); }), HasSubstr("a file stands where"));
}

TEST(AtomicFile, AFileSizeLimitIsNamedAndTheOldFileStays) {
    const TemporaryFolder folder;
    write_file(folder / "a", "old");
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{100'000, 100'000};
        setrlimit(RLIMIT_FSIZE, &limit);
        const std::string said = message_of([&] { write_file(folder / "a", std::string(1'000'000, 'n')); });
        _exit(said.find("ulimit -f") != std::string::npos ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(read_file(folder / "a", 100), "old");
    EXPECT_EQ(files_in(folder.path()), 1U);
}

/// Runs `action` in a child process that alone sees a small disk mounted on `folder`; its answer, or -1 where the
/// system does not allow that.
int answer_on_disk(const std::filesystem::path& folder, unsigned long flags, const std::function<int()>& action) {
    const int refused = 99;
    const pid_t child = fork();
    if (child == 0) {
        const bool has_own_mounts = unshare(CLONE_NEWNS) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
        if (!has_own_mounts || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            mount("none", folder.c_str(), "tmpfs", flags, "size=256k") != 0) {
            _exit(refused);
        }
        _exit(action());
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) != refused ? WEXITSTATUS(status) : -1;
}

bool contains_all(const std::string& text, std::initializer_list<const char*> parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [&text](const char* part) { return text.find(part) != std::string::npos; });
}

TEST(AtomicFile, AFullDiskIsNamedAndTheOldFileStays) {
    const TemporaryFolder folder;
    const int answer = answer_on_disk(folder.path(), 0, [&] {
        write_file(folder / "a", "old");
        const std::string said = message_of([&] { write_file(folder / "a", std::string(1'000'000, 'n')); });
        const bool is_kept = read_file(folder / "a", 100) == "old" && files_in(folder.path()) == 1;
        return contains_all(said, {"/a'", "No space left", "free some space"}) && is_kept ? 0 : 1;
    });
    if (answer < 0) {
        GTEST_SKIP() << "needs the right to mount a small disk";
    }
    EXPECT_EQ(answer, 0);
}

TEST(ReadFile, ANamedPipeIsRefusedWithoutWaitingForAWriter) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    ::alarm(10);  // waiting would be for ever
    const std::string said = message_of([&] { read_file(folder / "pipe", 100); });
    ::alarm(0);
    EXPECT_THAT(said, HasSubstr("not a regular file"));
}

TEST(AtomicFile, AReadOnlyDiskIsNamed) {
    const TemporaryFolder folder;
    const int answer = answer_on_disk(folder.path(), MS_RDONLY, [&] {
        const std::string said = message_of([&] { write_file(folder / "a", "x"); });
        return contains_all(said, {"/a'", "read-only", "another one"}) ? 0 : 1;
    });
    if (answer < 0) {
        GTEST_SKIP() << "needs the right to mount a small disk";
    }
    EXPECT_EQ(answer, 0);
}

}  // namespace
}  // namespace riprap::io
