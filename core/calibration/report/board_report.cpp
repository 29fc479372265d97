// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/board_report.h"

#include "core/base/markup.h"
#include "core/base/uncertainty_text.h"
#include "core/base/units.h"
#include "core/calibration/report/report_drawing.h"
#include "core/calibration/report/space_drawing.h"

#include <fmt/format.h>

#include <iterator>

namespace dewpoint::calibration {
namespace {

void addParameters(std::string& html, const BoardReport::CameraPart& camera) {
  if (camera.parameters.empty()) {
    return;
  }
  html += "<table><tr><th>parameter</th><th>value</th><th>standard deviation</th></tr>\n";
  for (const EstimatedParameter& parameter : camera.parameters) {
    html += fmt::format("<tr><td>{}</td><td>{:.6g}</td><td>{}</td></tr>\n", parameter.name,
                        parameter.value, twoSignificantDigitsText(parameter.sigma));
  }
  html += "</table>\n";
}

std::vector<ImageResidual> residualsOf(const BoardReport::CameraPart& camera) {
  std::vector<ImageResidual> all;
  for (const ViewFit& view : camera.views) {
    for (std::size_t k = 0; view.isUsed && k < view.residuals.size(); ++k) {
      all.push_back({view.pixels[k], view.residuals[k]});
    }
  }
  return all;
}

std::vector<std::string> tiltCounts(const BoardCoverage& coverage) {
  const char* names[] = {"flat", "left near", "right near", "top near", "bottom near"};
  std::vector<std::string> notes;
  notes.reserve(std::size(names));
  for (int k = 0; k < BoardCoverage::kTiltCount; ++k) {
    notes.push_back(
        fmt::format("{}: {}", names[k], coverage.tiltCounts[static_cast<std::size_t>(k)]));
  }
  return notes;
}

std::vector<SpaceLine> outlines(const BoardReport& report) {
  std::vector<SpaceLine> lines;
  const BoardDescription& board = report.board;
  const int columns = board.cornerColumns();
  const int count = board.cornerCount();
  for (const BoardPose& place : report.boardPoses) {
    SpaceLine& outline = lines.emplace_back(SpaceLine{"board", {}});
    for (const int id : {0, columns - 1, count - 1, count - columns, 0}) {
      outline.points.push_back(place.worldFromBoard * board.corner(id));
    }
  }
  return lines;
}

void addCamera(std::string& html, const BoardReport::CameraPart& camera) {
  std::size_t used = 0;
  std::size_t corners = 0;
  for (const ViewFit& view : camera.views) {
    used += view.isUsed ? 1 : 0;
    corners += view.isUsed ? view.ids.size() : 0;
  }
  if (used == 0) {
    html += fmt::format("<h2>{}</h2>\n<p>It {} and keeps its calibration.</p>\n",
                        htmlEscaped(camera.name),
                        camera.views.empty() ? "never saw the board" : "fits in none of its views");
    return;
  }
  auto out = std::back_inserter(html);
  fmt::format_to(out,
                 "<h2>{}</h2>\n<p>rms {:.4f} px over {} corners in {} of {} images; corners in "
                 "{:.0f} % of the image",
                 htmlEscaped(camera.name), camera.rmsPx, corners, used, camera.views.size(),
                 inPercent(camera.coverage.coveredFraction()));
  if (camera.projectionSigmaPx) {
    fmt::format_to(
        out, "; a line of sight is accurate to {:.2f} px (1 sigma) in the worst part of the image",
        *camera.projectionSigmaPx);
  }
  if (camera.centerSigma && *camera.centerSigma > 0.0) {
    fmt::format_to(
        out, "; position ±{:.2f} mm, direction ±{:.3f}° relative to the first camera (1 sigma)",
        inMillimeters(*camera.centerSigma), inDegrees(*camera.rotationSigma));
  }
  html += ".</p>\n";
  addParameters(html, camera);
  html +=
      "<h3>Residuals</h3><p>Arrows from the projected to the measured position of each "
      "corner.</p>\n" +
      residualDrawing(camera.camera.intrinsics, residualsOf(camera)) +
      "<h3>Coverage</h3><p>Corners seen in each part of the image, and images at each tilt.</p>\n" +
      coverageDrawing(camera.camera.intrinsics, camera.coverage, tiltCounts(camera.coverage)) +
      "<h3>Pictures</h3>\n" + viewErrorDrawing(camera.views);
}

void addReport(std::string& html, const BoardReport& report) {
  html += fmt::format("<h1>{}</h1>\n<p>Board: <code>{}</code></p>\n", htmlEscaped(report.title),
                      htmlEscaped(boardText(report.board)));
  if (!report.accuracyText.empty()) {
    html += fmt::format("<p><b>{}</b></p>\n", htmlEscaped(report.accuracyText));
  }
  for (const std::string& notice : report.notices) {
    html += fmt::format("<p class=\"notice\">{}.</p>\n", htmlEscaped(notice));
  }
  if (!report.boardPoses.empty()) {
    CameraRig rig;
    for (const auto& part : report.cameras) {
      rig.push_back(part.camera);
      rig.back().name = part.name;
    }
    html += "<h2>In space</h2>\n" + spaceDrawing(rig, outlines(report), "cameras and boards");
  }
  for (const auto& camera : report.cameras) {
    addCamera(html, camera);
  }
}

} // namespace

BoardReport::CameraPart reportPartOf(const std::string& name, const IntrinsicsResult& result) {
  BoardReport::CameraPart part;
  part.name = name;
  part.camera = result.camera;
  part.rmsPx = result.rmsPx;
  part.coverage = result.coverage;
  part.views = result.views;
  part.parameters = result.parameters;
  part.projectionSigmaPx = result.maxProjectionSigmaPx;
  return part;
}

BoardReport reportOf(const BoardDescription& board, const ExtrinsicsResult& result) {
  BoardReport report;
  report.title = fmt::format("Poses of {} cameras from a board", result.cameras.size());
  report.board = board;
  report.boardPoses = result.boardPoses;
  report.notices = result.notices;
  for (std::size_t k = 0; k < result.cameras.size(); ++k) {
    const CameraFit& fit = result.cameraFits[k];
    BoardReport::CameraPart part;
    part.name = result.cameras[k].name;
    part.camera = result.cameras[k];
    part.rmsPx = fit.rmsPx;
    part.coverage = fit.coverage;
    part.views = fit.views;
    part.centerSigma = fit.centerSigma;
    part.rotationSigma = fit.rotationSigma;
    report.cameras.push_back(std::move(part));
  }
  return report;
}

std::string htmlText(const BoardReport& report) {
  return htmlText(std::vector{report});
}

std::string htmlText(const std::vector<BoardReport>& reports) {
  std::string html = htmlHead(reports.front().title);
  for (const BoardReport& report : reports) {
    addReport(html, report);
  }
  return html + kPageEnd;
}

} // namespace dewpoint::calibration
