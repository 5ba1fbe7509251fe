// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "command_line_parts.hpp"
#include "commands.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/archive/archive_run.hpp"
#include "riprap/view/damage/damage_report.hpp"
#include "riprap/view/page.hpp"
#include "riprap/view/render.hpp"
#include "riprap/view/sea/sea_report.hpp"
#include "riprap/view/surface_export.hpp"

namespace riprap {

namespace {

/// Refuses an output file whose extension names another format than the one written.
void require_extension(const std::filesystem::path& file, std::initializer_list<const char*> allowed) {
    if (file.empty() || std::find(allowed.begin(), allowed.end(), file.extension()) != allowed.end()) {
        return;
    }
    std::string names;
    for (const char* extension : allowed) {
        names += fmt::format("{}{}", names.empty() ? "" : " or ", extension);
    }
    throw CLI::ValidationError("--out", fmt::format("'{}' must end in {}", file.string(), names));
}

void add_view(CLI::App& app, Action& action) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command = app.add_subcommand("view", "Write one page that shows a run in a browser, offline");
    command->footer("Example:\n  riprap view runs/fine runs/coarse --out compare.html");
    command->add_option("RUN", options->folders, "The run folder; two to nine are shown side by side under one clock")
        ->required()
        ->expected(1, static_cast<int>(view::most_compared));
    CLI::Option* out =
        command->add_option("--out", options->out, "The page (default: RUN/index.html, of several runs compare.html)");
    CLI::Option* serve =
        command->add_flag("--serve", options->is_served,
                          "Serve the page to browsers on this machine instead of writing it, until Ctrl-C");
    serve->excludes(out);
    command->add_option("--port", options->port, "With --serve (default: a free one)")
        ->check(CLI::Range(1, 65535))
        ->needs(serve);
    command->add_option("--budget", options->budget_mb, "Size of the page [MB]; water is rounded to fit (default: 60)")
        ->check(CLI::Range(1.0, 2000.0));
    command->callback([&action, options] {
        require_extension(options->out, {".html"});
        action = [options] { return view_run(*options); };
    });
}

void read_size(const std::string& text, view::RenderOptions& options) {
    int end = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &options.width, &options.height, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || options.width < 64 || options.height < 64 ||
        options.width > 8192 || options.height > 8192) {
        throw CLI::ValidationError("--size", "WIDTHxHEIGHT in pixels, 64 to 8192 each, such as 1280x720");
    }
}

void add_render(CLI::App& app, Action& action) {
    auto options = std::make_shared<view::RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Draw a picture or a movie of a run, with Chromium");
    command->footer("Example:\n  riprap render runs/dam --movie --length 12 --camera front --camera-to corner");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command->add_option("--out", options->out,
                        "The picture, PNG, or the movie, MP4 (default: RUN/picture.png or RUN/movie.mp4)");
    CLI::Option* frame =
        command->add_option("--frame", options->frame, "Index of a frame, from 0; -1 is the last (default)");
    CLI::Option* time = command->add_option("--time", options->time, "The frame nearest to this time [s]");
    frame->excludes(time);
    command->add_flag("--movie", options->is_movie, "All frames, as MP4 where ffmpeg is installed, else as pictures")
        ->excludes(frame)
        ->excludes(time);
    command->add_option_function<std::string>(
        "--size", [options](const std::string& text) { read_size(text, *options); }, "WIDTHxHEIGHT [pixels]");
    command->add_option("--camera", options->camera,
                        "corner, front, side, top, or the address of a page as seen in the browser (#...)");
    command
        ->add_option("--camera-to", options->camera_to,
                     "View at the end of a movie, as --camera; repeat the option for stops on the way")
        ->allow_extra_args(false);
    command->add_option("--fps", options->frames_per_second, "Pictures of a movie per second (default: 25)")
        ->check(CLI::Range(1, 120));
    command
        ->add_option("--length", options->movie_seconds,
                     "How long a movie plays [s] (default: every frame once); frames are repeated or left out")
        ->check(CLI::Range(0.1, 3600.0));
    command->add_option("--from", options->from, "Start of a movie [s of the run]");
    command->add_option("--to", options->to, "End of a movie [s of the run]");
    command->add_option("--water", options->water, "Water as a surface, or as particles of this colour")
        ->check(CLI::IsMember({"surface", "pressure", "speed", "none"}));
    command->add_option("--blocks", options->blocks,
                        "Colour of the blocks: material, speed, displacement, force, or a field of the method "
                        "(von_mises of DDA)");
    command->add_flag("--contacts", options->shows_contacts, "Draw contact forces");
    command->add_flag("--page", options->shows_page, "The whole page, with its plots");
    command->add_option("--theme", options->theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
    command->callback([&action, options] {
        require_extension(options->out, {options->is_movie ? ".mp4" : ".png"});
        action = [options] { return print_render(*options); };
    });
}

void add_surface(CLI::App& app, Action& action) {
    auto options = std::make_shared<view::SurfaceOptions>();
    CLI::App* command =
        app.add_subcommand("surface", "Write the surface of the water and the blocks for ParaView, Blender and others");
    command->footer("Example:\n  riprap surface runs/dam --time 0.4 --format glb");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command->add_option("--out", options->out, "A folder (default: RUN/surface)");
    CLI::Option* frame =
        command->add_option("--frame", options->frame, "Index of a frame, from 0; -1 is the last (default: all)");
    command->add_option("--time", options->time, "The frame nearest to this time [s]")->excludes(frame);
    auto formats = std::make_shared<std::vector<std::string>>();
    command->add_option("--format", *formats, "vtp, ply, glb (glTF), separated by commas (default: all three)")
        ->delimiter(',')
        ->check(CLI::IsMember({"vtp", "ply", "glb"}));
    command->callback([&action, options, formats] {
        if (!formats->empty()) {
            options->formats = {formats->begin(), formats->end()};
        }
        action = [options] {
            fmt::print("{}\n", view::export_surfaces(*options));
            return 0;
        };
    });
}

/// Reads the size of a chart [mm].
void read_figure_size(const std::string& text, PlotOptions& options) {
    constexpr double least = 50, most = 1000;
    char* end = nullptr;
    const double width = std::strtod(text.c_str(), &end), height = *end == 'x' ? std::strtod(end + 1, &end) : 0;
    if (*end != '\0' || !(width >= least && width <= most && height >= least && height <= most)) {
        throw CLI::ValidationError("--size", "WIDTHxHEIGHT in millimetres, 50 to 1000 each, such as 160x90");
    }
    options.width = width;
    options.height = height;
}

void add_plot(CLI::App& app, Action& action) {
    auto options = std::make_shared<PlotOptions>();
    CLI::App* command = app.add_subcommand("plot", "Draw curves over time from the tables of a run");
    command->footer("Example:\n  riprap plot runs/dam --column solid.kinetic --column level --out dam.png");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command
        ->add_option("--column", options->columns,
                     "Column of probes.csv or ledger.csv: solid.kinetic, B1.position.x; may be repeated (default: "
                     "gauges and bodies, "
                     "else energies)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--out", options->out, "The plot, SVG, PNG or PDF (default: RUN/plot.svg)");
    command
        ->add_option_function<std::string>(
            "--size", [options](const std::string& text) { read_figure_size(text, *options); },
            "WIDTHxHEIGHT of each chart [mm]; letters keep their size")
        ->type_name("WxH");
    command->add_option("--dpi", options->dpi, "Pixels in an inch of a PNG (default: 192)")
        ->check(CLI::Range(48.0, 1200.0));
    command->add_option("--title", options->title, "Instead of the title of the case");
    command->add_option("--x-label", options->x_label, "Instead of 'time [s]'");
    command->add_option("--y-label", options->y_label, "Instead of the name and unit of the columns");
    command->callback([&action, options] {
        require_extension(options->out, {".svg", ".png", ".pdf"});
        action = [options] { return plot_run(*options); };
    });
}

/// Reads KEY=VALUE of an input of a formula.
void read_input(const std::string& text, wave::FormulaValues& given) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const char* value = equals == std::string::npos ? "" : text.c_str() + equals + 1;
    const double number = std::strtod(value, &end);
    if (*value == '\0' || *end != '\0') {
        throw CLI::ValidationError("--with", fmt::format("'{}' is not KEY=NUMBER", text));
    }
    given[text.substr(0, equals)] = number;
}

struct WaveWords {
    std::vector<std::filesystem::path> folders;
    view::SeaRequest request;
    std::vector<std::string> inputs;
    std::vector<double> way;
    std::filesystem::path out;
    bool as_json{false};
};

/// Adds what is asked of a sea.
void add_sea_options(CLI::App& command, WaveWords& words) {
    command.add_option("--parts", words.request.parts, "Of a sea: parts of the record, for the bands (default: 5)")
        ->check(CLI::Range(1, 100));
    command
        .add_option("--force", words.request.forces,
                    "Of a sea: column of probes.csv whose largest values are wanted; may be repeated")
        ->type_name("COLUMN")
        ->allow_extra_args(false);
    command
        .add_option("--with", words.inputs,
                    "Of a sea: an input of the formulas, as cot_slope=1.5; may be repeated (docs/reference/waves.md)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_option("--out", words.out, "Of a sea: folder for sea.csv, sea_spectrum.csv, sea_volumes.csv, sea.svg");
}

void add_waves(CLI::App& app, Action& action) {
    auto words = std::make_shared<WaveWords>();
    view::WaveRequest& request = words->request.waves;
    CLI::App* command = app.add_subcommand(
        "waves", "Heights and periods of the waves at the gauges of a run, reflection, run-up, overtopping");
    command->footer(
        "Example:\n  riprap waves runs/wave_flume --from 10 --to 20\n"
        "  riprap waves runs/seed_1 runs/seed_2 runs/seed_3 --with cot_slope=1.5 --with freeboard=3 --out sea");
    command->add_option("RUN", words->folders, "The run folder; several, with other seeds, give narrower bands")
        ->required();
    command
        ->add_option("--gauge", request.gauges,
                     "Name of a gauge of kind level or surface; may be repeated (default: all)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--from", request.from, "Start of the analysed interval [s] (default: half of the record)");
    command->add_option("--to", request.to, "End of the analysed interval [s] (default: end of the record)");
    command->add_option("--period", request.period,
                        "Period of the regular wave to separate [s] (default: the wave maker's)");
    command->add_option("--depth", request.depth, "Depth of still water [m] (default: the wave maker's)");
    command
        ->add_option("--direction", words->way,
                     "Direction of the waves: X,Y or X,Y,Z (default: the wave maker's, or +x)")
        ->delimiter(',')
        ->expected(2, 3)
        ->type_name("VECTOR");
    command->add_flag("--json", words->as_json, "As JSON");
    add_sea_options(*command, *words);
    command->callback([&action, words] {
        const std::vector<double>& way = words->way;
        if (!way.empty()) {
            words->request.waves.direction = Vec3{way[0], way[1], way.size() > 2 ? way[2] : 0};
        }
        for (const std::string& text : words->inputs) {
            read_input(text, words->request.given);
        }
        const bool is_asked = words->folders.size() > 1 || !words->inputs.empty() || !words->request.forces.empty() ||
                              !words->out.empty();
        action = [words, is_asked] {
            end_with_reader();
            return print_waves(words->folders, words->request, is_asked, words->out, words->as_json);
        };
    });
}

struct DamageWords {
    std::filesystem::path folder, out;
    view::DamageRequest request;
    std::vector<std::string> zones;
    std::vector<double> along;
    bool as_json{false};
};

/// Reads LOW,HIGH of a zone.
std::pair<double, double> read_zone(const std::string& text) {
    double low = 0, high = 0;
    int end = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf%n", &low, &high, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || !(low < high)) {
        throw CLI::ValidationError("--zone", fmt::format("'{}' is not LOW,HIGH, two levels in metres", text));
    }
    return {low, high};
}

void add_damage(CLI::App& app, Action& action) {
    auto words = std::make_shared<DamageWords>();
    CLI::App* command =
        app.add_subcommand("damage", "Damage of an armour layer between two frames of a run: N_od and S_d by zones");
    command->footer("Example:\n  riprap damage runs/storm --units armour --zone -1.5,1.5 --out damage");
    command->add_option("RUN", words->folder, "The run folder")->required();
    command->add_option("--units", words->request.units,
                        "How the names of armour units begin (default: all bodies that are free at the start)");
    command
        ->add_option("--zone", words->zones,
                     "A range of levels to tell apart [m]; may be repeated (default: all levels only)")
        ->type_name("LOW,HIGH")
        ->allow_extra_args(false);
    command->add_option("--from", words->request.from, "Time of the frame before [s] (default: the first)");
    command->add_option("--to", words->request.to, "Time of the frame after [s] (default: the last)");
    command
        ->add_option("--width", words->request.width, "Width of the strip across the slope [m] (default: of the units)")
        ->check(CLI::PositiveNumber);
    command->add_option("--direction", words->along, "Along the slope: X,Y or X,Y,Z (default: +x)")
        ->delimiter(',')
        ->expected(2, 3)
        ->type_name("VECTOR");
    command->add_option("--out", words->out, "Folder for damage.csv, damage_units.csv, damage_profile.csv, damage.svg");
    command->add_flag("--json", words->as_json, "As JSON");
    command->callback([&action, words] {
        for (const std::string& zone : words->zones) {
            words->request.zones.push_back(read_zone(zone));
        }
        const std::vector<double>& way = words->along;
        if (!way.empty()) {
            words->request.along = Vec3{way[0], way[1], way.size() > 2 ? way[2] : 0};
        }
        action = [words] {
            end_with_reader();
            return print_damage(words->folder, words->request, words->out, words->as_json);
        };
    });
}

void add_pack(CLI::App& app, Action& action) {
    auto options = std::make_shared<view::ArchiveOptions>();
    CLI::App* command = app.add_subcommand("pack", "Make one archive of a run, to hand on: case, tables, page, origin");
    command->footer("Example:\n  riprap pack runs/dam --out dam.tar.gz");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command->add_option("--out", options->out, "The archive, NAME.tar.gz (default: RUN.tar.gz, beside it)");
    command->add_flag("--frames", options->has_frames, "With the frames for ParaView");
    command->add_flag("--checkpoint", options->has_checkpoint, "With the State, to go on from");
    command->add_flag("--force", options->force, "Replace the archive that is there");
    command->callback([&action, options] {
        if (!options->out.empty() && !options->out.string().ends_with(".tar.gz")) {
            throw CLI::ValidationError("--out", fmt::format("'{}' must end in .tar.gz", options->out.string()));
        }
        action = [options] {
            const view::Archived archive = view::archive_run(*options);
            for (const std::string& notice : archive.notices) {
                fmt::print(stderr, "riprap: {}\n", printable(notice));
            }
            fmt::print("{}: {} files, {:.2f} MB\n", printable(archive.archive.string()), archive.files,
                       1e-6 * static_cast<double>(archive.bytes));
            return 0;
        };
    });
}

}  // namespace

void add_commands_of_runs(CLI::App& app, Action& action) {
    add_view(app, action);
    add_render(app, action);
    add_surface(app, action);
    add_plot(app, action);
    add_waves(app, action);
    add_damage(app, action);
    add_pack(app, action);
}

}  // namespace riprap
