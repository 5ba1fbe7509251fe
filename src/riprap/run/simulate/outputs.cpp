// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/outputs.hpp"

#include <fmt/format.h>

#include "riprap/io/csv.hpp"
#include "riprap/io/output/output_kinds.hpp"

namespace riprap::run {

namespace {

std::string frame_tag(std::size_t number) { return fmt::format("{:06}", number); }

}  // namespace

double frame_interval(const sim::Model& model) {
    return model.output.interval > 0 ? model.output.interval : model.time.end / 100;
}
double row_interval(const sim::Model& model) {
    return model.output.probe_interval > 0 ? model.output.probe_interval : model.time.end / 1000;
}

Outputs::Outputs(const RunFolder& folder, const scene::LoadedCase& loaded, const sim::State& initial,
                 const RunRecord& record, bool is_continued)
    : folder_(folder.root),
      frame_schedule_(record.frame_interval, record.next_frame),
      row_schedule_(record.row_interval, record.next_row) {
    for (const double time : record.frame_times) {
        frames_.push_back({time, frame_tag(frames_.size())});
    }
    std::size_t table = 0;
    io::for_each_output(*loaded.outputs, [&]<class Kind>(const Kind& kind) {
        io::OutputRun run{folder_, loaded.model, initial};
        if (Kind::has_table) {
            const std::size_t place = table++;
            if (is_continued && place < record.csv_bytes.size() && record.csv_bytes[place] > 0) {
                run.length = record.csv_bytes[place];
            }
        }
        has_frames_ = has_frames_ || kind.has_frames();
        outputs_.push_back({kind.open(run), Kind::has_table});
    });
}

Due Outputs::due_at(double time, double dt) const {
    return {row_schedule_.is_due(time, dt), has_frames_ && frame_schedule_.is_due(time, dt)};
}

void Outputs::after_step(const sim::Moment& moment, Due due) {
    const double time = moment.state.time, dt = moment.state.previous_dt;
    if (due.row) {
        write_rows(moment);
        row_schedule_.meet(time, dt);
    }
    if (due.frame) {
        frames_.push_back({time, frame_tag(frames_.size())});
        write_frames(moment, frames_);
        frame_schedule_.meet(time, dt);
    }
    last_written_ = due;
}

void Outputs::write_rows(const sim::Moment& moment) {
    for_each([&](io::Output& output) { output.write_row(moment); });
}

void Outputs::write_frames(const sim::Moment& moment, std::span<const io::WrittenFrame> frames) {
    for_each([&](io::Output& output) {
        output.write_frame(moment, frames.back().tag);
        output.list_frames(frames);
    });
}

void Outputs::note(RunRecord& record) {
    record.csv_bytes.clear();
    for (const Opened& opened : outputs_) {
        io::GrowingCsv* const table = opened.output != nullptr ? opened.output->table() : nullptr;
        if (table != nullptr) {
            table->flush(false);
        }
        if (opened.has_table) {
            record.csv_bytes.push_back(table != nullptr ? table->bytes() : 0);
        }
    }
    io::flush_file_system(folder_);  // frames included: what a checkpoint counts on is on the disk before it
    record.frame_times.clear();
    for (const io::WrittenFrame& frame : frames_) {
        record.frame_times.push_back(frame.time);
    }
    record.next_row = row_schedule_.next();
    record.next_frame = frame_schedule_.next();
}

void Outputs::at_end(const sim::Moment& moment) {
    if (!last_written_.row) {
        write_rows(moment);
    }
    for_each([](io::Output& output) {
        if (io::GrowingCsv* table = output.table()) {
            table->flush(true);
        }
    });
    if (has_frames_ && !last_written_.frame) {
        std::vector<io::WrittenFrame> frames = frames_;
        frames.push_back({moment.state.time, "end"});
        write_frames(moment, frames);
    }
    for_each([&](io::Output& output) { output.write_end(moment); });
}

}  // namespace riprap::run
