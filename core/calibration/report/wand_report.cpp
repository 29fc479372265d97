// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/report/wand_report.h"

#include "core/base/markup.h"
#include "core/base/units.h"
#include "core/calibration/manual/camera_variation.h"
#include "core/calibration/report/report_drawing.h"
#include "core/calibration/report/space_drawing.h"

#include <fmt/format.h>

#include <iterator>

namespace dewpoint::calibration {
namespace {

constexpr std::size_t kMostSticks = 300; ///< drawn in space

/// Residuals per camera, those that took part.
std::vector<std::vector<ImageResidual>> residualsOf(const WandResult& result) {
  std::vector<std::vector<ImageResidual>> all(result.cameras.size());
  const auto& seen = result.problem.observations;
  for (std::size_t k = 0; k < std::min(seen.size(), result.bundle.residuals.size()); ++k) {
    const Eigen::Vector2d predictedLessSeen = result.bundle.residuals[k];
    if (predictedLessSeen.allFinite()) {
      all[seen[k].camera].push_back({seen[k].pixel, -predictedLessSeen});
    }
  }
  return all;
}

/// A stick is drawn where it was; a ball as the way it took, cut at gaps.
std::vector<SpaceLine> wandPath(const WandResult& result) {
  std::vector<SpaceLine> lines;
  const auto& states = result.bundle.states;
  const auto& bodies = result.problem.bodies;
  const std::size_t step = std::max<std::size_t>(1, states.size() / kMostSticks);
  double last = -1e9;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const BundleState& state = states[k];
    if (!state.isPositionKnown || state.body >= bodies.size()) {
      continue;
    }
    if (bodies[state.body].kind == BundleBody::Kind::Stick) {
      if (k % step == 0) {
        lines.push_back({"board", {state.ends[0], state.ends[1]}});
      }
      continue;
    }
    if (lines.empty() || state.time - last > result.problem.maxStateGapSeconds) {
      lines.push_back({"board", {}});
    }
    lines.back().points.push_back(state.ends[0]);
    last = state.time;
  }
  return lines;
}

void addStatistics(std::string& html, const WandReport& report) {
  const WandResult& result = report.result;
  html += "<table><tr><th>camera</th><th>views</th><th>dropped</th><th>rms px</th>"
          "<th>median px</th><th>moved cm</th><th>rotated</th>";
  html += report.hasTimeOffsets ? "<th>delay ms</th></tr>\n" : "</tr>\n";
  auto out = std::back_inserter(html);
  for (std::size_t c = 0; c < result.cameras.size(); ++c) {
    const Camera& camera = result.cameras[c];
    const PoseShift shift = poseShift(report.initialRig.at(c), camera);
    const auto pixelsOf = [&](double pixels) {
      return result.usedViewCounts[c] > 0 ? fmt::format("{:.3f}", pixels) : "none";
    };
    fmt::format_to(out,
                   "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
                   "<td>{:.2f}</td><td>{:.2f}°</td>",
                   htmlEscaped(camera.name), result.usedViewCounts[c], result.droppedViewCounts[c],
                   pixelsOf(result.bundle.cameraRmsPx.at(c)),
                   pixelsOf(result.cameraMedianResidualPx[c]), inCentimeters(shift.meters),
                   inDegrees(shift.radians));
    if (report.hasTimeOffsets) {
      fmt::format_to(out, "<td>{:.2f}</td>", inMilliseconds(-result.timeOffsets[c]) + 0.0);
    }
    html += "</tr>\n";
  }
  html += "</table>\n";
}

void addCamera(std::string& html, const Camera& camera, const std::vector<ImageResidual>& residuals,
               const BoardCoverage& coverage) {
  fmt::format_to(
      std::back_inserter(html),
      "<h2>{}</h2>\n<h3>Residuals</h3><p>Arrows from the projected to the detected positions of "
      "the ball.</p>\n",
      htmlEscaped(camera.name));
  html += residualDrawing(camera.intrinsics, residuals);
  html += "<h3>Coverage</h3><p>Detections of balls in each part of the image.</p>\n";
  html += coverageDrawing(
      camera.intrinsics, coverage,
      {fmt::format("{:.0f} % of the image", inPercent(coverage.coveredFraction()))});
}

} // namespace

std::string htmlText(const WandReport& report) {
  const WandResult& result = report.result;
  const std::string title =
      fmt::format("Poses of {} cameras, calibrated with a wand", result.cameras.size());
  std::string html = htmlHead(title);
  html += fmt::format("<h1>{}</h1>\n<p><strong>{}</strong></p>\n", htmlEscaped(title),
                      htmlEscaped(report.accuracyText));
  for (const DetectedFault& fault : result.faults) {
    html += fmt::format("<p class=\"notice\">{}</p>\n", htmlEscaped(fault.sentence));
  }
  for (const std::string& notice : report.notices) {
    html += fmt::format("<p class=\"notice\">{}</p>\n", htmlEscaped(notice));
  }
  addStatistics(html, report);
  html += "<h2>In space</h2>\n" +
          spaceDrawing(result.cameras, wandPath(result), "cameras and the wand");
  const auto residuals = residualsOf(result);
  for (std::size_t c = 0; c < result.cameras.size(); ++c) {
    addCamera(html, result.cameras[c], residuals[c], report.coverage.at(c));
  }
  return html + kPageEnd;
}

} // namespace dewpoint::calibration
