// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace riprap::view {

/// Text as HTML: nothing in it is markup.
std::string escape_html(std::string_view text);

/// HTML of the Markdown that our own pages use: headings, paragraphs, lists, tables, fenced and indented code, and
/// within a line code, bold, emphasis and links, of which the words are kept. Anything else stays as it is written;
/// nothing in the text becomes markup of its own.
std::string html_of_markdown(std::string_view markdown);

}  // namespace riprap::view
