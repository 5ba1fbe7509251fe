// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/view/markdown.hpp"

namespace riprap::view {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Markdown, TurnsBlocksIntoElements) {
    EXPECT_EQ(html_of_markdown("# Wave\n\nOne line\nand the next.\n"),
              "<h4>Wave</h4>\n<p>One line and the next.</p>\n");
    EXPECT_EQ(html_of_markdown("- a\n  b\n- c\n"), "<ul><li>a b</li>\n<li>c</li>\n</ul>\n");
    EXPECT_EQ(html_of_markdown("1. a\n2. c\n"), "<ol><li>a</li>\n<li>c</li>\n</ol>\n");
    EXPECT_EQ(html_of_markdown("| a | b |\n|---|--:|\n| 1 | `x|y` |\n"),
              "<table><tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td><code>x|y</code></td></tr>\n</table>\n");
    EXPECT_EQ(html_of_markdown("```toml\na = \"<b>\"\n```\nAfter."),
              "<pre>a = &quot;&lt;b&gt;&quot;\n</pre>\n<p>After.</p>\n");
    EXPECT_EQ(html_of_markdown("Before.\n\n    x = y\n"), "<p>Before.</p>\n<pre>x = y\n</pre>\n");
}

TEST(Markdown, TurnsMarksWithinALineIntoElementsAndKeepsTheWordsOfLinks) {
    EXPECT_EQ(html_of_markdown("**red** by `a*b` and *so*, [here](x.md)"),
              "<p><b>red</b> by <code>a*b</code> and <em>so</em>, here</p>\n");
    EXPECT_EQ(html_of_markdown("2*3*4 and [0, 1] and a_b_c"), "<p>2*3*4 and [0, 1] and a_b_c</p>\n");
}

TEST(Markdown, LetsNoMarkupThrough) {
    for (const char* text : {"<script>", "`<script>`", "**<script>**", "| <script> |", "- <script>", "# <script>",
                             "[<script>](x)", "    <script>", "```\n<script>"}) {
        EXPECT_THAT(html_of_markdown(text), Not(HasSubstr("<script>"))) << text;
        EXPECT_THAT(html_of_markdown(text), HasSubstr("&lt;script&gt;")) << text;
    }
}

TEST(Markdown, EndsOnAnyText) {
    for (const char* text : {"", "\n\n", "`", "**", "*", "[", "[a](", "|", "- ", "```", "#", "1. ", "[]()", "|\n|-|"}) {
        html_of_markdown(text);
    }
    EXPECT_EQ(html_of_markdown("`"), "<p>`</p>\n");
}

}  // namespace
}  // namespace riprap::view
