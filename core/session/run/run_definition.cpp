// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/run_definition.h"

#include "core/project/project_rig.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/start_parameters.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <utility>

namespace dewpoint::session {
namespace {

bool isSameImage(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) {
    return false;
  }
  return a.data == b.data || a.empty() || cv::norm(a, b, cv::NORM_INF) == 0.0;
}

} // namespace

std::string volumeText(const WorldBox& volume) {
  const auto& [min, max] = volume;
  return fmt::format("{} {} {} to {} {} {} m", min.x(), min.y(), min.z(), max.x(), max.y(),
                     max.z());
}

bool areImagesEqual(const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b) {
  return std::ranges::equal(a, b, isSameImage);
}

RunDefinition RunDefinition::fromProject(const Project& project,
                                         std::vector<cv::Mat> backgroundImages) {
  RunDefinition definition;
  definition.method = project.method;
  definition.parameters = project.parameters;
  definition.targets = project.targets;
  definition.rig = std::make_shared<const CameraRig>(rigOf(project));
  definition.backgroundImages = std::move(backgroundImages);
  for (const ProjectCamera& camera : project.cameras) {
    definition.backgroundImageFiles.push_back(camera.backgroundImageFile);
  }
  definition.personCorrections = project.personCorrections;
  definition.volumeOfInterest = project.volumeOfInterest;
  definition.corrections = project.corrections;
  definition.seed = project.seed;
  definition.adaptParametersToCameras();
  return definition;
}

Project RunDefinition::appliedTo(Project project) const {
  project.method = method;
  project.parameters = parameters;
  project.targets = targets;
  project.personCorrections = personCorrections;
  project.volumeOfInterest = volumeOfInterest;
  project.corrections = corrections;
  project.seed = seed;
  for (std::size_t k = 0; k < std::min(project.cameras.size(), rig->size()); ++k) {
    project.cameras[k].camera = (*rig)[k];
    project.cameras[k].backgroundImageFile = backgroundImageFiles[k];
  }
  return project;
}

void RunDefinition::adaptParametersToCameras() {
  parameters = tracking::effectiveParameters(std::move(parameters), *rig, volumeOfInterest);
}

bool RunDefinition::operator==(const RunDefinition& other) const {
  return method == other.method && parameters == other.parameters && targets == other.targets &&
         (rig == other.rig || *rig == *other.rig) &&
         areImagesEqual(backgroundImages, other.backgroundImages) &&
         backgroundImageFiles == other.backgroundImageFiles &&
         personCorrections == other.personCorrections &&
         volumeOfInterest == other.volumeOfInterest && corrections == other.corrections &&
         seed == other.seed;
}

std::string differences(const RunDefinition& before, const RunDefinition& after) {
  std::string text;
  const auto add = [&text](const std::string& key, const auto& value) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", key, value);
  };
  const bool hasOtherMethod = before.method != after.method;
  if (hasOtherMethod) {
    add("method", after.method);
  }
  for (const auto& declaration : after.parameters.declarations()) {
    const double value = after.parameters.at(declaration.key);
    if (hasOtherMethod || before.parameters.at(declaration.key) != value) {
      add(declaration.key, value);
    }
  }
  for (std::size_t k = 0; k < std::min(before.targets.size(), after.targets.size()); ++k) {
    if (!areSameExceptShown(before.targets[k], after.targets[k])) {
      add(after.targets[k].name, after.family().describe(after.targets[k]));
    }
  }
  for (std::size_t k = 0; k < std::min(before.rig->size(), after.rig->size()); ++k) {
    if (!((*before.rig)[k] == (*after.rig)[k])) {
      add((*after.rig)[k].name, "another calibration");
    }
    if (before.backgroundImageFiles[k] != after.backgroundImageFiles[k]) {
      add((*after.rig)[k].name, "another background image");
    }
  }
  if (before.personCorrections != after.personCorrections) {
    add("people", "other corrections");
  }
  if (before.volumeOfInterest != after.volumeOfInterest) {
    add("volume_of_interest",
        after.volumeOfInterest ? volumeText(*after.volumeOfInterest) : "none");
  }
  return text;
}

} // namespace dewpoint::session
