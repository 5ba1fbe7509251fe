// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/checkpoint.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstdio>

#include "riprap/io/atomic_file.hpp"

namespace riprap::io {

static_assert(std::endian::native == std::endian::little, "checkpoints are written as little-endian memory");

namespace {

constexpr std::string_view magic_begin = "RIPRAPCK";
constexpr std::string_view magic_end = "RIPRAPND";
constexpr std::size_t header_bytes = 8 + 4 + 4 + 8 + 8 + 8 + 8 + 4;
constexpr std::size_t max_name_bytes = 256;
constexpr std::uint32_t max_sections = 4096;

std::uint32_t checksum(const void* data, std::size_t bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, static_cast<const Bytef*>(data), bytes));
}

/// Appends plain values to a byte string.
class Packer {
 public:
    template <class T>
    void put(T value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put(std::string_view text) { bytes_.append(text); }
    void put_checksum() { put(checksum(bytes_.data(), bytes_.size())); }
    const std::string& bytes() const { return bytes_; }

 private:
    std::string bytes_;
};

std::string pack_section_head(const Section& section) {
    Packer head;
    head.put(static_cast<std::uint16_t>(section.name.size()));
    head.put(section.name);
    head.put(static_cast<std::uint8_t>(section.type));
    head.put(static_cast<std::uint8_t>(section.components));
    head.put(section.count);
    head.put_checksum();
    return head.bytes();
}

std::string pack_header(const CheckpointHeader& header, std::size_t section_count, std::uint64_t file_bytes) {
    Packer head;
    head.put(magic_begin);
    head.put(checkpoint_version);
    head.put(static_cast<std::uint32_t>(section_count));
    head.put(header.case_hash);
    head.put(file_bytes);
    head.put(header.step);
    head.put(header.time);
    head.put_checksum();
    return head.bytes();
}

/// Walks over the bytes of a file that nobody has checked yet.
class Unpacker {
 public:
    Unpacker(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    [[noreturn]] void refuse(const std::string& why) const {
        throw CheckpointError("checkpoint '" + name_ + "' is damaged at byte " + std::to_string(at_) + ": " + why);
    }
    /// The next `count` bytes.
    const char* take(std::uint64_t count, const char* what) {
        if (count > left()) {
            refuse("truncated in the " + std::string(what) + ", " + std::to_string(count) + " bytes needed, " +
                   std::to_string(left()) + " left");
        }
        const char* data = bytes_.data() + at_;
        at_ += static_cast<std::size_t>(count);
        return data;
    }
    template <class T>
    T get(const char* what) {
        T value;
        std::memcpy(&value, take(sizeof value, what), sizeof value);
        return value;
    }
    /// Reads a checksum and compares it with that of everything from `begin` to here.
    void check(std::size_t begin, const char* what) {
        const std::uint32_t computed = checksum(bytes_.data() + begin, at_ - begin);
        if (get<std::uint32_t>(what) != computed) {
            refuse("the checksum of the " + std::string(what) + " does not fit");
        }
    }
    std::size_t at() const { return at_; }
    std::uint64_t left() const { return bytes_.size() - at_; }

 private:
    const std::string& bytes_;
    const std::string& name_;
    std::size_t at_{0};
};

FieldType to_field_type(const Unpacker& in, std::uint8_t code) {
    if (code < static_cast<std::uint8_t>(FieldType::float64) || code > static_cast<std::uint8_t>(FieldType::uint8)) {
        in.refuse("unknown field type " + std::to_string(code));
    }
    return static_cast<FieldType>(code);
}

Section unpack_section(Unpacker& in) {
    const std::size_t begin = in.at();
    Section section;
    const auto name_bytes = in.get<std::uint16_t>("section name");
    if (name_bytes == 0 || name_bytes > max_name_bytes) {
        in.refuse("a section name of " + std::to_string(name_bytes) + " bytes");
    }
    section.name = {in.take(name_bytes, "section name"), name_bytes};
    section.type = to_field_type(in, in.get<std::uint8_t>("section head"));
    section.components = in.get<std::uint8_t>("section head");
    section.count = in.get<std::uint64_t>("section head");
    in.check(begin, "section head");
    if (section.components < 1) {
        in.refuse("a field without components");
    }
    const std::uint64_t entry_bytes = bytes_of(section.type) * static_cast<std::uint64_t>(section.components);
    if (section.count > in.left() / entry_bytes) {
        in.refuse("section '" + std::string(section.name) + "' claims " + std::to_string(section.count) +
                  " entries, more than the file holds");
    }
    const std::size_t data_begin = in.at();
    section.data = reinterpret_cast<const unsigned char*>(in.take(section.count * entry_bytes, "section"));
    in.check(data_begin, "section data");
    return section;
}

}  // namespace

std::uint64_t Section::bytes() const { return count * static_cast<std::uint64_t>(components) * bytes_of(type); }

void write_sections(const std::filesystem::path& path, const CheckpointHeader& header,
                    std::span<const Section> sections, const std::filesystem::path& previous) {
    std::uint64_t file_bytes = header_bytes + magic_end.size();
    for (const Section& section : sections) {
        RIPRAP_ASSERT(!section.name.empty() && section.name.size() <= max_name_bytes, std::string(section.name));
        file_bytes += pack_section_head(section).size() + section.bytes() + sizeof(std::uint32_t);
    }
    AtomicFile file(path);
    file.write(pack_header(header, sections.size(), file_bytes));
    for (const Section& section : sections) {
        file.write(pack_section_head(section));
        file.write(section.data, section.bytes());
        const std::uint32_t crc = checksum(section.data, section.bytes());
        file.write(&crc, sizeof crc);
    }
    file.write(magic_end);
    file.flush();  // whole on the disk before the old one moves
    if (!previous.empty() && std::rename(path.c_str(), previous.c_str()) != 0 && errno != ENOENT) {
        throw file_error("write", previous, errno);
    }
    file.commit();
}

Checkpoint Checkpoint::parse(std::string bytes, const std::string& name) {
    Checkpoint checkpoint;
    checkpoint.bytes_ = std::move(bytes);
    checkpoint.name_ = name;
    Unpacker in(checkpoint.bytes_, checkpoint.name_);
    if (std::string_view(in.take(magic_begin.size(), "header"), magic_begin.size()) != magic_begin) {
        throw CheckpointError("'" + name + "' is not a Riprap checkpoint");
    }
    const auto version = in.get<std::uint32_t>("header");
    const auto section_count = in.get<std::uint32_t>("header");
    checkpoint.header_.case_hash = in.get<std::uint64_t>("header");
    const auto file_bytes = in.get<std::uint64_t>("header");
    checkpoint.header_.step = in.get<std::int64_t>("header");
    checkpoint.header_.time = in.get<double>("header");
    in.check(0, "header");
    if (version < 1 || version > checkpoint_version) {
        throw CheckpointError("checkpoint '" + name + "' has format version " + std::to_string(version) + ", that of " +
                              std::string(writer_of(version)) + "; this Riprap reads versions 1 to " +
                              std::to_string(checkpoint_version) +
                              ": continue the run with the version that wrote it, or begin it anew with --force");
    }
    checkpoint.version_ = version;
    if (file_bytes != checkpoint.bytes_.size()) {
        in.refuse(std::string(checkpoint.bytes_.size() < file_bytes ? "truncated" : "bytes follow its end") +
                  ", the file has " + std::to_string(checkpoint.bytes_.size()) + " bytes, its header says " +
                  std::to_string(file_bytes));
    }
    if (section_count > max_sections) {
        in.refuse(std::to_string(section_count) + " sections");
    }
    for (std::uint32_t i = 0; i < section_count; ++i) {
        const Section section = unpack_section(in);
        if (checkpoint.find(section.name) != nullptr) {
            in.refuse("section '" + std::string(section.name) + "' occurs twice");
        }
        checkpoint.sections_.push_back(section);
    }
    if (std::string_view(in.take(magic_end.size(), "end mark"), magic_end.size()) != magic_end || in.left() != 0) {
        in.refuse("the end mark is missing");
    }
    return checkpoint;
}

Checkpoint Checkpoint::read(const std::filesystem::path& path) {
    return parse(read_file(path, std::numeric_limits<std::size_t>::max()), path.string());
}

const Section* Checkpoint::find(std::string_view name) const {
    const auto found = std::find_if(sections_.begin(), sections_.end(),
                                    [name](const Section& section) { return section.name == name; });
    return found == sections_.end() ? nullptr : &*found;
}

const Section& require_section(const Checkpoint& checkpoint, std::string_view name, FieldType type, int components) {
    const Section* section = checkpoint.find(name);
    if (section == nullptr) {
        throw CheckpointError("checkpoint '" + checkpoint.name() + "' has no section '" + std::string(name) + "'");
    }
    if (section->type != type || section->components != components) {
        throw CheckpointError("checkpoint '" + checkpoint.name() + "': section '" + std::string(name) +
                              "' has another type than this Riprap expects");
    }
    return *section;
}

void refuse_count(const Checkpoint& checkpoint, const Section& section, std::uint64_t expected) {
    throw CheckpointError("checkpoint '" + checkpoint.name() + "': section '" + std::string(section.name) + "' has " +
                          std::to_string(section.count) + " entries, the case needs " + std::to_string(expected));
}

}  // namespace riprap::io
