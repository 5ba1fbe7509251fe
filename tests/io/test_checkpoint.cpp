// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <functional>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/checkpoint.hpp"

namespace riprap::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

struct AllTypes {
    double time{0.5};
    std::int64_t step{7};
    std::vector<Vec3> position{{1, 2, 3}, {4, 5, 6}};
    std::vector<Quat> orientation{{1, 0, 0, 0}, {0, 1, 0, 0}};
    std::vector<std::int32_t> part{1, 2, 3};
    std::vector<std::uint64_t> pair{};
    std::vector<std::uint8_t> flag{9};
    friend bool operator==(const AllTypes&, const AllTypes&) = default;

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("time", self.time);
        visit("step", self.step);
        visit("position", self.position);
        visit("orientation", self.orientation);
        visit("part", self.part);
        visit("pair", self.pair);
        visit("flag", self.flag);
    }
};

bool no_fixed_length(std::string_view) { return false; }

std::string bytes_of_state(const AllTypes& state, std::uint64_t case_hash = 42) {
    const TemporaryFolder folder;
    std::vector<Section> sections;
    append_sections(state, sections);
    write_sections(folder / "c", {case_hash, state.step, state.time}, sections);
    return read_file(folder / "c", 1U << 20U);
}

std::string refusal_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const CheckpointError& error) {
        return error.what();
    }
    return "accepted";
}
std::string refusal_of(const std::string& bytes) {
    return refusal_of([&bytes] {
        AllTypes state;
        restore(Checkpoint::parse(bytes, "file"), state, no_fixed_length);
    });
}

TEST(Checkpoint, AStateComesBackBitForBit) {
    AllTypes state;
    state.position.push_back({-0.0, 1e-310, 1e300});
    AllTypes back{.time = 9, .step = 9, .position = {}, .orientation = {}, .part = {4}, .pair = {8, 8}, .flag = {}};
    const Checkpoint checkpoint = Checkpoint::parse(bytes_of_state(state), "file");
    restore(checkpoint, back, no_fixed_length);
    EXPECT_EQ(back, state);
    EXPECT_EQ(hash_fields(back), hash_fields(state));
    EXPECT_EQ(checkpoint.header().case_hash, 42U);
    EXPECT_EQ(checkpoint.header().step, 7);
    EXPECT_EQ(checkpoint.header().time, 0.5);
}

TEST(Checkpoint, EveryTruncationIsRefused) {
    const std::string bytes = bytes_of_state({});
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_NE(refusal_of(bytes.substr(0, size)), "accepted") << size;
    }
    EXPECT_EQ(refusal_of(bytes), "accepted");
    EXPECT_THAT(refusal_of(bytes + "x"), HasSubstr("bytes"));
}

TEST(Checkpoint, EveryFlippedByteIsRefused) {
    const std::string bytes = bytes_of_state({});
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        for (const unsigned flip : {0x01U, 0x80U, 0xFFU}) {
            std::string damaged = bytes;
            damaged[i] = static_cast<char>(static_cast<unsigned char>(damaged[i]) ^ flip);
            ASSERT_NE(refusal_of(damaged), "accepted") << "byte " << i;
        }
    }
}

TEST(Checkpoint, TheDamagedPlaceIsNamed) {
    std::string bytes = bytes_of_state({});
    bytes[bytes.size() - 12] ^= 1;  // in the last section's checksum
    EXPECT_THAT(refusal_of(bytes), HasSubstr("section data"));
    EXPECT_THAT(refusal_of("some text of another kind that is long enough to be a header"),
                HasSubstr("'file' is not a Riprap checkpoint"));
}

/// Rewrites the checksum of a patched header, as a hostile file would.
std::string with_header_value(std::string bytes, std::size_t at, std::uint32_t value) {
    const std::size_t covered = 48;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    const auto crc = static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), covered));
    std::memcpy(bytes.data() + covered, &crc, sizeof crc);
    return bytes;
}

TEST(Checkpoint, AnotherFormatVersionIsNamed) {
    EXPECT_THAT(refusal_of(with_header_value(bytes_of_state({}), 8, 99)),
                AllOf(HasSubstr("format version 99, that of a later Riprap"), HasSubstr("--force")));
    EXPECT_THAT(refusal_of(with_header_value(bytes_of_state({}), 8, 0)),
                AllOf(HasSubstr("format version 0, that of no Riprap"), HasSubstr("--force")));
}

TEST(Checkpoint, AnAbsurdSectionCountIsRefused) {
    EXPECT_THAT(refusal_of(with_header_value(bytes_of_state({}), 12, 0xFFFFFFFFU)), HasSubstr("4294967295 sections"));
    EXPECT_THAT(refusal_of(with_header_value(bytes_of_state({}), 12, 8)), HasSubstr("damaged"));
    EXPECT_THAT(refusal_of(with_header_value(bytes_of_state({}), 12, 6)), HasSubstr("end mark"));
}

TEST(Checkpoint, AMissingSectionAnotherTypeAndAnotherLengthAreNamed) {
    const TemporaryFolder folder;
    const AllTypes state;
    std::vector<Section> sections;
    append_sections(state, sections);
    const auto refusal_with = [&](std::vector<Section> changed) {
        write_sections(folder / "c", {}, changed);
        return refusal_of([&] {
            AllTypes back;
            restore(Checkpoint::read(folder / "c"), back, [](std::string_view name) { return name == "position"; });
        });
    };
    EXPECT_EQ(refusal_with(sections), "accepted");
    std::vector<Section> changed = sections;
    changed.erase(changed.begin() + 3);
    EXPECT_THAT(refusal_with(changed), HasSubstr("no section 'orientation'"));
    changed = sections;
    changed[4].type = FieldType::int64;
    changed[4].count = 1;
    EXPECT_THAT(refusal_with(changed), HasSubstr("'part' has another type"));
    changed = sections;
    changed[2].count = 1;
    EXPECT_THAT(refusal_with(changed), HasSubstr("'position' has 1 entries, the case needs 2"));
    changed = sections;
    changed[1].count = 0;
    EXPECT_THAT(refusal_with(changed), HasSubstr("'step' has 0 entries, the case needs 1"));
    changed = sections;
    changed.push_back(changed.front());
    EXPECT_THAT(refusal_with(changed), HasSubstr("'time' occurs twice"));
}

}  // namespace
}  // namespace riprap::io
