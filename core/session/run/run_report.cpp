// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/run_report.h"

#include <nlohmann/json.hpp>

namespace dewpoint::session {
namespace {

constexpr double kMicroseconds = 1e6; ///< in a second
constexpr double kMilliseconds = 1e3;

} // namespace

std::string runReport(const Project& project, const RunFigures& figures) {
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
  json["milliseconds_per_frame"] = {{"p50", kMilliseconds * figures.latency.quantile(0.5)},
                                    {"p99", kMilliseconds * figures.latency.quantile(0.99)},
                                    {"p99.9", kMilliseconds * figures.latency.quantile(0.999)},
                                    {"max", kMilliseconds * figures.latency.longest()}};
  json["dropped_frames"] = figures.droppedFrames;
  for (const auto& declaration : project.parameters.declarations()) {
    json["parameters"][declaration.key] = project.parameters.at(declaration.key);
  }
  if (project.volumeOfInterest) {
    const auto& [min, max] = *project.volumeOfInterest;
    json["volume_of_interest"] = {{"min", {min.x(), min.y(), min.z()}},
                                  {"max", {max.x(), max.y(), max.z()}}};
  }
  json["notices"] = figures.notices;
  return json.dump(2) + "\n";
}

} // namespace dewpoint::session
