// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/sweep_page.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_points = 400;  ///< of a curve on the page

constexpr std::string_view page_before = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Study</title><style>
:root { color-scheme: light dark; --line: #8884; --soft: #666; --met: #1b7a4f; --missed: #b93a0b; }
@media (prefers-color-scheme: dark) { :root { --soft: #aaa; --met: #4cc38a; --missed: #ff8552; } }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; max-width: 1280px; margin: 0 auto; padding: 16px; }
h1 { font-size: 22px; margin: 0; overflow-wrap: anywhere; } h2 { font-size: 16px; margin: 24px 0 8px; } p { margin: 4px 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 10px; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } tr.on { background: #8882; }
.met { color: var(--met); } .missed { color: var(--missed); } .soft { color: var(--soft); }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 400px), 1fr)); gap: 14px; }
figure { margin: 0; } figcaption { font-size: 13px; } svg { width: 100%; height: auto; display: block; }
svg text { font: 11px system-ui, "DejaVu Sans", sans-serif; fill: currentColor; }
i { display: inline-block; width: 10px; height: 10px; border-radius: 2px; margin-right: 6px; }
</style></head><body><h1 id="title"></h1><p class="soft" id="about"></p>
<h2>Answers</h2><div class="scroll"><table id="table"></table></div>
<div id="more"></div>
<script type="application/json" id="data">)";

constexpr std::string_view page_after = R"page(</script><script>
const study = JSON.parse(document.getElementById("data").textContent), runs = study.runs;
const make = (tag, text = "", name = "") => { const e = document.createElement(tag); e.textContent = text; if (name) e.className = name; return e; };
const svg = (tag, attributes) => { const e = document.createElementNS("http://www.w3.org/2000/svg", tag); for (const k in attributes) e.setAttribute(k, attributes[k]); return e; };
const colour = i => `hsl(${(210 + i * 137.5) % 360} 65% 50%)`;
const shown = v => v === null || v === undefined || !isFinite(v) ? "" : v === 0 ? "0" : Math.abs(v) >= 1e5 || Math.abs(v) < 1e-4 ? v.toExponential(3).replace(/\.?0+e/, "e").replace("e+", "e") : String(+v.toPrecision(5));
const union = list => [...new Set(list)];
const keys = union(runs.flatMap(r => Object.keys(r.set))), answers = union(runs.flatMap(r => r.answers.map(a => a.name)));
const sizeOf = c => Math.max(...runs.map(r => r.columns[c]).filter(d => d).map(d => Math.max(Math.abs(d.min ?? 0), Math.abs(d.max ?? 0))));
const vectorOf = c => c.replace(/\.[xyz]$/, ""), named = union(runs.flatMap(r => Object.keys(r.columns)));
/* Components that are round-off beside the others of their vector tell nothing. */
const columns = named.filter(c => !named.some(d => d !== c && vectorOf(d) === vectorOf(c) && sizeOf(c) < 1e-9 * sizeOf(d)));
document.title = document.getElementById("title").textContent = (study.bands ? "Ensemble of " : "Study of ") + (study.title || study.case);
document.getElementById("about").textContent = `${runs.length} ${study.bands ? "members" : "runs"}, ${runs.filter(r => r.status === "finished").length} finished` + (study.set.length ? "; all with " + study.set.join(", ") : "");
const marks = runs.map(() => []);
const point = (i, on) => marks[i].forEach(e => e.classList.toggle("on", on) || (e.tagName === "path" && e.setAttribute("stroke-width", on ? 3.5 : 1.5)));
const watch = (e, i) => { marks[i].push(e); e.onmouseenter = () => point(i, true); e.onmouseleave = () => point(i, false); };
const table = document.getElementById("table"), head = table.insertRow();
const unitOf = name => { for (const r of runs) for (const a of r.answers) if (a.name === name) return a.unit; return ""; };
const reduced = answers.length ? [] : columns;
for (const h of ["run", ...keys, ...answers.map(a => `${a} [${unitOf(a)}]`), ...reduced.map(c => c + " max"), "status", "took [s]"]) head.append(make("th", h));
runs.forEach((r, i) => {
  const row = table.insertRow(); watch(row, i);
  const first = make("td"), chip = make("i"); chip.style.background = colour(i);
  const link = make(r.page ? "a" : "span", r.name); if (r.page) link.href = r.page; first.append(chip, link); row.append(first);
  for (const k of keys) row.append(make("td", r.set[k] ?? ""));
  for (const name of answers) { const a = r.answers.find(a => a.name === name); row.append(make("td", a ? shown(a.value) : "", a ? (a.verdict === "met" || a.verdict === "passed" ? "met" : a.verdict === "missed" || a.verdict === "failed" ? "missed" : "") : "")); }
  for (const c of reduced) row.append(make("td", r.columns[c] ? shown(r.columns[c].max) : ""));
  const why = r.status !== "finished" && r.reason ? ": " + r.reason.slice(0, 120) : "";
  row.append(make("td", r.status + why, r.status === "finished" ? "" : "missed"), make("td", shown(r.wall_seconds)));
});
function ticks(low, high) {
  const span = high - low, step0 = Math.pow(10, Math.floor(Math.log10(span / 4))), step = [1, 2, 5, 10].map(m => m * step0).find(s => span / s <= 5);
  const list = []; for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-12) + 1e-300; ++k) list.push(k * step); return list;
}
function bandOf(c) {
  const b = study.bands; if (!b || !b[c + ".low"]) return null;
  const rows = b.time.map((t, n) => [t, b[c + ".low"][n], b[c + ".mean"][n], b[c + ".high"][n]]).filter(r => r.every(v => v !== null && isFinite(v)));
  return rows.length > 1 ? rows : null;
}
function chart(caption, xName, series, isLine, band, envelope) {
  const good = series.map(s => ({ ...s, xy: s.xy.filter(p => isFinite(p[0]) && isFinite(p[1]) && p[0] !== null && p[1] !== null) })), all = good.flatMap(s => s.xy);
  if (!all.length) return null;
  const range = k => { let values = all.map(p => p[k]); if (k === 1 && band) values = values.concat(band); let low = Math.min(...values), high = Math.max(...values); const pad = high > low ? (k === 1 || !isLine ? 0.06 * (high - low) : 0) : Math.abs(high) * 0.1 || 1; return [low - pad, high + pad]; };
  const [x0, x1] = range(0), [y0, y1] = range(1), labels = ticks(y0, y1).map(shown), left = 16 + 6.5 * Math.max(...labels.map(l => l.length)), W = 420, H = 240, bottom = H - 34;
  const X = x => left + (x - x0) / (x1 - x0) * (W - left - 10), Y = y => bottom - (y - y0) / (y1 - y0) * (bottom - 10);
  const box = svg("svg", { viewBox: `0 0 ${W} ${H}` });
  if (band) box.append(svg("rect", { x: left, width: W - left - 10, y: Y(band[1]), height: Math.max(1, Y(band[0]) - Y(band[1])), fill: "#1f8a5b", opacity: 0.15 }));
  for (const y of ticks(y0, y1)) { box.append(svg("line", { x1: left, x2: W - 10, y1: Y(y), y2: Y(y), stroke: "#8884" })); const t = svg("text", { x: left - 6, y: Y(y) + 4, "text-anchor": "end" }); t.textContent = shown(y); box.append(t); }
  for (const x of ticks(x0, x1)) { const t = svg("text", { x: X(x), y: bottom + 15, "text-anchor": "middle" }); t.textContent = shown(x); box.append(t); }
  const name = svg("text", { x: (left + W) / 2, y: H - 4, "text-anchor": "middle" }); name.textContent = xName; box.append(name);
  if (envelope) {
    const path = list => list.map((q, k) => (k ? "L" : "M") + X(q[0]).toFixed(1) + " " + Y(q[1]).toFixed(1)).join("");
    box.append(svg("path", { d: path(envelope.map(r => [r[0], r[3]]).concat(envelope.map(r => [r[0], r[1]]).reverse())) + "Z", fill: "#4a7fd0", opacity: 0.18, "data-band": caption }));
    box.append(svg("path", { d: path(envelope.map(r => [r[0], r[2]])), fill: "none", stroke: "currentColor", "stroke-width": 2, "data-mean": caption }));
  }
  for (const s of good) {
    if (isLine) { const p = svg("path", { d: s.xy.map((q, k) => (k ? "L" : "M") + X(q[0]).toFixed(1) + " " + Y(q[1]).toFixed(1)).join(""), fill: "none", stroke: colour(s.run), "stroke-width": 1.5 }); watch(p, s.run); box.append(p); }
    else for (const q of s.xy) { const c = svg("circle", { cx: X(q[0]), cy: Y(q[1]), r: 5, fill: colour(s.run) }); const t = svg("title", {}); t.textContent = `${runs[s.run].name}: ${shown(q[1])}`; c.append(t); watch(c, s.run); box.append(c); }
  }
  const figure = make("figure"); figure.append(make("figcaption", caption), box); return figure;
}
const more = document.getElementById("more");
function section(title, charts) { const list = charts.filter(c => c); if (!list.length) return; const grid = make("div", "", "charts"); grid.append(...list); more.append(make("h2", title), grid); }
for (const k of keys) {
  if (!runs.some(r => isFinite(parseFloat(r.set[k])))) continue;
  const measured = answers.length ? answers.map(a => [a, unitOf(a), r => r.answers.find(x => x.name === a)?.value, runs.flatMap(r => r.answers.filter(x => x.name === a))[0]]) : columns.map(c => [c + " max", "", r => r.columns[c]?.max, null]);
  section("Answers over " + k, measured.map(([name, unit, of, one]) => chart(`${name}${unit ? ` [${unit}]` : ""}`, k, runs.map((r, i) => ({ run: i, xy: [[parseFloat(r.set[k]), of(r) ?? NaN]] })), false, one && isFinite(one.low) && isFinite(one.high) && one.low !== null && one.high !== null ? [one.low, one.high] : null)));
}
section("Over time", columns.map(c => chart(`${c} [${runs.find(r => r.columns[c])?.columns[c].unit ?? ""}]`, "time [s]", runs.map((r, i) => ({ run: i, xy: (r.curves?.[c] ?? []).map((y, n) => [r.curves.time[n], y]) })), true, null, bandOf(c))));
if (!study.bands && runs.length > 1) more.append(make("p", `The scenes of two to nine runs side by side: riprap view ${runs.slice(0, 2).map(r => r.name).join(" ")}, in this folder.`, "soft"));
if (study.bands) more.append(make("p", "Shaded: from the least to the largest member. Black or white line: their mean.", "soft"));
</script></body></html>
)page";

/// The curves of a run, thinned out evenly.
Json curves_of(const std::filesystem::path& file) {
    Json curves = Json::object();
    if (!std::filesystem::exists(file)) {
        return curves;
    }
    io::CsvTable table;
    try {
        table = io::read_record(file);
    } catch (const FileError&) {
        return curves;  // the status of the run says so
    }
    const std::size_t rows = table.row_count(), step = std::max<std::size_t>(1, (rows + most_points - 1) / most_points);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        Json values = Json::array();
        for (std::size_t r = 0; r < rows; r += step) {
            values.push_back(static_cast<float>(table.values[c][r]));
        }
        curves[c == 0 ? "time" : table.columns[c].name] = std::move(values);
    }
    return curves;
}

/// Title of the case, from the first run that has written its summary; empty where none has.
std::string title_of(const std::filesystem::path& folder, const Json& study) {
    constexpr std::size_t most = std::size_t{64} << 20U;
    for (const Json& run : study["runs"]) {
        const std::filesystem::path file = folder / run["name"].get<std::string>() / "summary.json";
        if (run["status"] != "unreadable" && std::filesystem::exists(file)) {
            const Json summary = Json::parse(io::read_file(file, most), nullptr, false);
            if (summary.is_object() && summary.contains("title") && summary["title"].is_string()) {
                return summary["title"].get<std::string>();
            }
        }
    }
    return "";
}

/// JSON within a script element: no "</script>" in it.
std::string for_script(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace), safe;
    for (const char c : text) {
        safe += c == '<' ? "\\u003c" : std::string(1, c);
    }
    return safe;
}

}  // namespace

namespace {

std::filesystem::path write_study_page(const std::filesystem::path& folder, const char* file, Json bands) {
    constexpr std::size_t most = std::size_t{64} << 20U;
    Json study = Json::parse(io::read_file(folder / file, most));
    study["title"] = title_of(folder, study);
    for (Json& run : study["runs"]) {
        const std::string name = run["name"].get<std::string>();
        run["curves"] = curves_of(folder / name / "probes.csv");
        run["page"] = std::filesystem::exists(folder / name / "index.html") ? name + "/index.html" : "";
    }
    if (!bands.is_null()) {
        study["bands"] = std::move(bands);
    }
    const std::filesystem::path page = folder / "index.html";
    io::write_file(page, std::string(page_before) + for_script(study) + std::string(page_after));
    return page;
}

}  // namespace

std::filesystem::path write_sweep_page(const std::filesystem::path& folder) {
    return write_study_page(folder, "sweep.json", nullptr);
}

std::filesystem::path write_ensemble_page(const std::filesystem::path& folder) {
    return write_study_page(folder, "ensemble.json", curves_of(folder / "bands.csv"));
}

}  // namespace riprap::view
