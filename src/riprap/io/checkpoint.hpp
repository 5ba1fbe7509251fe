// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checkpoints: every field of State (core/fields.hpp) as a named, typed, checksummed section of one binary file.
//
// Layout, little-endian:
//   header   magic "RIPRAPCK", u32 version, u32 section count, u64 case hash, u64 file size, i64 step, f64 time,
//            u32 crc of the header so far
//   section  u16 name length, name, u8 type, u8 components, u64 entry count, u32 crc of this section's head so far,
//            the entries, u32 crc of the entries
//   end      magic "RIPRAPND"
// CRCs are zlib's crc32. A reader never trusts a length: every count is checked against the bytes that are there
// before anything is allocated, and every byte of the file is covered by a checksum or compared with a constant.

#include <cstdint>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/core/fields.hpp"
#include "riprap/io/old_formats.hpp"

namespace riprap::io {

/// Format that is written. Older ones are read too: what they lack begins anew (io/old_formats.hpp).
/// 2: what verdicts remember; 3: deep pairs; 4: slip of bonds; 5: ways of walls that water was not told of; 6: gauges
/// that respond slowly, and the clock of the flow; 7: damping of sound in the last kick.
inline constexpr std::uint32_t checkpoint_version = 7;

/// Header of a checkpoint.
struct CheckpointHeader {
    std::uint64_t case_hash{0};  ///< of the resolved case: a checkpoint belongs to one case
    std::int64_t step{0};
    double time{0};  ///< [s]
};

/// One named array; `data` is borrowed.
struct Section {
    std::string_view name;
    FieldType type{FieldType::float64};
    int components{1};
    std::uint64_t count{0};  ///< entries, each of `components` values
    const unsigned char* data{nullptr};

    std::uint64_t bytes() const;
};

/// Bytes of one value of a field.
constexpr std::size_t bytes_of(FieldType type) {
    switch (type) {
        case FieldType::int32:
            return 4;
        case FieldType::uint8:
            return 1;
        default:
            return 8;
    }
}

/// Writes the file, atomically. A file that stood there before is kept as `previous` where that is given: at every
/// moment at least one of the two is whole. @throws FileError
void write_sections(const std::filesystem::path& path, const CheckpointHeader& header,
                    std::span<const Section> sections, const std::filesystem::path& previous = {});

/// A checkpoint in memory, checked from the first byte to the last.
class Checkpoint {
 public:
    /// @throws CheckpointError naming what is wrong and where; `name` is the file for the message.
    static Checkpoint parse(std::string bytes, const std::string& name);
    /// @throws FileError, CheckpointError
    static Checkpoint read(const std::filesystem::path& path);

    const CheckpointHeader& header() const { return header_; }
    std::uint32_t version() const { return version_; }  ///< format of the file
    bool is_old() const { return version_ < checkpoint_version; }
    const std::vector<Section>& sections() const { return sections_; }
    const Section* find(std::string_view name) const;
    const std::string& name() const { return name_; }

    Checkpoint(Checkpoint&&) = default;
    Checkpoint& operator=(Checkpoint&&) = default;

 private:
    Checkpoint() = default;
    std::string bytes_, name_;  // sections_ point into bytes_: movable, not copyable
    CheckpointHeader header_;
    std::uint32_t version_{checkpoint_version};
    std::vector<Section> sections_;
};

/// The fields of a State as sections that borrow from it.
template <class State>
void append_sections(const State& state, std::vector<Section>& sections) {
    State::visit_fields(state, [&sections](std::string_view name, const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (is_field_array<Field>) {
            using Traits = FieldTraits<typename Field::value_type>;
            sections.push_back({name, Traits::type, Traits::components, field.size(),
                                reinterpret_cast<const unsigned char*>(field.data())});
        } else {
            using Traits = FieldTraits<Field>;
            sections.push_back(
                {name, Traits::type, Traits::components, 1, reinterpret_cast<const unsigned char*>(&field)});
        }
    });
}

/// The same under names that begin with `prefix`, for a second State in one file. `names` holds these names: it must
/// outlive the sections, and keep its entries where they are.
template <class State>
void append_sections(const State& state, std::string_view prefix, std::deque<std::string>& names,
                     std::vector<Section>& sections) {
    const std::size_t first = sections.size();
    append_sections(state, sections);
    for (std::size_t i = first; i < sections.size(); ++i) {
        sections[i].name = names.emplace_back(std::string(prefix) + std::string(sections[i].name));
    }
}

/// The section of that name, which must have this type. @throws CheckpointError
const Section& require_section(const Checkpoint& checkpoint, std::string_view name, FieldType type, int components);
[[noreturn]] void refuse_count(const Checkpoint& checkpoint, const Section& section, std::uint64_t expected);

/// Fills every field of a State from its section. Where the State at hand already has a field of known length (one
/// entry per body) that length is required: `fixed_length(name)` says so. A field that the format of the file did not
/// have keeps what it is, or is zero for each entry of the field that it belongs to.
/// @param prefix  with which the names of the sections begin; `fixed_length` is asked without it
/// @throws CheckpointError when a section is missing or has another type or length
template <class State, class FixedLength>
void restore(const Checkpoint& checkpoint, State& state, FixedLength&& fixed_length, std::string_view prefix = {}) {
    State::visit_fields(state, [&](std::string_view name, auto& field) {
        const std::string full = std::string(prefix) + std::string(name);
        using Field = std::remove_cvref_t<decltype(field)>;
        if (const LaterField* later = later_field(checkpoint.version(), name)) {
            if constexpr (is_field_array<Field>) {
                if (!later->belongs_to.empty()) {
                    const Section* rows = checkpoint.find(std::string(prefix) + std::string(later->belongs_to));
                    field.assign(rows == nullptr ? 0 : static_cast<std::size_t>(rows->count), {});
                }
            }
            return;
        }
        if constexpr (is_field_array<Field>) {
            using Entry = typename Field::value_type;
            using Traits = FieldTraits<Entry>;
            const Section& section = require_section(checkpoint, full, Traits::type, Traits::components);
            if (fixed_length(name) && section.count != field.size()) {
                refuse_count(checkpoint, section, field.size());
            }
            field.resize(static_cast<std::size_t>(section.count));
            if (section.count > 0) {
                std::memcpy(static_cast<void*>(field.data()), section.data, field.size() * sizeof(Entry));
            }
        } else {
            using Traits = FieldTraits<Field>;
            const Section& section = require_section(checkpoint, full, Traits::type, Traits::components);
            if (section.count != 1) {
                refuse_count(checkpoint, section, 1);
            }
            std::memcpy(static_cast<void*>(&field), section.data, sizeof field);
        }
    });
}

}  // namespace riprap::io
