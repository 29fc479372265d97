// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_check.h"

#include "core/base/limits.h"
#include "core/project/project_corrections.h"
#include "core/project/project_devices.h"
#include "core/project/project_format.h"
#include "core/project/project_output.h"
#include "core/project/project_people.h"
#include "core/project/project_room.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace dewpoint::project {
namespace {

constexpr double kSmallestBox = 2.0; ///< pixels

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

/// As far as it can be told before the images are seen.
Status checkBox(const Project& project, std::size_t index, const TargetBox& target) {
  const std::string field = fmt::format("target {}.box", index + 1);
  const auto camera = static_cast<std::size_t>(target.camera);
  if (target.camera < 0 || (!project.cameras.empty() && camera >= project.cameras.size())) {
    return wrong(ErrorCode::BadValue, field + ".camera",
                 fmt::format("the project has only {} cameras", project.cameras.size()));
  }
  const ImageBox& box = target.box;
  if (target.frame < 0 || !(box.width >= kSmallestBox && box.height >= kSmallestBox) ||
      !std::isfinite(box.x + box.y + box.width + box.height)) {
    return wrong(ErrorCode::BadValue, field, "at least 2 x 2 pixels are expected");
  }
  const Eigen::Vector2d center = box.center();
  if (!project.cameras.empty()) {
    const Intrinsics& image = project.cameras[camera].camera.intrinsics;
    const bool inside = center.x() >= 0.0 && center.x() < image.width && center.y() >= 0.0 &&
                        center.y() < image.height && box.width <= image.width &&
                        box.height <= image.height;
    if (image.width > 0 && !inside) {
      return wrong(
          ErrorCode::BadValue, field,
          fmt::format("it does not lie in the image of {} x {} pixels", image.width, image.height));
    }
  }
  return {};
}

/// `prefix` of the target's fields.
Status checkColors(const Target& target, const std::string& prefix) {
  const auto named = [&](const Status& good, const std::string& place) -> Status {
    return good
               ? good
               : wrong(good.error().code, prefix + place + good.error().field, good.error().detail);
  };
  Status good = named(checkColorRange(target.color), "");
  for (std::size_t k = 0; good && k < target.otherColors.size(); ++k) {
    good = named(checkColorRange(target.otherColors[k]), fmt::format("other_color {}.", k + 1));
  }
  return good;
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
    if (auto good = checkColors(target, fmt::format("target {}.", i + 1)); !good) {
      return good;
    }
    if (target.box) {
      if (auto good = checkBox(project, i, *target.box); !good) {
        return good;
      }
    }
  }
  return {};
}

/// Each target has a filter of its own.
Status checkParticles(const Project& project) {
  constexpr const char* kKey = "particles";
  const auto declared = project.parameters.declarations();
  if (std::ranges::find(declared, kKey, &ParameterDeclaration::key) == declared.end()) {
    return {};
  }
  const double particles = project.parameters.at(kKey);
  if (particles * static_cast<double>(project.targets.size()) > limits::kMaxParticles) {
    return wrong(ErrorCode::BadValue, "parameters.particles",
                 fmt::format("{:.0f} for each of {} targets; at most {:.0f} in all are possible",
                             particles, project.targets.size(), limits::kMaxParticles));
  }
  return {};
}

/// Of a camera whose images will say what size they are: methods that follow boxes need no more.
bool isBare(const Project& project, const Intrinsics& intrinsics) {
  return !methodFamily(project.method).needsCalibration && intrinsics.width == 0 &&
         intrinsics.height == 0;
}

Status checkCameras(const Project& project) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < project.cameras.size(); ++i) {
    const Camera& camera = project.cameras[i].camera;
    if (auto good = checkName(names, "camera", i, camera.name); !good) {
      return good;
    }
    const Intrinsics& intrinsics = camera.intrinsics;
    const bool isComplete =
        isBare(project, intrinsics) ||
        (intrinsics.width > 0 && intrinsics.height > 0 && intrinsics.focalX > 0.0 &&
         intrinsics.focalY > 0.0 && camera.cameraFromWorld.matrix().allFinite());
    if (!isComplete) {
      return wrong(ErrorCode::BadValue, fmt::format("camera {}.calibration", i + 1),
                   "a positive size and focal length, and a finite pose are expected");
    }
    if (!(std::abs(project.cameras[i].delay) <= kMaxDelay)) {
      return wrong(ErrorCode::BadValue, fmt::format("camera {}.late_by", i + 1),
                   fmt::format("{} to {} s are expected", -kMaxDelay, kMaxDelay));
    }
    if (const auto good = checkDeviceSettings(project.cameras[i].device); !good) {
      return wrong(good.error().code, fmt::format("camera {}.{}", i + 1, good.error().field),
                   good.error().detail);
    }
  }
  return {};
}

} // namespace

Status checkProject(const Project& project) {
  if (project.cameras.empty() && project.scene.empty()) {
    return wrong(ErrorCode::MissingKey, "camera", "at least one [[camera]] or a scene is needed");
  }
  if (!project.scene.empty() && !project.cameras.empty() &&
      project.cameras.front().source != SourceKind::Simulation) {
    return wrong(ErrorCode::BadValue, "scene", "a simulated scene has its own cameras");
  }
  if (auto good = checkTargets(project); !good) {
    return good;
  }
  if (auto good = checkCameras(project); !good) {
    return good;
  }
  return checkParticles(project)
      .and_then([&] { return checkRoom(project); })
      .and_then([&] { return checkPeople(project); })
      .and_then([&] { return checkCorrections(project); })
      .and_then([&] { return checkOutput(project.output); });
}

Status checkMethodTargets(const Project& project) {
  const MethodFamily family = methodFamily(project.method);
  if (family.lacksTargets(project.targets)) {
    return wrong(ErrorCode::MissingKey, "target", family.noTargetsText(project.method));
  }
  return {};
}

} // namespace dewpoint::project
