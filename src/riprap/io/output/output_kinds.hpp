// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/io/output/output.hpp"

namespace riprap::sim {
struct Column;
}

namespace riprap::io {

/// probes.csv: probes, gauges and damage.
struct ProbeTable : OutputKind<ProbeTable> {
    static constexpr std::array<std::string_view, 1> files{"probes.csv"};
    static constexpr bool has_table = true;
    static std::vector<sim::Column> columns(const sim::Model& model);
    std::unique_ptr<Output> open(const OutputRun& run) const;
};

/// ledger.csv: every quantity of the scene.
struct LedgerTable : OutputKind<LedgerTable> {
    static constexpr std::array<std::string_view, 1> files{"ledger.csv"};
    static constexpr bool has_table = true;
    static std::vector<sim::Column> columns(const sim::Model& model);
    std::unique_ptr<Output> open(const OutputRun& run) const;
};

/// Frames for ParaView and the page: bodies, fluid and contacts, and the lists that name them.
struct FrameFiles : OutputKind<FrameFiles> {
    static constexpr std::array<std::string_view, 2> files{"out.pvd", "contacts.pvd"};
    bool vtk{true};
    bool contacts{true};
    static KeyList<FrameFiles> keys();
    bool has_frames() const { return vtk; }
    double frame_bytes(const sim::Moment& moment) const;
    std::unique_ptr<Output> open(const OutputRun& run) const;
};

/// bodies.csv: the bodies at the end of the run.
struct BodyTable : OutputKind<BodyTable> {
    static constexpr std::array<std::string_view, 1> files{"bodies.csv"};
    std::unique_ptr<Output> open(const OutputRun& run) const;
};

template <class... Kinds>
struct OutputList : Kinds... {
    template <class Work>
    void for_each(const Work& work) const {
        (work(static_cast<const Kinds&>(*this)), ...);
    }
};

/// Every output of a run, with what the case chooses of it. One line registers an output; its keys, its files and what
/// a checkpoint holds of it follow. Outputs with a table are added at the end: a checkpoint has their lengths in order.
struct OutputChoices : OutputList<ProbeTable, LedgerTable, FrameFiles, BodyTable> {};

/// Calls work(kind) for every output.
template <class Work>
void for_each_output(const OutputChoices& outputs, const Work& work) {
    outputs.for_each(work);
}

/// Keys of [output] of all outputs.
KeyList<OutputChoices> output_keys();

/// Looks at the tables that a run has left, without opening them to write. @param lengths  what its checkpoint knows of
/// them [bytes] @throws FileError where one is missing, shorter or has other columns
void require_tables(const OutputChoices& outputs, const std::filesystem::path& folder, const sim::Model& model,
                    std::span<const std::uint64_t> lengths);

/// Renames tables that an older version began with other columns, ledger.csv to ledger.older.csv, and sets their
/// lengths to 0, so that new ones begin. A checkpoint has to follow at once: until then the run begins here again.
/// @returns the new names @throws FileError
std::vector<std::filesystem::path> set_older_tables_aside(const OutputChoices& outputs,
                                                          const std::filesystem::path& folder, const sim::Model& model,
                                                          std::span<std::uint64_t> lengths);

/// Every quantity of the scene except time that the methods of a case have, vectors by component: the columns of
/// ledger.csv.
std::vector<sim::Column> scene_columns(const sim::Model& model);

/// Writes bodies.csv of a run that is at its end again where it is missing, empty or cut; forces of contacts, which no
/// checkpoint keeps, stay empty then. @returns its path where it was written
std::filesystem::path mend_bodies(const std::filesystem::path& folder, const sim::Moment& moment);

/// Names of all files, and the number of tables that grow.
std::vector<std::string_view> output_files();
std::size_t output_table_count();

}  // namespace riprap::io
