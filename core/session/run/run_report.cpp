// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/run_report.h"

#include "core/base/units.h"
#include "core/project/project_rig.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

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
                      {"delay_milliseconds", inMilliseconds(clocks[k].delaySeconds)},
                      {"delay_sigma_milliseconds", inMilliseconds(clocks[k].delaySigma)},
                      {"drift_ppm", kPartsPerMillion * clocks[k].drift},
                      {"drift_sigma_ppm", kPartsPerMillion * clocks[k].driftSigma}});
    }
  }
  return json;
}

/// Median and 99th percentile in milliseconds.
nlohmann::ordered_json millisecondsJson(const Latency& latency) {
  return {{"p50", inMilliseconds(latency.median)}, {"p99", inMilliseconds(latency.p99)}};
}

/// Nothing (null) for recordings.
nlohmann::ordered_json liveLatencyJson(const LiveLatency& live) {
  nlohmann::ordered_json json;
  for (const TimeOrigin origin : {TimeOrigin::Driver, TimeOrigin::Sender, TimeOrigin::Arrival}) {
    if (const std::int64_t images = live.imageCounts[static_cast<std::size_t>(origin)];
        images > 0) {
      json["images"][timeOriginName(origin)] = images;
    }
  }
  if (json.is_null()) {
    return json;
  }
  json["capture"] = millisecondsJson(live.capture);
  json["decode"] = millisecondsJson(live.decode);
  json["wait"] = millisecondsJson(live.wait);
  json["compute"] = millisecondsJson(live.compute);
  if (live.draw.longest > 0.0) { // in the window
    json["draw"] = millisecondsJson(live.draw);
  }
  json["light_to_estimate"] = millisecondsJson(live.total);
  return json;
}

} // namespace

void NoticeLog::update(const std::vector<Error>& notices, double time) {
  std::vector<std::string> present;
  std::ranges::transform(notices, std::back_inserter(present), errorSentence);
  for (NoticePeriod& period : periods_) {
    if (period.endSeconds) {
      continue;
    }
    if (const auto still = std::ranges::find(present, period.text); still != present.end()) {
      present.erase(still);
    } else {
      period.endSeconds = time;
    }
  }
  for (std::string& text : present) {
    const bool isKnown = std::ranges::any_of(periods_, [&](const NoticePeriod& period) {
      return !period.endSeconds && period.text == text;
    });
    if (!isKnown && periods_.size() < kMaxPeriods) {
      periods_.push_back({std::move(text), time, std::nullopt});
    }
  }
}

std::string runReport(const Project& project, const RunStatistics& statistics) {
  nlohmann::ordered_json json;
  json["version"] = DEWPOINT_VERSION;
  json["project"] = project.name;
  json["method"] = project.method;
  json["seed"] = project.seed;
  json["threads"] = statistics.threadCount;
  json["finished"] = statistics.isFinished;
  json["frames"] = statistics.frameCount;
  json["seconds"] = statistics.durationSeconds;
  json["frames_per_second"] =
      statistics.durationSeconds > 0.0
          ? static_cast<double>(statistics.frameCount) / statistics.durationSeconds
          : 0.0;
  json["iterations"] = statistics.iterationDurations.count();
  json["microseconds_per_iteration"] = {
      {"p50", kMicroseconds * statistics.iterationDurations.quantile(0.5)},
      {"p99", kMicroseconds * statistics.iterationDurations.quantile(0.99)}};
  json["milliseconds_per_frame"] = {
      {"p50", inMilliseconds(statistics.frameDurations.quantile(0.5))},
      {"p99", inMilliseconds(statistics.frameDurations.quantile(0.99))},
      {"p99.9", inMilliseconds(statistics.frameDurations.quantile(0.999))},
      {"max", inMilliseconds(statistics.frameDurations.longest())}};
  if (auto live = liveLatencyJson(statistics.liveLatency.summary()); !live.is_null()) {
    json["live_milliseconds"] = std::move(live);
  }
  json["dropped_frames"] = statistics.droppedFrameCount;
  json["clocks"] = clocksJson(statistics.clockEstimates, project);
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
  json["notices"] = statistics.notices;
  for (const NoticePeriod& period : statistics.noticeLog.periods()) {
    nlohmann::ordered_json& one = json["notice_log"].emplace_back();
    one["notice"] = period.text;
    one["from"] = period.startSeconds;
    one["to"] = period.endSeconds ? nlohmann::ordered_json(*period.endSeconds)
                                  : nlohmann::ordered_json(nullptr);
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace dewpoint::session
