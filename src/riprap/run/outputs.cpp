// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/outputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "riprap/fluid/grid/shown_water.hpp"
#include "riprap/io/fluid_frame.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::run {

namespace {

std::vector<io::CsvColumn> with_time(const std::vector<sim::Column>& columns) {
    std::vector<io::CsvColumn> headings{{"time", "s"}};
    for (const sim::Column& column : columns) {
        headings.push_back({column.name, column.unit});
    }
    return headings;
}

io::GrowingCsv open_table(const std::filesystem::path& path, const std::vector<sim::Column>& columns,
                          const RunRecord* record, std::size_t which) {
    const std::vector<io::CsvColumn> headings = with_time(columns);
    return record == nullptr ? io::GrowingCsv(path, headings)
                             : io::GrowingCsv(path, headings, record->csv_bytes[which]);
}

std::vector<double> row_of(double time, const std::vector<sim::Column>& columns, const sim::Moment& moment) {
    std::vector<double> row{time};
    for (const sim::Column& column : columns) {
        row.push_back(evaluate(column, moment));
    }
    return row;
}

std::string frame_tag(std::size_t number) { return fmt::format("{:06}", number); }

}  // namespace

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

void require_tables(const RunFolder& folder, const sim::Model& model, const RunRecord& record) {
    io::require_table(folder.probes(), with_time(sim::record_columns(model)), record.csv_bytes[0]);
    io::require_table(folder.ledger(), with_time(scene_columns(model)), record.csv_bytes[1]);
}

double frame_interval(const sim::Model& model) {
    return model.output.interval > 0 ? model.output.interval : model.time.end / 100;
}
double row_interval(const sim::Model& model) {
    return model.output.probe_interval > 0 ? model.output.probe_interval : model.time.end / 1000;
}

Outputs::Outputs(const RunFolder& folder, const sim::Model& model, const sim::State& initial, const RunRecord& record,
                 bool is_continued)
    : folder_(folder),
      model_(model),
      frame_schedule_(record.frame_interval, record.next_frame),
      row_schedule_(record.row_interval, record.next_row),
      planes_(io::draw_planes(model, initial)),
      probe_columns_(sim::record_columns(model)),
      ledger_columns_(scene_columns(model)),
      probes_(open_table(folder.probes(), probe_columns_, is_continued ? &record : nullptr, 0)),
      ledger_(open_table(folder.ledger(), ledger_columns_, is_continued ? &record : nullptr, 1)),
      frame_times_(record.frame_times) {
    std::error_code ignored;
    std::filesystem::remove(folder.bodies(), ignored);  // these are of an end that is no longer the end
    for (const char* name : {"bodies_end.vtp", "contacts_end.vtp", "water_end.vtp", "surface_end.vtp"}) {
        std::filesystem::remove(folder.frames() / name, ignored);
    }
}

Due Outputs::due_at(double time, double dt) const {
    return {row_schedule_.is_due(time, dt), model_.output.vtk && frame_schedule_.is_due(time, dt)};
}

void Outputs::after_step(const sim::Moment& moment, Due due) {
    const double time = moment.state.time, dt = moment.state.previous_dt;
    if (due.row) {
        write_probe_row(moment);
        write_ledger_row(moment);
        row_schedule_.meet(time, dt);
    }
    if (due.frame) {
        write_frame(moment, frame_tag(frame_times_.size()));
        frame_times_.push_back(time);
        write_lists(nullptr);
        frame_schedule_.meet(time, dt);
    }
    last_written_ = due;
}

void Outputs::write_probe_row(const sim::Moment& moment) {
    probes_.add_row(row_of(moment.state.time, probe_columns_, moment));
}

void Outputs::write_ledger_row(const sim::Moment& moment) {
    if (moment.report != nullptr) {  // the ledger is measured within a step: there is none at time 0
        ledger_.add_row(row_of(moment.report->ledger.time, ledger_columns_, moment));
    }
}

void Outputs::write_frame(const sim::Moment& moment, const std::string& tag) {
    const bool has_contacts = moment.scratch != nullptr;
    const std::vector<Vec3> no_force;
    write_vtp(folder_.frames() / ("bodies_" + tag + ".vtp"),
              io::draw_bodies(model_, moment.initial, moment.state, planes_,
                              has_contacts ? moment.scratch->contact_force() : no_force),
              moment.state.time);
    if (model_.particles() != nullptr) {
        io::write_fluid(folder_.frames() / ("water_" + tag + ".vtp"), model_.particles()->settings(),
                        moment.state.fluid, moment.state.time);
    } else if (const auto water = sim::show_water(model_, moment.state)) {
        io::write_grid_water(folder_.frames() / ("water_" + tag + ".vtp"), *water, moment.state.time);
        write_vtp(folder_.frames() / ("surface_" + tag + ".vtp"), io::draw_surface(*water), moment.state.time);
    }
    if (model_.output.contacts) {
        write_vtp(folder_.frames() / ("contacts_" + tag + ".vtp"),
                  io::draw_contacts(has_contacts ? shown_contacts(model_, moment.state, *moment.scratch)
                                                 : std::vector<contact::ShownContact>()),
                  moment.state.time);
    }
}

void Outputs::write_lists(const sim::Moment* last) const {
    const auto list = [&](const std::vector<std::string>& kinds) {
        std::vector<io::PvdFrame> frames;
        const auto add = [&](double time, const std::string& tag) {
            for (std::size_t part = 0; part < kinds.size(); ++part) {
                frames.push_back({time, "frames/" + kinds[part] + "_" + tag + ".vtp", static_cast<int>(part)});
            }
        };
        for (std::size_t i = 0; i < frame_times_.size(); ++i) {
            add(frame_times_[i], frame_tag(i));
        }
        if (last != nullptr) {
            add(last->state.time, "end");
        }
        return frames;
    };
    io::write_pvd(folder_.root / "out.pvd", model_.particles() != nullptr ? list({"bodies", "water"})
                                            : sim::shows_water(model_)    ? list({"bodies", "water", "surface"})
                                                                          : list(std::vector<std::string>{"bodies"}));
    if (model_.output.contacts) {
        io::write_pvd(folder_.root / "contacts.pvd", list({"contacts"}));
    }
}

void Outputs::note(RunRecord& record) {
    probes_.flush(false);
    ledger_.flush(false);
    io::flush_file_system(folder_.root);  // frames included: what a checkpoint counts on is on the disk before it
    record.csv_bytes = {probes_.bytes(), ledger_.bytes()};
    record.frame_times = frame_times_;
    record.next_row = row_schedule_.next();
    record.next_frame = frame_schedule_.next();
}

void Outputs::at_end(const sim::Moment& moment) {
    if (!last_written_.row) {
        write_probe_row(moment);
        write_ledger_row(moment);
    }
    probes_.flush(true);
    ledger_.flush(true);
    if (model_.output.vtk && !last_written_.frame) {
        write_frame(moment, "end");
        write_lists(&moment);
    }
    const std::vector<Vec3> no_force;
    io::write_bodies_csv(folder_.bodies(), model_, moment.initial, moment.state,
                         moment.scratch != nullptr ? moment.scratch->contact_force() : no_force);
}

}  // namespace riprap::run
