// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_changes.h"

#include <algorithm>

namespace dewpoint::project {
namespace {

bool sameSource(const ProjectCamera& a, const ProjectCamera& b) {
  return a.camera.name == b.camera.name && a.source == b.source && a.location == b.location &&
         a.rotateDegrees == b.rotateDegrees && a.mirrored == b.mirrored && a.crop == b.crop &&
         a.delay == b.delay && a.times == b.times && a.device.identity == b.device.identity &&
         a.device.format == b.device.format;
}

bool sameControls(const ProjectCamera& a, const ProjectCamera& b) {
  return a.device.controls == b.device.controls;
}

bool sameCalibration(const ProjectCamera& a, const ProjectCamera& b) {
  ProjectCamera same = a;
  same.backgroundImage = b.backgroundImage;
  same.calibrated = b.calibrated;
  same.device = b.device;
  return same == b;
}

} // namespace

ProjectChanges changesBetween(const Project& before, const Project& after) {
  ProjectChanges changes;
  changes.name = before.name != after.name;
  changes.method = before.method != after.method;
  changes.seed = before.seed != after.seed;
  changes.parameters = !changes.method && !(before.parameters == after.parameters);
  changes.targets = before.targets != after.targets;
  changes.boxes =
      !std::ranges::equal(before.targets, after.targets, {}, &Target::box, &Target::box);
  changes.sources = !std::ranges::equal(before.cameras, after.cameras, sameSource) ||
                    before.framesPerSecond != after.framesPerSecond ||
                    before.truth != after.truth || before.scene != after.scene;
  changes.markers = before.markers != after.markers;
  changes.grid = before.grid != after.grid;
  changes.volume = before.volumeOfInterest != after.volumeOfInterest;
  changes.points = before.points != after.points;
  changes.people = before.people != after.people;
  changes.corrections = before.corrections != after.corrections;
  changes.output = before.output != after.output;
  changes.records = before.calibrated != after.calibrated ||
                    !std::ranges::equal(before.cameras, after.cameras, {},
                                        &ProjectCamera::calibrated, &ProjectCamera::calibrated);
  changes.backgroundImages =
      !changes.sources &&
      !std::ranges::equal(before.cameras, after.cameras, {}, &ProjectCamera::backgroundImage,
                          &ProjectCamera::backgroundImage);
  changes.controls =
      !changes.sources && !std::ranges::equal(before.cameras, after.cameras, sameControls);
  changes.calibration =
      !changes.sources && !std::ranges::equal(before.cameras, after.cameras, sameCalibration);
  return changes;
}

} // namespace dewpoint::project
