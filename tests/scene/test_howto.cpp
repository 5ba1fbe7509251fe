// SPDX-License-Identifier: Apache-2.0
// Quotations of docs/howto/write-a-case.md are true: its pieces stand in the cases, its messages are those given.
#include <sstream>

#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;

std::string text_of(const std::filesystem::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    EXPECT_FALSE(text.str().empty()) << path;
    return text.str();
}

/// A fenced block of the page and the text before it.
struct Block {
    std::string kind, text, before;
};

std::vector<Block> blocks_of(const std::string& page) {
    std::vector<Block> blocks;
    std::size_t at = 0;
    for (std::size_t open = page.find("```"); open != std::string::npos; open = page.find("```", at)) {
        const std::size_t line = page.find('\n', open), close = page.find("```", line);
        blocks.push_back({page.substr(open + 3, line - open - 3), page.substr(line + 1, close - line - 1),
                          page.substr(at, open - at)});
        at = close + 3;
    }
    return blocks;
}

TEST(HowTo, every_quoted_piece_stands_in_the_case_that_is_named) {
    int count = 0;
    for (const Block& block : blocks_of(text_of("docs/howto/write-a-case.md"))) {
        if (block.kind != "toml") {
            continue;
        }
        const std::size_t example = block.before.rfind("`cases/"), judged = block.before.rfind("`validation/");
        const std::size_t name = example == std::string::npos ? judged : example;
        ASSERT_NE(name, std::string::npos) << block.text;
        const std::string path = block.before.substr(name + 1, block.before.find('`', name + 1) - name - 1);
        EXPECT_NE(text_of(path).find(block.text), std::string::npos) << path << " does not hold\n" << block.text;
        ++count;
    }
    EXPECT_GE(count, 6);
}

TEST(HowTo, the_quoted_messages_are_those_of_the_quoted_mistakes) {
    const std::vector<Block> blocks = blocks_of(text_of("docs/howto/write-a-case.md"));
    for (std::size_t i = 0; i + 1 < blocks.size(); ++i) {
        if (blocks[i].kind != "toml broken") {
            continue;
        }
        std::string messages;
        try {
            read_case_text(blocks[i].text, "broken.toml", ".");
        } catch (const CaseError& error) {
            messages = std::string(error.what()) + "\n";
        }
        EXPECT_EQ(blocks[i + 1].text, messages);
        return;
    }
    FAIL() << "the page shows no mistake";
}

}  // namespace
}  // namespace riprap::scene
