// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/saved_trial.hpp"

#include <fstream>
#include <vector>

#include "riprap/core/fields.hpp"
#include "riprap/io/checkpoint.hpp"

namespace riprap::validation {

std::uint64_t program_identity() {
    static const std::uint64_t identity = [] {
        std::ifstream self("/proc/self/exe", std::ios::binary);
        std::vector<char> block(1U << 16);
        Hasher hasher;
        while (self) {
            self.read(block.data(), static_cast<std::streamsize>(block.size()));
            hasher.add(block.data(), static_cast<std::size_t>(self.gcount()));
        }
        return hasher.value();
    }();
    return identity;
}

void save_trial(const std::filesystem::path& path, const sim::Model& model, const sim::State& state,
                const TrialRecord& record) {
    std::filesystem::create_directories(path.parent_path());
    std::vector<io::Section> sections;
    io::append_sections(state, sections);
    io::append_sections(record, sections);
    io::write_sections(path, {model.case_hash, state.step, state.time}, sections);
}

bool take_up_trial(const std::filesystem::path& path, const sim::Model& model, sim::State& state, TrialRecord& record) {
    if (!std::filesystem::exists(path)) {
        return false;
    }
    const auto any_length = [](std::string_view) { return false; };
    const io::Checkpoint checkpoint = io::Checkpoint::read(path);
    TrialRecord found;
    io::restore(checkpoint, found, any_length);
    const io::CheckpointHeader& header = checkpoint.header();
    const bool is_same_case = header.case_hash == model.case_hash && header.time < model.time.end;  // ends may differ
    if (!is_same_case || found.program != record.program || record.program == 0) {
        return false;
    }
    io::restore(checkpoint, state, any_length);
    record = std::move(found);
    return true;
}

}  // namespace riprap::validation
