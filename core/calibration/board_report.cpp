// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_report.h"

#include "core/base/markup.h"
#include "core/calibration/report_drawing.h"

#include <fmt/format.h>

#include <iterator>
#include <numbers>

namespace dewpoint {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{}</title><style>
:root {{ color-scheme: light dark; --ink: #1d2430; --paper: #fff; --line: #9aa4b2; --blue: #1f6feb;
  --red: #c8321f; --amber: #b26a00 }}
@media (prefers-color-scheme: dark) {{ :root {{ --ink: #e3e8ef; --paper: #14181f; --line: #5a6675;
  --blue: #6cb0ff; --red: #ff7b6b; --amber: #f0b048 }} }}
body {{ font: 15px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 62rem; margin: 2rem auto; padding: 0 1rem }}
svg {{ max-width: 100%; margin: .3rem 1rem .6rem 0; vertical-align: top; overflow: visible }}
svg text {{ font: 11px system-ui, sans-serif; fill: var(--ink) }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums }}
td, th {{ padding: .1rem .9rem .1rem 0; text-align: left; border-bottom: 1px solid var(--line) }}
.frame, polyline, path {{ fill: none; stroke: var(--line) }} .arrow {{ stroke: var(--blue); stroke-width: .8 }}
.cell {{ fill: var(--blue); stroke: var(--line) }} .bar {{ fill: var(--blue) }} .doubtful {{ fill: var(--amber) }}
.left {{ fill: none }} .camera {{ stroke: var(--blue); stroke-width: 1.4 }} .board {{ stroke: var(--amber) }}
.axis {{ stroke: var(--red); stroke-width: 1.6 }} .notice {{ color: var(--amber) }}
</style></head><body>
)";

void addParameters(std::string& html, const BoardReport::CameraPart& camera) {
  if (camera.parameters.empty()) {
    return;
  }
  html += "<table><tr><th>parameter</th><th>value</th><th>standard deviation</th></tr>\n";
  for (const EstimatedParameter& parameter : camera.parameters) {
    html += fmt::format("<tr><td>{}</td><td>{:.6g}</td><td>{:.2g}</td></tr>\n", parameter.name,
                        parameter.value, parameter.sigma);
  }
  html += "</table>\n";
}

void addCamera(std::string& html, const BoardReport::CameraPart& camera) {
  std::size_t used = 0;
  std::size_t corners = 0;
  for (const ViewFit& view : camera.views) {
    used += view.used ? 1 : 0;
    corners += view.used ? view.ids.size() : 0;
  }
  auto out = std::back_inserter(html);
  fmt::format_to(out,
                 "<h2>{}</h2>\n<p>rms {:.4f} px over {} corners in {} of {} pictures; corners in "
                 "{:.0f} % of the image",
                 escaped(camera.name), camera.rmsPx, corners, used, camera.views.size(),
                 100.0 * camera.coverage.imagePart());
  if (camera.projectionPx) {
    fmt::format_to(out, "; a ray is known to {:.2f} px (1 sigma) where the image is known least",
                   *camera.projectionPx);
  }
  if (camera.centerSigma && *camera.centerSigma > 0.0) {
    fmt::format_to(out, "; place ±{:.2f} mm, direction ±{:.3f}° against the first camera (1 sigma)",
                   1e3 * *camera.centerSigma, *camera.turnSigma * 180.0 / std::numbers::pi);
  }
  html += ".</p>\n";
  addParameters(html, camera);
  html += "<h3>Residuals</h3><p>From where a corner is projected to where it was measured.</p>\n" +
          residualDrawing(camera) +
          "<h3>Coverage</h3><p>Corners seen in each part of the image, "
          "and pictures at each tilt.</p>\n" +
          coverageDrawing(camera) + "<h3>Pictures</h3>\n" + errorDrawing(camera);
}

void addReport(std::string& html, const BoardReport& report) {
  html += fmt::format("<h1>{}</h1>\n<p>Board: <code>{}</code></p>\n", escaped(report.title),
                      escaped(boardText(report.board)));
  if (!report.verdict.empty()) {
    html += fmt::format("<p><b>{}</b></p>\n", escaped(report.verdict));
  }
  for (const std::string& notice : report.notices) {
    html += fmt::format("<p class=\"notice\">{}.</p>\n", escaped(notice));
  }
  if (!report.places.empty()) {
    html += "<h2>In space</h2>\n" + spaceDrawing(report);
  }
  for (const auto& camera : report.cameras) {
    addCamera(html, camera);
  }
}

} // namespace

BoardReport::CameraPart reportPart(const std::string& name, const IntrinsicsResult& result) {
  BoardReport::CameraPart part;
  part.name = name;
  part.camera = result.camera;
  part.rmsPx = result.rmsPx;
  part.coverage = result.coverage;
  part.views = result.views;
  part.parameters = result.parameters;
  part.projectionPx = result.worstProjectionPx;
  return part;
}

BoardReport reportOf(const BoardDescription& board, const ExtrinsicsResult& result) {
  BoardReport report;
  report.title = fmt::format("Poses of {} cameras from a board", result.cameras.size());
  report.board = board;
  report.places = result.places;
  report.notices = result.notices;
  for (std::size_t k = 0; k < result.cameras.size(); ++k) {
    const CameraFit& fit = result.fits[k];
    BoardReport::CameraPart part;
    part.name = result.cameras[k].name;
    part.camera = result.cameras[k];
    part.rmsPx = fit.rmsPx;
    part.coverage = fit.coverage;
    part.views = fit.views;
    part.centerSigma = fit.centerSigma;
    part.turnSigma = fit.turnSigma;
    report.cameras.push_back(std::move(part));
  }
  return report;
}

std::string htmlText(const BoardReport& report) {
  return htmlText(std::vector{report});
}

std::string htmlText(const std::vector<BoardReport>& reports) {
  std::string html = fmt::format(kHead, escaped(reports.front().title));
  for (const BoardReport& report : reports) {
    addReport(html, report);
  }
  return html + "</body></html>\n";
}

} // namespace dewpoint
