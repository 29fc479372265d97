// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/evaluation_text.h"

#include "core/base/units.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dewpoint::trajectory {
namespace {

std::string targetText(const Evaluation& e) {
  std::string text = fmt::format("target {}\n", e.target.empty() ? "(unnamed)" : e.target);
  text += fmt::format("  frames             {} compared, {} missing\n", e.comparedFrameCount,
                      e.missingFrameCount);
  if (e.convergenceFrameCount)
    text += fmt::format("  converged          after {} frames, then {} lost\n",
                        *e.convergenceFrameCount, e.lostFrameCount);
  else
    text += "  converged          never\n";
  text +=
      fmt::format("  error              RMSE {:.1f} mm, median {:.1f}, p95 {:.1f}, max {:.1f}\n",
                  inMillimeters(e.rmse), inMillimeters(e.medianError), inMillimeters(e.p95),
                  inMillimeters(e.maxError));
  text += fmt::format("  RMSE, all frames   {:.1f} mm\n", inMillimeters(e.rmseOfAllFrames));
  text += fmt::format("  truth inside 95 %  {:.1f} % of the frames\n",
                      inPercent(e.fractionInside95Ellipsoid));
  text +=
      fmt::format("  bias x y z         {:+.1f} {:+.1f} {:+.1f} mm\n", inMillimeters(e.bias.x()),
                  inMillimeters(e.bias.y()), inMillimeters(e.bias.z()));
  for (const CameraBias& camera : e.cameraBiases)
    text += fmt::format("  camera {:<11} along axis {:+.1f} mm (rms {:.1f}), across {:.1f} mm (rms "
                        "{:.1f})\n",
                        camera.cameraName, inMillimeters(camera.alongAxisBias),
                        inMillimeters(camera.alongAxisRms), inMillimeters(camera.acrossAxisBias),
                        inMillimeters(camera.acrossAxisRms));
  return text;
}

nlohmann::json targetJson(const Evaluation& e) {
  nlohmann::json json = {{"target", e.target},
                         {"rmse", e.rmse},
                         {"median", e.medianError},
                         {"p95", e.p95},
                         {"max", e.maxError},
                         {"rmse_all", e.rmseOfAllFrames},
                         {"inside_95", e.fractionInside95Ellipsoid},
                         {"bias", {e.bias.x(), e.bias.y(), e.bias.z()}},
                         {"frames_compared", e.comparedFrameCount},
                         {"frames_to_converge", nullptr},
                         {"lost_frames", e.lostFrameCount},
                         {"missing", e.missingFrameCount},
                         {"cameras", nlohmann::json::array()}};
  if (e.convergenceFrameCount)
    json["frames_to_converge"] = *e.convergenceFrameCount;
  for (const CameraBias& camera : e.cameraBiases)
    json["cameras"].push_back({{"name", camera.cameraName},
                               {"along_bias", camera.alongAxisBias},
                               {"across_bias", camera.acrossAxisBias},
                               {"along_rms", camera.alongAxisRms},
                               {"across_rms", camera.acrossAxisRms}});
  return json;
}

} // namespace

std::string evaluationText(const std::vector<Evaluation>& evaluations) {
  std::string text;
  for (const Evaluation& evaluation : evaluations)
    text += targetText(evaluation);
  return text;
}

nlohmann::json evaluationJson(const std::vector<Evaluation>& evaluations) {
  nlohmann::json json = {{"unit", "m"}, {"targets", nlohmann::json::array()}};
  for (const Evaluation& evaluation : evaluations)
    json["targets"].push_back(targetJson(evaluation));
  return json;
}

} // namespace dewpoint::trajectory
