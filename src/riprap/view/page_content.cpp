// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/page_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "riprap/run/provenance.hpp"
#include "riprap/view/chunk.hpp"
#include "riprap/view/pack_bodies.hpp"
#include "riprap/view/pack_water.hpp"
#include "riprap/view/page.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;                   ///< of the contents; page/src/recording.js asks for the same
constexpr std::size_t plotted_rows = 4000;  ///< of a table; more cannot be told apart on a screen
constexpr std::size_t told_notices = 6;
constexpr double same_place = 1e-6;  // of the size of what is free
constexpr double near_share = 0.2;   // of the size of what is free: driven bodies are shown as far around it
constexpr double base64_growth = 4.0 / 3;
constexpr std::size_t escape_growth = 5;       // "<" becomes "\\u003c"
constexpr std::size_t bytes_per_piece = 100;   // its element and its name
constexpr std::size_t room_for_words = 2'000;  // about the water, in the contents

/// Bounding box of a scene.
struct Box {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};  // [m]
    void add(const Vec3& x) {
        low = min(low, x);
        high = max(high, x);
    }
    void add(const Box& box) {
        low = min(low, box.low);
        high = max(high, box.high);
    }
    bool is_empty() const { return low.x > high.x; }
    double length() const { return is_empty() ? 0 : norm(high - low); }
    /// Whether all of it lies within `by` of the other one [m].
    bool is_near(const Box& other, double by) const {
        const Vec3 reach{by, by, by};
        const Vec3 below = other.low - reach - low, above = high - other.high - reach;
        return std::max({below.x, below.y, below.z, above.x, above.y, above.z}) <= 0;
    }
    /// The part of it within `by` of the other one [m]; empty where there is none.
    Box within(const Box& other, double by) const {
        const Vec3 reach{by, by, by};
        const Box part{max(low, other.low - reach), min(high, other.high + reach)};
        return part.low.x > part.high.x || part.low.y > part.high.y || part.low.z > part.high.z ? Box() : part;
    }
    Json json() const { return low.x > high.x ? Json() : Json{low.x, low.y, low.z, high.x, high.y, high.z}; }
};

void require_finite(double value, const std::filesystem::path& path) {
    if (!std::isfinite(value)) {
        throw FileError(
            fmt::format("cannot read '{}': its spacing or a position of its water is not finite", path.string()));
    }
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
        find_boxes();
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
            note_extremes(body_frame);
            poses_.push_back(std::move(body_frame.pose));
            motions_.push_back(std::move(body_frame.motion));
            shown_fields_.push_back(std::move(body_frame.shown));
        } else if (has_bodies_) {  // poses go by the number of the frame
            throw FileError("the frame has no file of bodies");
        }
        shown_.push_back(files);
        add_contacts(files);
        if (shown_.size() % frames_per_group == 0) {
            flush_group();
        }
    }

    /// The largest values of what blocks can be coloured by.
    void note_extremes(const BodyFrame& frame) {
        const bool is_first = first_pose_.empty();
        if (is_first) {
            first_pose_ = frame.pose;
            paths_.resize(bodies_.body_count());
        }
        const auto length = [](const auto* v) {
            return std::hypot(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
        };
        for (std::size_t body = 0; body < bodies_.body_count(); ++body) {
            const float* motion = &frame.motion[motion_values * body];
            const double* pose = &frame.pose[pose_values * body];
            const double* first = &first_pose_[pose_values * body];
            const DrawnShape& shape = bodies_.shapes[static_cast<std::size_t>(bodies_.shape[body])];
            if (shape.faces.size() > 1) {  // a half-space is drawn as a square around the scene, and has no size
                Box box;
                const Vec3 x{pose[0], pose[1], pose[2]};
                for (const Vec3& corner : shape.corners) {
                    box.add(x + rotate({pose[3], pose[4], pose[5], pose[6]}, corner));
                }
                Path& path = paths_[body];
                path.all.add(box);
                path.start.add(is_first ? box : path.start);
                path.is_free = path.is_free || motion[9] > 0;
                path.moves = path.moves || path.is_free || !std::equal(pose, pose + pose_values, first);
            }
            most_.speed = std::fmax(most_.speed, length(motion));
            const double moved[3] = {pose[0] - first[0], pose[1] - first[1], pose[2] - first[2]};
            most_.displacement = std::fmax(most_.displacement, length(moved));
            if (motion[9] > 0) {  // what a fixed body carries would drown the others
                most_.force = std::fmax(most_.force, length(motion + 6));
            }
        }
        note_range_of_fields(frame);
    }

    /// Finds what a reader wants to see over the run: free bodies and water, and of driven bodies what is near them.
    /// Pieces that fly off by more than the length of the start are left out, where nine in ten of the bodies stay.
    void find_boxes() {
        box_first_.add(box_water_);
        std::size_t free = 0, away = 0;
        Box driven, driven_first;
        for (const Path& path : paths_) {
            driven_first.add(path.moves && !path.is_free ? path.start : Box());
            (path.is_free ? box_first_ : path.moves ? driven : box_fixed_).add(path.is_free ? path.start : path.all);
            free += path.is_free ? 1 : 0;
        }
        const double reach = box_first_.length();
        const auto flew_off = [&](const Path& path) { return !path.all.is_near(box_first_, reach); };
        for (const Path& path : paths_) {
            away += path.is_free && flew_off(path) ? 1 : 0;
        }
        box_all_.add(box_water_);
        for (const Path& path : paths_) {
            if (path.is_free) {
                box_all_.add(flew_off(path) && 10 * away < free ? path.start : path.all);
            }
        }
        box_all_.add(box_all_.is_empty() ? driven : driven.within(box_all_, near_share * box_all_.length()));
        if (box_first_.is_near(driven_first, same_place * reach)) {  // a drum
            box_all_.add(driven_first);
        }
    }

    /// Gravity of every frame, where it is not the same all the time.
    Json gravity_of_frames() const {
        const body::Gravity& gravity = run_.gravity_law;
        if (gravity.rate == 0 && gravity.ramp == 0) {
            return nullptr;
        }
        Json values = Json::array();
        for (const FrameFiles& files : shown_) {
            const Vec3 g = gravity.at(files.time);
            values.insert(values.end(), {g.x, g.y, g.z});
        }
        return values;
    }

    Json gauges_json() const {
        Json list = Json::array();
        const auto triple = [](const Vec3& x) { return Json{x.x, x.y, x.z}; };
        for (const GaugePlace& gauge : run_.gauges) {
            list.push_back({{"name", gauge.name},
                            {"kind", gauge.kind},
                            {"point", triple(gauge.point)},
                            {"end", gauge.end ? triple(*gauge.end) : Json()}});
        }
        return list;
    }

    /// Lowest and highest value of every shown field of free bodies.
    void note_range_of_fields(const BodyFrame& frame) {
        const std::size_t count = bodies_.shown.size();
        field_ranges_.resize(count);
        for (std::size_t body = 0; body < bodies_.body_count(); ++body) {
            for (std::size_t f = 0; f < count && frame.motion[motion_values * body + 9] > 0; ++f) {
                const auto value = static_cast<double>(frame.shown[count * body + f]);
                field_ranges_[f].low = std::fmin(field_ranges_[f].low, value);
                field_ranges_[f].high = std::fmax(field_ranges_[f].high, value);
            }
        }
    }

    Json shown_json() const {
        Json fields = Json::array();
        for (std::size_t f = 0; f < field_ranges_.size(); ++f) {
            const std::string& name = bodies_.shown[f];
            const std::size_t bracket = name.find(" [");
            fields.push_back(
                {{"name", name.substr(0, bracket)},
                 {"unit", bracket == std::string::npos ? "-" : name.substr(bracket + 2, name.size() - bracket - 3)},
                 {"low", field_ranges_[f].low},
                 {"high", field_ranges_[f].high}});
        }
        return fields;
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
            most_.contact =
                std::fmax(most_.contact, static_cast<double>(std::hypot(rows[at + 3], rows[at + 4], rows[at + 5])));
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

    WaterFrame read_water(std::size_t f) {
        heed(stop_);
        const FrameFiles& files = shown_[f];
        if (files.water.empty()) {
            return {};
        }
        try {
            const io::VtpFile frame = io::read_vtp(files.water);
            const std::size_t count = frame.point_count();
            if (frame.has(io::VtpSection::field, "spacing")) {
                const double spacing = frame.numbers(io::VtpSection::field, "spacing", 1)[0];
                require_finite(spacing, files.water);
                spacing_ = spacing;
            }
            WaterFrame water{frame.integers(io::VtpSection::point_data, "id", count), frame.points(),
                             frame.floats(io::VtpSection::point_data, "pressure", count),
                             frame.floats(io::VtpSection::point_data, "speed", count)};
            for (const Vec3& x : water.position) {
                require_finite(dot(x, x), files.water);  // the square, that differences are finite too
            }
            return water;
        } catch (const FileError& error) {
            const auto is_known = std::find(content_.notices.begin(), content_.notices.end(), error.what());
            if (is_known == content_.notices.end()) {  // water is read more than once
                content_.notices.emplace_back(error.what());
            }
            return {};
        }
    }

    /// Of the page: its program, its contents, and what is packed so far.
    double bytes_without_water() const {
        const std::string contents = contents_json();
        const auto escaped = static_cast<std::size_t>(std::count(contents.begin(), contents.end(), '<'));
        const std::size_t pieces = content_.chunks.size() + shown_.size() / frames_per_group + 1;
        return static_cast<double>(page_template().size() + contents.size() + escape_growth * escaped +
                                   bytes_per_piece * pieces + room_for_words) +
               base64_growth * static_cast<double>(content_.packed_bytes());
    }

    void pack_all_water(std::size_t budget) {
        if (std::all_of(shown_.begin(), shown_.end(), [](const FrameFiles& files) { return files.water.empty(); })) {
            return;
        }
        read_water(0);  // for the spacing
        const double left = std::max(0.0, static_cast<double>(budget) - bytes_without_water()) / base64_growth;
        const PackedWater water = pack_water([this](std::size_t f) { return read_water(f); }, shown_.size(), spacing_,
                                             static_cast<std::size_t>(left));
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
        for (const Vec3& x : {water.low, water.high}) {
            box_water_.add(x);
        }
        const Vec3& origin = water.scale.origin;
        water_ = {{"origin", {origin.x, origin.y, origin.z}},
                  {"step", water.scale.step},
                  {"pressure", {water.scale.pressure_low, water.scale.pressure_high}},
                  {"speed", water.scale.speed_high},
                  {"spacing", spacing_ * std::cbrt(static_cast<double>(water.stride))},
                  {"particles", water.most_particles},
                  {"stride", water.stride}};
    }

    /// Of many notices the first ones and how many there are.
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
                  {"status", run_.status},
                  {"gravity", {run_.gravity.x, run_.gravity.y, run_.gravity.z}},
                  {"gravity_at", gravity_of_frames()},
                  {"gauges", gauges_json()},
                  {"is_planar", run_.is_planar},
                  {"group", frames_per_group},
                  {"box_at_start", box_first_.json()},
                  {"box", box_all_.json()},
                  {"box_fixed", box_fixed_.json()},
                  {"times", times},
                  {"bodies", nullptr},
                  {"contacts", contact_counts_},
                  {"water", water_},
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
                              {"most_speed", most_.speed},
                              {"most_displacement", most_.displacement},
                              {"most_force", most_.force},
                              {"most_contact_force", most_.contact},
                              {"shown", shown_json()},
                              {"names", has_names ? Json(run_.body_names) : Json()},
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
    struct FieldRange {
        double low{std::numeric_limits<double>::quiet_NaN()}, high{std::numeric_limits<double>::quiet_NaN()};
    };
    std::vector<FieldRange> field_ranges_;  ///< of bodies_.shown, over all frames
    std::vector<float> contacts_;
    std::vector<std::size_t> contact_counts_;
    std::vector<double> first_pose_;
    /// What one body was seen to fill.
    struct Path {
        Box start, all;
        bool is_free{false}, moves{false};
    };
    std::vector<Path> paths_;  ///< of the bodies; half-spaces have none
    Box box_first_, box_all_;  ///< of what moves, and of the water
    Box box_fixed_;            ///< of bodies that stand still
    Box box_water_;
    struct {
        double speed{0}, displacement{0}, force{0}, contact{0};  // [m/s], [m], [N], [N]
    } most_;
    std::size_t groups_done_{0};
    bool has_bodies_{false};  ///< in some frame; then one without them is left out
    double spacing_{0};       ///< [m]
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
