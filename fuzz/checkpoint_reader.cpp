// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <cstring>
#include <string>

#include "riprap/io/checkpoint.hpp"
#include "riprap/sim/state.hpp"

namespace {

/// Rewrites every checksum that a well-formed walk meets, so that inputs get past them and reach what lies behind.
void repair_checksums(std::string& bytes) {
    const auto put = [&bytes](std::size_t at, std::size_t begin) {
        const auto crc =
            static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data() + begin), at - begin));
        std::memcpy(bytes.data() + at, &crc, sizeof crc);
    };
    constexpr std::size_t header = 48;
    if (bytes.size() < header + 4) {
        return;
    }
    const std::uint64_t size = bytes.size();
    std::memcpy(bytes.data() + 24, &size, sizeof size);
    put(header, 0);
    std::size_t at = header + 4;
    while (at + 2 <= bytes.size()) {
        std::uint16_t name_bytes = 0;
        std::memcpy(&name_bytes, bytes.data() + at, 2);
        const std::size_t head_end = at + 2 + name_bytes + 10;
        if (head_end + 4 > bytes.size()) {
            return;
        }
        put(head_end, at);
        const auto type = static_cast<riprap::FieldType>(bytes[head_end - 10]);
        const auto components = static_cast<unsigned char>(bytes[head_end - 9]);
        std::uint64_t count = 0;
        std::memcpy(&count, bytes.data() + head_end - 8, 8);
        const std::size_t data = head_end + 4;
        if (count > bytes.size() || data + count * components * riprap::io::bytes_of(type) + 4 > bytes.size()) {
            return;
        }
        const std::size_t data_end = data + count * components * riprap::io::bytes_of(type);
        put(data_end, data);
        at = data_end + 4;
    }
}

void read(const std::string& bytes) {
    try {
        riprap::sim::State state;
        riprap::io::restore(riprap::io::Checkpoint::parse(bytes, "input"), state,
                            [](std::string_view) { return false; });
    } catch (const riprap::CheckpointError&) {
        // a refusal is an answer
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    read(bytes);
    repair_checksums(bytes);
    read(bytes);
    return 0;
}
