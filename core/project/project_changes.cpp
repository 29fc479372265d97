// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_changes.h"

#include <algorithm>

namespace dewpoint::project {
namespace {

bool sameSource(const ProjectCamera& a, const ProjectCamera& b) {
  return a.camera.name == b.camera.name && a.source == b.source && a.location == b.location &&
         a.rotateDegrees == b.rotateDegrees && a.isMirrored == b.isMirrored && a.crop == b.crop &&
         a.delay == b.delay && a.captureTimeFile == b.captureTimeFile &&
         a.device.identity == b.device.identity && a.device.format == b.device.format;
}

bool sameControls(const ProjectCamera& a, const ProjectCamera& b) {
  return a.device.controls == b.device.controls;
}

bool sameCalibration(const ProjectCamera& a, const ProjectCamera& b) {
  ProjectCamera same = a;
  same.backgroundImageFile = b.backgroundImageFile;
  same.calibrationRecord = b.calibrationRecord;
  same.device = b.device;
  return same == b;
}

} // namespace

ProjectChanges changesBetween(const Project& before, const Project& after) {
  ProjectChanges changes;
  changes.nameChanged = before.name != after.name;
  changes.methodChanged = before.method != after.method;
  changes.seedChanged = before.seed != after.seed;
  changes.parametersChanged = !changes.methodChanged && !(before.parameters == after.parameters);
  changes.targetsChanged = before.targets != after.targets;
  changes.boxesChanged =
      !std::ranges::equal(before.targets, after.targets, {}, &Target::box, &Target::box);
  changes.sourcesChanged = !std::ranges::equal(before.cameras, after.cameras, sameSource) ||
                           before.framesPerSecond != after.framesPerSecond ||
                           before.truthFile != after.truthFile || before.scene != after.scene;
  changes.markersChanged = before.markers != after.markers;
  changes.gridChanged = before.grid != after.grid;
  changes.volumeChanged = before.volumeOfInterest != after.volumeOfInterest;
  changes.pointsChanged = before.measuredPoints != after.measuredPoints;
  changes.personCorrectionsChanged = before.personCorrections != after.personCorrections;
  changes.correctionsChanged = before.corrections != after.corrections;
  changes.outputChanged = before.output != after.output;
  changes.recordsChanged =
      before.worldRecord != after.worldRecord ||
      !std::ranges::equal(before.cameras, after.cameras, {}, &ProjectCamera::calibrationRecord,
                          &ProjectCamera::calibrationRecord);
  changes.backgroundImagesChanged =
      !changes.sourcesChanged &&
      !std::ranges::equal(before.cameras, after.cameras, {}, &ProjectCamera::backgroundImageFile,
                          &ProjectCamera::backgroundImageFile);
  changes.controlsChanged =
      !changes.sourcesChanged && !std::ranges::equal(before.cameras, after.cameras, sameControls);
  changes.calibrationChanged = !changes.sourcesChanged &&
                               !std::ranges::equal(before.cameras, after.cameras, sameCalibration);
  return changes;
}

} // namespace dewpoint::project
