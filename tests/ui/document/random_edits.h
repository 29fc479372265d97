// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace dewpoint::tests {

/// Two cameras and a ball.
inline Project someProject() {
  Project project;
  project.name = "some";
  project.parameters = ParameterValues(methodParameters(project.method));
  for (const char* name : {"left", "right"}) {
    ProjectCamera camera;
    camera.source = SourceKind::Video;
    camera.location = std::string("/recordings/") + name + ".mp4";
    camera.camera.name = name;
    camera.camera.intrinsics = {640, 480, 600.0, 600.0, 319.5, 239.5};
    project.cameras.push_back(camera);
  }
  project.targets.push_back({"ball", 0.02, {300.0, 340.0, 0.2, 0.9, 0.1, 0.9}});
  return project;
}

/// A stream of random choices, the same in every run.
class Choices {
public:
  explicit Choices(std::uint64_t seed) : stream_(seed, 0, 0, RandomPurpose::Simulation) {}
  double unit() { return stream_.uniform(count_++); }
  int below(int end) { return std::min(end - 1, static_cast<int>(unit() * end)); }

private:
  RandomStream stream_;
  std::uint32_t count_ = 0;
};

/// One random edit of any kind a person can make; some are refused, some change nothing.
inline void editAnything(Document& document, Choices& choices) {
  const Project& now = document.project();
  const int kind = choices.below(14);
  const double value = choices.unit();
  const int which = choices.below(5);
  switch (kind) {
  case 0:
    document.setMethod(which < 1   ? "histogram"
                       : which < 2 ? "sugandi"
                       : which < 3 ? "barrera"
                                   : "dewpoint");
    return;
  case 1:
  case 2:
  case 3: {
    const auto all = now.parameters.declarations();
    const auto& one = all[static_cast<std::size_t>(choices.below(static_cast<int>(all.size())))];
    (void)document.setParameter(one.key, one.minimum + std::floor(value * 8.0) / 8.0 *
                                                           (one.maximum - one.minimum));
    return;
  }
  case 4:
    document.endStepMerging();
    return;
  default:
    break;
  }
  (void)document.edit(
      QStringLiteral("Edit"),
      [&](Project& project) {
        auto& targets = project.targets;
        const auto target = targets.empty() ? 0 : static_cast<std::size_t>(which) % targets.size();
        switch (kind) {
        case 5:
          targets.push_back({"target " + std::to_string(choices.below(9)), value, {}});
          targets.back().color = {10.0, 20.0 + 100.0 * value, 0.0, 1.0, 0.0, 1.0};
          break;
        case 6:
          if (!targets.empty()) {
            targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(target));
          }
          break;
        case 7:
          if (!targets.empty()) {
            targets[target].color.hueMin = 359.0 * value;
          }
          break;
        case 8:
          if (!targets.empty()) {
            targets[target].name = "renamed " + std::to_string(which);
          }
          break;
        case 9:
          project.cameras[static_cast<std::size_t>(which % 2)].camera.cameraFromWorld.translate(
              Eigen::Vector3d(value, 0.1, -value));
          break;
        case 10:
          project.cameras[static_cast<std::size_t>(which % 2)].rotateDegrees = 90 * (which % 4);
          break;
        case 11: // a click of a method that follows boxes
          if (!targets.empty()) {
            targets[target].box = TargetBox{
                which % 2, choices.below(1000), {600.0 * value, 400.0 * value, 20.0, 30.0}};
          }
          break;
        case 12:
          if (!targets.empty()) {
            targets[target].box.reset();
          }
          break;
        default:
          project.name = "name " + std::to_string(which);
        }
      },
      kind == 7 ? "hue" : "");
}

} // namespace dewpoint::tests
