// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/page_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/run/folder/provenance.hpp"
#include "riprap/view/body_extremes.hpp"
#include "riprap/view/chunk.hpp"
#include "riprap/view/pack_bodies.hpp"
#include "riprap/view/pack_water.hpp"
#include "riprap/view/page_template.hpp"
#include "riprap/view/seen_boxes.hpp"
#include "riprap/view/water_reader.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;                   ///< of the contents; page/src/recording.js asks for the same
constexpr std::size_t plotted_rows = 4000;  ///< of a table; more cannot be told apart on a screen
constexpr std::size_t told_notices = 6;
constexpr double base64_growth = 4.0 / 3;
constexpr std::size_t escape_growth = 5;       // "<" becomes "\\u003c"
constexpr std::size_t bytes_per_piece = 100;   // its element and its name
constexpr std::size_t room_for_words = 2'000;  // about the water, in the contents

Json json_of(const Box& box) {
    return box.is_empty() ? Json() : Json{box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
}

Json shown_json(const DrawnBodies& bodies, const BodyExtremes& extremes) {
    Json fields = Json::array();
    for (std::size_t f = 0; f < extremes.fields.size(); ++f) {
        const std::string& name = bodies.shown[f];
        const std::size_t bracket = name.find(" [");
        fields.push_back(
            {{"name", name.substr(0, bracket)},
             {"unit", bracket == std::string::npos ? "-" : name.substr(bracket + 2, name.size() - bracket - 3)},
             {"low", extremes.fields[f].low},
             {"high", extremes.fields[f].high}});
    }
    return fields;
}

Json gauges_json(const std::vector<GaugePlace>& gauges) {
    Json list = Json::array();
    const auto triple = [](const Vec3& x) { return Json{x.x, x.y, x.z}; };
    for (const GaugePlace& gauge : gauges) {
        list.push_back({{"name", gauge.name},
                        {"kind", gauge.kind},
                        {"point", triple(gauge.point)},
                        {"end", gauge.end ? triple(*gauge.end) : Json()}});
    }
    return list;
}

/// The level of the table at a time, linear between rows and constant beyond [m].
double level_at(const std::vector<StillWater::LevelAt>& rows, double time) {
    const auto next = std::find_if(rows.begin(), rows.end(), [time](const auto& row) { return row.time > time; });
    if (next == rows.begin() || next == rows.end()) {
        return next == rows.begin() ? rows.front().level : rows.back().level;
    }
    const StillWater::LevelAt& before = *(next - 1);
    return before.level + (next->level - before.level) * (time - before.time) / (next->time - before.time);
}

/// Numbers of the bodies that water does not see.
std::vector<std::size_t> dry_bodies(const RecordedRun& run) {
    std::vector<std::size_t> dry;
    for (std::size_t b = 0; b < run.body_names.size(); ++b) {
        const std::string& name = run.body_names[b];
        const std::string whole = name.substr(0, name.rfind('['));
        const auto is_of = [&](const std::string& other) { return other == name || other == whole; };
        if (std::ranges::any_of(run.dry_names, is_of)) {
            dry.push_back(b);
        }
    }
    return dry;
}

Json porous_json(const std::vector<PorousZone>& zones) {
    Json list = Json::array();
    for (const PorousZone& zone : zones) {
        Json corners = Json::array();
        for (const Vec3& x : zone.corners) {
            corners.push_back({x.x, x.y});
        }
        list.push_back({{"corners", corners}, {"porosity", zone.porosity}});
    }
    return list;
}

/// Basins of still water, and the level of every frame where a table gives it.
Json still_water_json(const StillWater& water, const std::vector<double>& times) {
    if (water.basins.empty()) {
        return nullptr;
    }
    Json basins = Json::array(), levels = Json::array();
    for (const StillWater::Basin& basin : water.basins) {
        basins.push_back({{"box", {basin.low.x, basin.low.y, basin.low.z, basin.high.x, basin.high.y, basin.high.z}},
                          {"level", basin.level ? Json(*basin.level) : Json()}});
    }
    for (std::size_t k = 0; k < times.size() && !water.levels.empty(); ++k) {
        levels.push_back(level_at(water.levels, times[k]));
    }
    return {{"basins", basins}, {"levels", levels}};
}

/// Packs one run piece by piece.
class Packer {
 public:
    Packer(const RecordedRun& run, const run::StopRequest* stop) : run_(run), stop_(stop) {
        content_.notices = run.notices;
    }

    PageContent pack(std::size_t budget) {
        pack_frames();
        pack_table("gauges and bodies", run_.probes);
        pack_table("ledger", run_.ledger);
        pack_all_water(budget);
        seen_ = boxes_.find();
        shorten_notices();
        content_.contents_json = contents_json();
        return std::move(content_);
    }

 private:
    void add_chunk(std::string name, std::string packed) {
        content_.chunks.push_back({std::move(name), std::move(packed)});
    }

    /// Bodies and contacts, group by group. A frame whose bodies cannot be read is left out.
    void pack_frames() {
        has_bodies_ = std::any_of(run_.frames.begin(), run_.frames.end(),
                                  [](const FrameFiles& files) { return !files.bodies.empty(); });
        for (const FrameFiles& files : run_.frames) {
            heed(stop_);
            try {
                add_frame(files);
            } catch (const FileError& error) {
                content_.notices.push_back(fmt::format("t = {:.6g} s: {}", files.time, error.what()));
            }
        }
        flush_group();
        if (!bodies_.shape.empty()) {
            Json shapes = Json::array();
            for (const DrawnShape& shape : bodies_.shapes) {
                Json corners = Json::array();
                for (const Vec3& x : shape.corners) {
                    corners.insert(corners.end(), {x.x, x.y, x.z});
                }
                shapes.push_back({{"corners", corners}, {"faces", shape.faces}});
            }
            add_chunk("shapes", compress(shapes.dump()));
        }
    }

    void add_frame(const FrameFiles& files) {
        if (!files.bodies.empty()) {
            const io::VtpFile frame = io::read_vtp(files.bodies);
            if (bodies_.shape.empty()) {
                bodies_ = read_shapes(frame);
            }
            BodyFrame body_frame = read_body_frame(frame, bodies_);
            boxes_.note(body_frame, bodies_);
            extremes_.note(body_frame, bodies_);
            poses_.push_back(std::move(body_frame.pose));
            motions_.push_back(std::move(body_frame.motion));
            shown_fields_.push_back(std::move(body_frame.shown));
        } else if (has_bodies_) {  // poses are found by the number of the frame
            throw FileError("the frame has no file of bodies");
        }
        shown_.push_back(files);
        add_contacts(files);
        if (shown_.size() % frames_per_group == 0) {
            flush_group();
        }
    }

    /// Gravity of every frame, where it is not the same all the time.
    Json gravity_of_frames() const {
        const body::Gravity& gravity = run_.gravity_law;
        if (!gravity.turns() && gravity.ramp == 0) {
            return nullptr;
        }
        Json values = Json::array();
        for (const FrameFiles& files : shown_) {
            const Vec3 g = gravity.at(files.time);
            values.insert(values.end(), {g.x, g.y, g.z});
        }
        return values;
    }

    void add_contacts(const FrameFiles& files) {
        std::vector<float> rows;
        if (!files.contacts.empty()) {
            try {
                rows = read_contacts(io::read_vtp(files.contacts));
            } catch (const FileError& error) {
                content_.notices.emplace_back(error.what());
            }
        }
        contact_counts_.push_back(rows.size() / contact_values);
        for (std::size_t at = 0; at < rows.size(); at += contact_values) {
            extremes_.note_contact(std::hypot(rows[at + 3], rows[at + 4], rows[at + 5]));
        }
        contacts_.insert(contacts_.end(), rows.begin(), rows.end());
    }

    void flush_group() {
        if (shown_.size() <= groups_done_ * frames_per_group) {
            return;
        }
        const std::size_t group = groups_done_;
        ++groups_done_;
        if (!poses_.empty()) {
            add_chunk(fmt::format("poses-{}", group), pack_rows(std::span<const std::vector<double>>(poses_)));
            add_chunk(fmt::format("motion-{}", group), pack_rows(std::span<const std::vector<float>>(motions_)));
            if (!bodies_.shown.empty()) {
                add_chunk(fmt::format("shown-{}", group),
                          pack_rows(std::span<const std::vector<float>>(shown_fields_)));
            }
        }
        add_chunk(fmt::format("contacts-{}", group),
                  compress(split_planes(bytes_of(std::span<const float>(contacts_)), sizeof(float))));
        poses_.clear();
        motions_.clear();
        shown_fields_.clear();
        contacts_.clear();
    }

    /// Packs a table with no more rows than a screen can show apart.
    void pack_table(const std::string& name, const io::CsvTable& table) {
        const std::size_t rows = table.row_count(), stride = rows / plotted_rows + 1;
        if (rows == 0) {
            return;
        }
        std::vector<double> values;
        Json columns = Json::array();
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            columns.push_back({{"name", table.columns[k].name}, {"unit", table.columns[k].unit}});
            for (std::size_t i = 0; i < rows; i += stride) {
                values.push_back(table.values[k][i]);
            }
        }
        const std::string chunk = fmt::format("table-{}", tables_.size());
        add_chunk(chunk, compress(split_planes(bytes_of(std::span<const double>(values)), sizeof(double))));
        tables_.push_back(
            {{"name", name}, {"chunk", chunk}, {"rows", (rows + stride - 1) / stride}, {"columns", columns}});
    }

    /// Returns the bytes of the page: its program, its contents, and what is packed so far.
    double bytes_without_water() const {
        const std::string contents = contents_json();
        const auto escaped = static_cast<std::size_t>(std::count(contents.begin(), contents.end(), '<'));
        const std::size_t pieces = content_.chunks.size() + shown_.size() / fewest_group_frames + 1;
        return static_cast<double>(page_template().size() + contents.size() + escape_growth * escaped +
                                   bytes_per_piece * pieces + room_for_words) +
               base64_growth * static_cast<double>(content_.packed_bytes());
    }

    void pack_all_water(std::size_t budget) {
        if (std::all_of(shown_.begin(), shown_.end(), [](const FrameFiles& files) { return files.water.empty(); })) {
            return;
        }
        WaterReader reader(shown_, stop_, content_.notices);
        reader.read(0);  // for the spacing
        const double left = std::max(0.0, static_cast<double>(budget) - bytes_without_water()) / base64_growth;
        const PackedWater water = pack_water([&](std::size_t f) { return reader.read(f); }, shown_.size(),
                                             reader.spacing(), static_cast<std::size_t>(left));
        for (std::size_t group = 0; group < water.groups.size(); ++group) {
            add_chunk(fmt::format("water-{}", group), water.groups[group]);
        }
        if (water.groups.empty()) {
            return;
        }
        if (water.stride > 1) {
            content_.notices.push_back(fmt::format("of the water one particle in {} is shown", water.stride));
        }
        if (water.not_numbers > 0) {
            content_.notices.push_back(fmt::format(
                "{} pressures and speeds of water are not finite: they are drawn as the lowest", water.not_numbers));
        }
        content_.water_error = water.error();
        boxes_.add_water(water.low, water.high);
        const Vec3& origin = water.scale.origin;
        water_ = {{"origin", {origin.x, origin.y, origin.z}},
                  {"step", water.scale.step},
                  {"pressure", {water.scale.pressure_low, water.scale.pressure_high}},
                  {"speed", water.scale.speed_high},
                  {"spacing", reader.spacing() * std::cbrt(static_cast<double>(water.stride))},
                  {"particles", water.most_particles},
                  {"group", water.group_frames},
                  {"stride", water.stride}};
    }

    /// Keeps the first of many notices and their number.
    void shorten_notices() {
        std::vector<std::string>& notices = content_.notices;
        if (notices.size() > told_notices) {
            const std::size_t more = notices.size() - told_notices;
            notices.resize(told_notices);
            notices.push_back(fmt::format("and {} more like these", more));
        }
    }

    std::string contents_json() const {
        std::vector<double> times;
        for (const FrameFiles& files : shown_) {
            times.push_back(files.time);
        }
        std::vector<std::string> chunks;
        for (const Chunk& chunk : content_.chunks) {
            chunks.push_back(chunk.name);
        }
        Json json{{"format", format},
                  {"chunks", chunks},
                  {"title", run_.title},
                  {"source", run_.source},
                  {"status", run_.status},
                  {"gravity", {run_.gravity.x, run_.gravity.y, run_.gravity.z}},
                  {"gravity_at", gravity_of_frames()},
                  {"gauges", gauges_json(run_.gauges)},
                  {"is_planar", run_.is_planar},
                  {"group", frames_per_group},
                  {"box_at_start", json_of(seen_.first)},
                  {"box", json_of(seen_.all)},
                  {"box_fixed", json_of(seen_.fixed)},
                  {"times", times},
                  {"bodies", nullptr},
                  {"contacts", contact_counts_},
                  {"water", water_},
                  {"still_water", still_water_json(run_.still_water, times)},
                  {"porous", porous_json(run_.porous)},
                  {"tables", tables_},
                  {"warnings", run_.warnings},
                  {"notices", content_.notices},
                  {"case", run_.case_text},
                  {"resolved", run_.resolved_text},
                  {"summary", run_.summary_json.empty() ? Json() : Json::parse(run_.summary_json)},
                  {"ticket", run_.ticket_json.empty() ? Json() : Json::parse(run_.ticket_json)},
                  {"page_made_by", run::build_info().version}};
        if (!bodies_.shape.empty()) {
            const bool has_names = run_.body_names.size() == bodies_.body_count();
            json["bodies"] = {{"shape", bodies_.shape},
                              {"material", bodies_.material},
                              {"material_names", run_.material_names},
                              {"most_speed", extremes_.speed},
                              {"most_displacement", extremes_.displacement},
                              {"most_force", extremes_.force},
                              {"most_contact_force", extremes_.contact},
                              {"shown", shown_json(bodies_, extremes_)},
                              {"names", has_names ? Json(run_.body_names) : Json()},
                              {"dry", dry_bodies(run_)},
                              {"mass", has_names ? Json(run_.body_mass) : Json()}};
        }
        return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }

    const RecordedRun& run_;
    const run::StopRequest* stop_;
    PageContent content_;
    DrawnBodies bodies_;
    std::vector<FrameFiles> shown_;  ///< frames that could be read
    std::vector<std::vector<double>> poses_;
    std::vector<std::vector<float>> motions_, shown_fields_;
    std::vector<float> contacts_;
    std::vector<std::size_t> contact_counts_;
    SeenBoxes boxes_;
    SeenBoxes::Found seen_;
    BodyExtremes extremes_;
    std::size_t groups_done_{0};
    bool has_bodies_{false};  ///< some frame has bodies: frames without any are left out then
    Json water_, tables_ = Json::array();
};

}  // namespace

std::size_t PageContent::packed_bytes() const {
    std::size_t sum = 0;
    for (const Chunk& chunk : chunks) {
        sum += chunk.packed.size();
    }
    return sum;
}

PageContent pack_run(const RecordedRun& run, std::size_t budget, const run::StopRequest* stop) {
    return Packer(run, stop).pack(budget);
}

}  // namespace riprap::view
