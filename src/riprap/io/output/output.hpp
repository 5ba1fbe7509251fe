// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/key.hpp"

namespace riprap::sim {
struct Model;
struct Moment;
struct State;
}  // namespace riprap::sim

namespace riprap::io {

class GrowingCsv;

/// The run that an output writes of.
struct OutputRun {
    std::filesystem::path folder;  ///< frames go to its folder "frames"
    const sim::Model& model;
    const sim::State& initial;              ///< at time 0
    std::optional<std::uint64_t> length{};  ///< where the run is continued: of the table that the output had written
    std::filesystem::path frames() const { return folder / "frames"; }
};

/// A frame that was written.
struct WrittenFrame {
    double time;      ///< [s]
    std::string tag;  ///< end of the names of its files: "000012", "end"
};

/// Files that one process of a run writes. Made when the process begins; then it also removes files of an end that is
/// no longer the end. @throws FileError
class Output {
 public:
    Output() = default;
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    virtual ~Output() = default;

    /// Called every output.probe_interval and at the end.
    virtual void write_row(const sim::Moment& /*moment*/) {}
    /// Called every output.interval and at the end.
    virtual void write_frame(const sim::Moment& /*moment*/, const std::string& /*tag*/) {}
    /// Called after every frame with all that have been written.
    virtual void list_frames(std::span<const WrittenFrame> /*frames*/) {}
    /// Called once at the end.
    virtual void write_end(const sim::Moment& /*moment*/) {}
    /// The table that grows by the rows; its length is part of a checkpoint. nullptr where there is none.
    virtual GrowingCsv* table() { return nullptr; }
};

/// Base of the kinds of outputs. A kind is a struct with what a case can choose of it,
///
///     static constexpr std::array files{...};                  // names in the folder of a run, which --force replaces
///     static KeyList<Kind> keys();                             // of [output]
///     std::unique_ptr<Output> open(const OutputRun&) const;    // nullptr where the case does without
///
/// and one line in OutputChoices (io/output/output_kinds.hpp) registers it.
template <class Kind>
struct OutputKind {
    static constexpr bool has_table = false;  ///< see Output::table; if so, columns(model) after the time too
    static KeyList<Kind> keys() { return {}; }
    /// Tells whether frames are written.
    bool has_frames() const { return false; }
    /// Bytes of a frame of the scene at this moment, for `riprap check`.
    double frame_bytes(const sim::Moment& /*moment*/) const { return 0; }
};

}  // namespace riprap::io
