// SPDX-License-Identifier: Apache-2.0
// A run folder in which someone has put something else under the names that a run writes: a link to a file of the user,
// a second name of one, a named pipe. Nothing is written through them, and nothing waits for them.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

enum class Put { link, dangling_link, hard_link, pipe };

class Links : public RunFixture {
 protected:
    static constexpr const char* years = "years of work";

    Links() {
        write_file("thesis.txt", years);
        std::filesystem::create_directories(out("photos"));
    }
    /// Puts something under a name, in place of what was there.
    void put(const std::string& name, Put what) const {
        const std::string path = out(name);
        std::filesystem::remove_all(path);
        switch (what) {
            case Put::link:
                std::filesystem::create_symlink(out("thesis.txt"), path);
                break;
            case Put::dangling_link:
                std::filesystem::create_symlink(out("nothing.txt"), path);
                break;
            case Put::hard_link:
                std::filesystem::create_hard_link(out("thesis.txt"), path);
                break;
            case Put::pipe:
                ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
                break;
        }
    }
    Ending within_20_seconds(const std::vector<std::string>& words) const {
        return Program(folder.path(), words, [] { alarm(20); }).wait();
    }
    void expect_untouched(const std::string& why) const {
        EXPECT_EQ(text_of(out("thesis.txt")), years) << why;
        EXPECT_FALSE(std::filesystem::exists(out("nothing.txt"))) << why;
        EXPECT_TRUE(std::filesystem::is_empty(out("photos"))) << why;
    }
    void begin(const std::string& name) const {
        if (!std::filesystem::exists(out("begun"))) {
            ASSERT_EQ(
                run({"run", case_file(), "--out", out("begun"), "--set", "end=0.01", "--set", "max_steps=20"}).code, 0);
        }
        std::filesystem::remove_all(out(name));
        std::filesystem::copy(out("begun"), out(name), std::filesystem::copy_options::recursive);
    }
    Ending go_on(const std::string& name) const {
        return within_20_seconds({"resume", out(name), "--max-steps", "-1"});
    }
};

TEST_F(Links, FilesThatAreWrittenWholeTakeThePlaceOfWhatWasThere) {
    for (const Put what : {Put::link, Put::dangling_link, Put::hard_link, Put::pipe}) {
        const std::string why = "put " + std::to_string(static_cast<int>(what));
        begin("a");
        for (const char* file : {".summary.json.partial", "summary.json", ".bodies.csv.partial", "bodies.csv",
                                 ".out.pvd.partial", "out.pvd", "checkpoint/.latest.partial",
                                 "frames/.bodies_000001.vtp.partial", "frames/bodies_000001.vtp"}) {
            put(std::string("a/") + file, what);
        }
        const Ending ending = go_on("a");
        EXPECT_EQ(ending.code, 0) << why << ending.err;
        EXPECT_EQ(summary_of("a").at("status"), "finished") << why;
        expect_untouched(why);
    }
}

TEST_F(Links, FilesThatGrowAreNotWrittenThroughALinkAndNoPipeIsWaitedFor) {
    for (const char* file : {"run.log", "run.jsonl", "probes.csv", "ledger.csv", ".lock"}) {
        for (const Put what : {Put::link, Put::dangling_link, Put::pipe}) {
            const std::string why = std::string(file) + ", " + std::to_string(static_cast<int>(what));
            begin("a");
            put(std::string("a/") + file, what);
            const Ending ending = go_on("a");
            EXPECT_EQ(ending.code, 5) << why;
            EXPECT_THAT(ending.err, AllOf(HasSubstr(file), AnyOf(HasSubstr("a link"), HasSubstr("regular file"))));
            expect_untouched(why);
        }
    }
}

TEST_F(Links, ASecondNameOfAFileThatGrowsKeepsWhatItHad) {
    // As `cp -al` makes them of a whole folder.
    begin("a");
    const std::vector<std::string> files{"run.log", "run.jsonl", "probes.csv", "ledger.csv"};
    std::map<std::string, std::string> before;
    for (const std::string& file : files) {
        std::filesystem::create_hard_link(in("a", file), in("photos", file));
        before[file] = text_of(in("photos", file));
    }
    EXPECT_EQ(go_on("a").code, 0);
    for (const std::string& file : files) {
        EXPECT_EQ(text_of(in("photos", file)), before[file]) << file;
        EXPECT_EQ(text_of(in("a", file)).rfind(before[file].substr(0, 20), 0), 0U) << file;
        EXPECT_GT(text_of(in("a", file)).size(), before[file].size()) << file;
    }
}

TEST_F(Links, FoldersThatLeadElsewhereAreRefused) {
    for (const char* name : {"frames", "checkpoint", "case"}) {
        begin("a");
        std::filesystem::copy(in("a", name), in("a", "moved"), std::filesystem::copy_options::recursive);
        std::filesystem::remove_all(in("a", name));
        std::filesystem::create_directory_symlink(in("a", "moved"), in("a", name));
        const Ending ending = go_on("a");
        EXPECT_EQ(ending.code, 5) << name;
        EXPECT_THAT(ending.err, AllOf(HasSubstr(name), HasSubstr("a link"), HasSubstr("--out")));
        std::filesystem::remove(in("a", name));  // the remedy of the message
        std::filesystem::rename(in("a", "moved"), in("a", name));
        EXPECT_EQ(go_on("a").code, 0) << name;
    }
}

TEST_F(Links, ANewRunWritesThroughNoHiddenName) {
    for (const char* file :
         {".riprap_starting", "..riprap_starting.partial", ".run.json.partial", ".lock", ".resolved.toml.partial"}) {
        for (const Put what : {Put::link, Put::dangling_link, Put::pipe}) {
            std::filesystem::remove_all(out("b"));
            std::filesystem::create_directories(out("b"));
            put(std::string("b/") + file, what);
            const Ending ending =
                within_20_seconds({"run", case_file(), "--out", out("b"), "--set", "end=0.01", "--set", "max_steps=3"});
            EXPECT_THAT(ending.code, AnyOf(0, 5)) << file << ending.err;
            expect_untouched(file);
        }
    }
}

TEST_F(Links, PageAndPlotAreNotWrittenThroughALink) {
    begin("a");
    for (const Put what : {Put::link, Put::dangling_link, Put::hard_link, Put::pipe}) {
        for (const char* file : {".index.html.partial", "index.html", ".plot.svg.partial", "plot.svg"}) {
            put(std::string("a/") + file, what);
        }
        EXPECT_EQ(within_20_seconds({"plot", out("a")}).code, 0);
        EXPECT_THAT(within_20_seconds({"view", out("a")}).code, AnyOf(0, 5));  // 5: built without the page
        expect_untouched("put " + std::to_string(static_cast<int>(what)));
    }
}

TEST_F(Links, TheFilesOfAStudyAreNotWrittenThroughALink) {
    const std::vector<std::string> words{"sweep", case_file(), "--vary", "end=0.001,0.002", "--out", out("s")};
    ASSERT_EQ(within_20_seconds(words).code, 0);
    for (const Put what : {Put::link, Put::dangling_link, Put::hard_link, Put::pipe}) {
        std::filesystem::remove_all(in("s", "run_001"));
        for (const char* file : {"run_001.log", ".sweep.json.partial", "sweep.json", "sweep.csv", "index.html"}) {
            put(std::string("s/") + file, what);
        }
        const Ending ending = within_20_seconds(words);
        EXPECT_EQ(ending.code, 0) << ending.err;
        expect_untouched("put " + std::to_string(static_cast<int>(what)));
    }
}

}  // namespace
}  // namespace riprap
