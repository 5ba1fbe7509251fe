// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/chunk.hpp"

#include <zlib.h>

#include "riprap/core/error.hpp"

namespace riprap::view {

std::string compress(std::string_view bytes, bool is_noisy) {
    constexpr int level = 6, window_bits = 15, memory_level = 9;
    z_stream stream{};
    if (deflateInit2(&stream, level, Z_DEFLATED, window_bits, memory_level, is_noisy ? Z_RLE : Z_DEFAULT_STRATEGY) !=
        Z_OK) {
        throw InternalError("zlib cannot begin");
    }
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib does not write to it
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    const int status = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (status != Z_STREAM_END) {
        throw InternalError("zlib could not compress a piece of the page: " + std::to_string(status));
    }
    return packed;
}

std::string split_planes(std::string_view words, std::size_t width) {
    const std::size_t count = words.size() / width;
    std::string planes(count * width, '\0');
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < width; ++k) {
            planes[k * count + i] = words[i * width + k];
        }
    }
    return planes;
}

void difference_rows(std::string& bytes, std::size_t row) {
    for (std::size_t i = bytes.size(); i-- > row;) {
        bytes[i] = static_cast<char>(bytes[i] ^ bytes[i - row]);
    }
}

}  // namespace riprap::view
