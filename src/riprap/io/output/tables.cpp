// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/output/output_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "riprap/io/csv.hpp"
#include "riprap/io/file_descriptor.hpp"
#include "riprap/io/scene_frame.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::io {

namespace {

std::vector<CsvColumn> headings_of(const std::vector<sim::Column>& columns) {
    std::vector<CsvColumn> headings{{"time", "s"}};
    for (const sim::Column& column : columns) {
        headings.push_back({column.name, column.unit});
    }
    return headings;
}

/// Renames a table that has other columns; returns its new name. Empty where it has these, or is missing altogether.
std::filesystem::path set_aside(const std::filesystem::path& file, std::uint64_t length,
                                const std::vector<CsvColumn>& columns) {
    const auto name = [&file](int number) {
        return file.parent_path() /
               fmt::format("{}.older{}.csv", file.stem().string(), number > 1 ? fmt::format("-{}", number) : "");
    };
    int next = 1;
    while (std::filesystem::exists(name(next))) {
        ++next;
    }
    std::error_code error;
    const bool is_there = std::filesystem::is_regular_file(file, error);
    if (is_there && !has_heading(file, columns)) {
        std::filesystem::rename(file, name(next), error);
        if (error) {
            throw file_error("set aside", file, error.value());
        }
        return name(next);
    }
    const bool has_begun_anew = !is_there || std::filesystem::file_size(file, error) < length;
    return next > 1 && has_begun_anew ? name(next - 1) : std::filesystem::path();  // stopped before its checkpoint
}

/// A table of columns after the time.
class ColumnTable : public Output {
 public:
    ColumnTable(const OutputRun& run, std::string_view file, std::vector<sim::Column> columns)
        : columns_(std::move(columns)) {
        const std::vector<CsvColumn> headings = headings_of(columns_);
        table_ =
            run.length ? GrowingCsv(run.folder / file, headings, *run.length) : GrowingCsv(run.folder / file, headings);
    }
    void write_row(const sim::Moment& moment) override { add_row(moment.state.time, moment); }
    GrowingCsv* table() override { return &table_; }

 protected:
    void add_row(double time, const sim::Moment& moment) {
        std::vector<double> row{time};
        for (const sim::Column& column : columns_) {
            row.push_back(evaluate(column, moment));
        }
        table_.add_row(row);
    }

 private:
    std::vector<sim::Column> columns_;
    GrowingCsv table_;
};

class Ledger : public ColumnTable {
 public:
    using ColumnTable::ColumnTable;
    void write_row(const sim::Moment& moment) override {
        if (moment.report != nullptr) {  // the ledger is measured within a step: there is none at time 0
            add_row(moment.report->ledger.time, moment);
        }
    }
};

class LastBodies : public Output {
 public:
    explicit LastBodies(const OutputRun& run) : path_(run.folder / BodyTable::files.front()) {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    void write_end(const sim::Moment& moment) override {
        const std::vector<Vec3> no_force;
        write_bodies_csv(path_, moment.model, moment.initial, moment.state,
                         moment.scratch != nullptr ? moment.scratch->contact_force() : no_force);
    }

 private:
    std::filesystem::path path_;
};

/// Counts whole lines of a file; 0 where it cannot be read. A pipe would wait for a writer.
std::int64_t count_lines(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return 0;
    }
    std::ifstream file(path, std::ios::binary);
    return std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n');
}

}  // namespace

std::unique_ptr<Output> ProbeTable::open(const OutputRun& run) const {
    return std::make_unique<ColumnTable>(run, files.front(), columns(run.model));
}

std::vector<sim::Column> ProbeTable::columns(const sim::Model& model) { return sim::record_columns(model); }

std::unique_ptr<Output> LedgerTable::open(const OutputRun& run) const {
    return std::make_unique<Ledger>(run, files.front(), columns(run.model));
}

std::vector<sim::Column> LedgerTable::columns(const sim::Model& model) { return scene_columns(model); }

std::unique_ptr<Output> BodyTable::open(const OutputRun& run) const { return std::make_unique<LastBodies>(run); }

std::filesystem::path mend_bodies(const std::filesystem::path& folder, const sim::Moment& moment) {
    const std::filesystem::path path = folder / BodyTable::files.front();
    if (count_lines(path) == moment.model.bodies.size() + 1) {
        return {};
    }
    write_bodies_csv(path, moment.model, moment.initial, moment.state, {});
    return path;
}

void require_tables(const OutputChoices& outputs, const std::filesystem::path& folder, const sim::Model& model,
                    std::span<const std::uint64_t> lengths) {
    std::size_t table = 0;
    for_each_output(outputs, [&]<class Kind>(const Kind&) {
        if constexpr (Kind::has_table) {
            const std::size_t place = table++;
            if (place < lengths.size() && lengths[place] > 0) {
                require_table(folder / Kind::files.front(), headings_of(Kind::columns(model)), lengths[place]);
            }
        }
    });
}

std::vector<std::filesystem::path> set_older_tables_aside(const OutputChoices& outputs,
                                                          const std::filesystem::path& folder, const sim::Model& model,
                                                          std::span<std::uint64_t> lengths) {
    std::vector<std::filesystem::path> aside;
    std::size_t table = 0;
    for_each_output(outputs, [&]<class Kind>(const Kind&) {
        if constexpr (Kind::has_table) {
            const std::size_t place = table++;
            const std::filesystem::path file = folder / Kind::files.front();
            if (place < lengths.size() && lengths[place] > 0) {
                const std::filesystem::path older = set_aside(file, lengths[place], headings_of(Kind::columns(model)));
                if (!older.empty()) {
                    lengths[place] = 0;
                    aside.push_back(older);
                }
            }
        }
    });
    return aside;
}

std::vector<sim::Column> scene_columns(const sim::Model& model) {
    std::vector<sim::Column> columns;
    for (const sim::QuantityInfo& info : sim::quantities()) {
        if (!info.is_of_body && info.name != "time" && has_quantity(model, info)) {
            for (sim::Column& column :
                 sim::columns_of({std::string(info.name), BodyId{}, std::string(info.name)}, model.bodies.is_planar)) {
                columns.push_back(std::move(column));
            }
        }
    }
    return columns;
}

}  // namespace riprap::io
