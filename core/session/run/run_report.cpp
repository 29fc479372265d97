// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/run_report.h"

#include "core/base/units.h"
#include "core/project/project_rig.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>

namespace dewpoint::session {
namespace {

constexpr double kMicroseconds = 1e6; ///< in a second
constexpr double kPartsPerMillion = 1e6;

/// Nothing where the target or camera has just been removed.
template <class Named>
std::string nameAt(const std::vector<Named>& all, int index, std::string Named::*name) {
  const auto k = static_cast<std::size_t>(index);
  return k < all.size() ? all[k].*name : std::string();
}

/// A correction of a position; `sigma` are the standard deviations along the axes.
nlohmann::ordered_json correctionJson(const PositionCorrection& correction,
                                      const Project& project) {
  const Eigen::Vector3d& p = correction.position;
  const Eigen::Vector3d s = correction.covariance.diagonal().cwiseSqrt();
  const CameraRig rig = rigOf(project);
  nlohmann::ordered_json json;
  json["target"] = nameAt(project.targets, correction.target, &Target::name);
  json["frame"] = correction.frame;
  json["position"] = {p.x(), p.y(), p.z()};
  json["sigma"] = {s.x(), s.y(), s.z()};
  if (correction.trackedFrom) {
    json["tracked_from"] = *correction.trackedFrom;
    return json;
  }
  json["clicks"] = nlohmann::ordered_json::array();
  for (const PointClick& click : correction.clicks) {
    nlohmann::ordered_json& one = json["clicks"].emplace_back();
    one["camera"] = nameAt(rig, click.camera, &Camera::name);
    one["pixel"] = {click.pixel.x(), click.pixel.y()};
  }
  return json;
}

/// What is known of the times of the cameras, relative to the first one. Nothing where nothing is
/// estimated.
nlohmann::ordered_json clocksJson(const std::vector<ClockEstimate>& clocks,
                                  const Project& project) {
  const CameraRig rig = rigOf(project);
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 1; k < std::min(clocks.size(), rig.size()); ++k) {
    if (clocks[k].delaySigma > 0.0) {
      json.push_back({{"camera", rig[k].name},
                      {"relative_to", rig[0].name},
                      {"delay_milliseconds", inMilliseconds(clocks[k].delay)},
                      {"delay_sigma_milliseconds", inMilliseconds(clocks[k].delaySigma)},
                      {"drift_ppm", kPartsPerMillion * clocks[k].drift},
                      {"drift_sigma_ppm", kPartsPerMillion * clocks[k].driftSigma}});
    }
  }
  return json;
}

} // namespace

std::string runReport(const Project& project, const RunStatistics& figures) {
  nlohmann::ordered_json json;
  json["version"] = DEWPOINT_VERSION;
  json["project"] = project.name;
  json["method"] = project.method;
  json["seed"] = project.seed;
  json["threads"] = figures.threads;
  json["finished"] = figures.finished;
  json["frames"] = figures.frames;
  json["seconds"] = figures.seconds;
  json["frames_per_second"] =
      figures.seconds > 0.0 ? static_cast<double>(figures.frames) / figures.seconds : 0.0;
  json["iterations"] = figures.iterations.count();
  json["microseconds_per_iteration"] = {{"p50", kMicroseconds * figures.iterations.quantile(0.5)},
                                        {"p99", kMicroseconds * figures.iterations.quantile(0.99)}};
  json["milliseconds_per_frame"] = {{"p50", inMilliseconds(figures.latency.quantile(0.5))},
                                    {"p99", inMilliseconds(figures.latency.quantile(0.99))},
                                    {"p99.9", inMilliseconds(figures.latency.quantile(0.999))},
                                    {"max", inMilliseconds(figures.latency.longest())}};
  json["dropped_frames"] = figures.droppedFrames;
  json["clocks"] = clocksJson(figures.clocks, project);
  for (const auto& declaration : project.parameters.declarations()) {
    json["parameters"][declaration.key] = project.parameters.at(declaration.key);
  }
  if (project.volumeOfInterest) {
    const auto& [min, max] = *project.volumeOfInterest;
    json["volume_of_interest"] = {{"min", {min.x(), min.y(), min.z()}},
                                  {"max", {max.x(), max.y(), max.z()}}};
  }
  for (const PositionCorrection& correction : project.corrections) {
    json["corrections"].push_back(correctionJson(correction, project));
  }
  json["notices"] = figures.notices;
  return json.dump(2) + "\n";
}

} // namespace dewpoint::session
