// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/project_room.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace dewpoint {
namespace {

constexpr double kLargestRadius = 1000.0; ///< metres

tl::unexpected<Error> wrong(ErrorCode code, std::string field, std::string detail) {
  return tl::make_unexpected(Error{code, "", std::move(field), std::move(detail)});
}

/// Every name is there, and none is used twice.
Status checkName(std::set<std::string>& seen, const char* key, std::size_t index,
                 const std::string& name) {
  if (name.empty()) {
    return wrong(ErrorCode::BadValue, fmt::format("{} {}.name", key, index + 1),
                 "the name is empty");
  }
  if (!seen.insert(name).second) {
    return wrong(ErrorCode::BadValue, key, "the name '" + name + "' is used twice");
  }
  return {};
}

Status checkTargets(const Project& project) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < project.targets.size(); ++i) {
    const Target& target = project.targets[i];
    if (auto good = checkName(names, "target", i, target.name); !good) {
      return good;
    }
    if (!(target.radius >= 0.0 && target.radius <= kLargestRadius)) {
      return wrong(ErrorCode::BadValue, fmt::format("target {}.radius", i + 1),
                   fmt::format("0 to {} m are expected", kLargestRadius));
    }
    if (auto good = checkColorRange(target.color); !good) {
      return wrong(good.error().code, fmt::format("target {}.{}", i + 1, good.error().field),
                   good.error().detail);
    }
  }
  return {};
}

Status checkCameras(const Project& project) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < project.cameras.size(); ++i) {
    const Camera& camera = project.cameras[i].camera;
    if (auto good = checkName(names, "camera", i, camera.name); !good) {
      return good;
    }
    const Intrinsics& intrinsics = camera.intrinsics;
    if (intrinsics.width <= 0 || intrinsics.height <= 0 || !(intrinsics.focalX > 0.0) ||
        !(intrinsics.focalY > 0.0) || !camera.cameraFromWorld.matrix().allFinite()) {
      return wrong(ErrorCode::BadValue, fmt::format("camera {}.calibration", i + 1),
                   "a positive size and focal length, and a finite pose are expected");
    }
  }
  return {};
}

} // namespace

Status checkProject(const Project& project) {
  if (project.cameras.empty() && project.scene.empty()) {
    return wrong(ErrorCode::MissingKey, "camera", "at least one [[camera]] is needed, or a scene");
  }
  if (!project.scene.empty() && !project.cameras.empty() &&
      project.cameras.front().source != SourceKind::Simulation) {
    return wrong(ErrorCode::BadValue, "scene", "a simulated scene brings its own cameras");
  }
  if (auto good = checkTargets(project); !good) {
    return good;
  }
  if (auto good = checkCameras(project); !good) {
    return good;
  }
  return checkRoom(project);
}

} // namespace dewpoint
