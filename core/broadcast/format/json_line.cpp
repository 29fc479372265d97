// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/broadcast/format/json_line.h"

#include "core/project/project_output.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace dewpoint::broadcast {
namespace {

std::string quotedJson(const std::string& text) {
  using nlohmann::json;
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// JSON has no word for infinity and NaN.
std::string jsonNumber(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string("null");
}

std::string jsonVector(const Eigen::Vector3d& vector) {
  return fmt::format("[{},{},{}]", jsonNumber(vector.x(), 9), jsonNumber(vector.y(), 9),
                     jsonNumber(vector.z(), 9));
}

std::string jsonVector(const std::optional<Eigen::Vector3d>& vector) {
  return vector ? jsonVector(*vector) : std::string("null");
}

std::string jsonSymmetric(const Eigen::Matrix3d& c) {
  return fmt::format("[{},{},{},{},{},{}]", jsonNumber(c(0, 0), 6), jsonNumber(c(0, 1), 6),
                     jsonNumber(c(0, 2), 6), jsonNumber(c(1, 1), 6), jsonNumber(c(1, 2), 6),
                     jsonNumber(c(2, 2), 6));
}

std::string jsonTarget(const TargetMessage& target, const RigMessage& rig) {
  std::string cameras;
  for (const int camera : target.seeingCameras) {
    cameras += (cameras.empty() ? "" : ",") +
               quotedJson(rig.cameras.at(static_cast<std::size_t>(camera)).name);
  }
  return fmt::format(R"({{"id":{},"name":{},"state":"{}","position":{},"velocity":{},)"
                     R"("covariance":{},"existence":{},"cameras":[{}]}})",
                     target.id, quotedJson(target.name), target.state, jsonVector(target.position),
                     jsonVector(target.velocity),
                     target.position ? jsonSymmetric(target.covariance) : std::string("null"),
                     jsonNumber(target.existenceProbability, 6), cameras);
}

} // namespace

std::string jsonRigLine(const RigMessage& rig) {
  std::string cameras;
  for (const CameraMessage& camera : rig.cameras) {
    cameras += fmt::format(R"({}{{"name":{},"position":{},"direction":{}}})",
                           cameras.empty() ? "" : ",", quotedJson(camera.name),
                           jsonVector(camera.position), jsonVector(camera.direction));
  }
  return fmt::format(R"({{"type":"rig","axes":"{}","unit":"{}","volume":[{},{}],)"
                     R"("cameras":[{}]}})"
                     "\n",
                     nameOf(rig.coordinates.axes), nameOf(rig.coordinates.unit),
                     jsonVector(rig.volume.min), jsonVector(rig.volume.max), cameras);
}

std::vector<std::string> jsonFrameLines(const FrameMessage& frame) {
  std::string targets;
  for (const TargetMessage& target : frame.targets) {
    targets += (targets.empty() ? "" : ",") + jsonTarget(target, *frame.rig);
  }
  return {fmt::format(R"({{"type":"frame","frame":{},"sequence":{},"time":{},"targets":[{}]}})"
                      "\n",
                      frame.frame, frame.sequenceNumber, jsonNumber(frame.time, 9), targets)};
}

} // namespace dewpoint::broadcast
