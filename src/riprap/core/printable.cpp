// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/printable.hpp"

namespace riprap {

std::string printable(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string out;
    const auto add = [&out, digits](unsigned char code) {
        out += "\\x";
        out += digits[code >> 4U];
        out += digits[code & 0xFU];
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7F) {
            add(c);
        } else if (c == 0xC2 && next >= 0x80 && next < 0xA0) {  // U+0080 to U+009F
            add(static_cast<unsigned char>(next));
            ++i;
        } else {
            out += text[i];
        }
    }
    return out;
}

}  // namespace riprap
