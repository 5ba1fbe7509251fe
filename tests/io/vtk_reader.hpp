// SPDX-License-Identifier: Apache-2.0
#pragma once

// A small independent reader of the VTP files that Riprap writes, for tests: finds a DataArray by name, decodes
// base64 and zlib, and gives its values.

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace riprap::vtk_reader {

inline std::string base64(const std::string& text) {
    std::string bytes;
    unsigned buffer = 0;
    int bits = 0;
    for (const char c : text) {
        unsigned value = 0;
        if (c >= 'A' && c <= 'Z') {
            value = static_cast<unsigned>(c - 'A');
        } else if (c >= 'a' && c <= 'z') {
            value = static_cast<unsigned>(c - 'a' + 26);
        } else if (c >= '0' && c <= '9') {
            value = static_cast<unsigned>(c - '0' + 52);
        } else if (c == '+' || c == '/') {
            value = c == '+' ? 62 : 63;
        } else if (c == '=') {
            break;
        } else {
            throw std::runtime_error("not base64");
        }
        buffer = buffer << 6U | value;
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes += static_cast<char>(buffer >> static_cast<unsigned>(bits) & 255U);
        }
    }
    return bytes;
}

/// Value of an attribute in an element's text.
inline std::string attribute(const std::string& element, const std::string& name) {
    const std::size_t at = element.find(' ' + name + "=\"");
    if (at == std::string::npos) {
        return "";
    }
    const std::size_t begin = at + name.size() + 3;
    return element.substr(begin, element.find('"', begin) - begin);
}

/// The opening tag of the first element with this start ("<Piece").
inline std::string tag(const std::string& xml, const std::string& start) {
    const std::size_t at = xml.find(start);
    return at == std::string::npos ? "" : xml.substr(at, xml.find('>', at) - at);
}

/// Decoded bytes of a DataArray.
inline std::string array_bytes(const std::string& xml, const std::string& name) {
    std::size_t at = 0;
    while ((at = xml.find("<DataArray", at)) != std::string::npos) {
        const std::size_t end = xml.find('>', at);
        if (attribute(xml.substr(at, end - at), "Name") != name) {
            at = end;
            continue;
        }
        const std::string text = xml.substr(end + 1, xml.find('<', end) - end - 1);
        std::uint64_t block_count = 0;
        std::memcpy(&block_count, base64(text.substr(0, 12)).data(), 8);
        const std::size_t head_bytes = 8 * (3 + block_count);
        const std::size_t head_chars = (head_bytes + 2) / 3 * 4;
        std::vector<std::uint64_t> head(3 + block_count);
        std::memcpy(head.data(), base64(text.substr(0, head_chars)).data(), head_bytes);
        const std::string packed = base64(text.substr(head_chars));
        std::string bytes;
        std::size_t from = 0;
        for (std::uint64_t b = 0; b < block_count; ++b) {
            uLongf size = b + 1 == block_count && head[2] != 0 ? head[2] : head[1];
            std::string block(size, '\0');
            if (uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                           reinterpret_cast<const Bytef*>(packed.data() + from), head[3 + b]) != Z_OK ||
                size != block.size()) {
                throw std::runtime_error("damaged block");
            }
            from += head[3 + b];
            bytes += block;
        }
        if (from != packed.size()) {
            throw std::runtime_error("bytes left over");
        }
        return bytes;
    }
    throw std::runtime_error("no array " + name);
}

template <class T>
std::vector<T> array(const std::string& xml, const std::string& name) {
    const std::string bytes = array_bytes(xml, name);
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    }
    return values;
}

}  // namespace riprap::vtk_reader
