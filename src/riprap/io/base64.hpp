// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace riprap::io {

/// Takes the next piece of a text.
using TextSink = std::function<void(std::string_view)>;

std::string encode_base64(std::span<const unsigned char> bytes);
/// @throws FileError when the text is not base64
std::string decode_base64(std::string_view text);

/// Base64 of bytes that come in pieces: threes are made across their ends.
class Base64Text {
 public:
    explicit Base64Text(const TextSink& put) : put_(put) {}
    explicit Base64Text(TextSink&&) = delete;  // would be gone before the first piece
    void add(std::span<const unsigned char> bytes);
    /// Puts what is left, padded. To be called once, at the end.
    void finish();

 private:
    const TextSink& put_;
    std::vector<unsigned char> left_;  ///< fewer than three
};

}  // namespace riprap::io
