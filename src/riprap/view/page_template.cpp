// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/page_template.hpp"

// The assembler takes the file as it is: no compiler has to read hundreds of kilobytes of text. RIPRAP_PAGE_FILE is the
// page as vite built it, or an empty file.
asm(R"(
    .pushsection .rodata
    .global riprap_page_begin
    .global riprap_page_end
riprap_page_begin:
    .incbin ")" RIPRAP_PAGE_FILE R"("
riprap_page_end:
    .byte 0
    .popsection
)");

extern "C" {
extern const char riprap_page_begin[];
extern const char riprap_page_end[];
}

namespace riprap::view {

std::string_view page_template() {
    return {riprap_page_begin, static_cast<std::size_t>(riprap_page_end - riprap_page_begin)};
}

}  // namespace riprap::view
