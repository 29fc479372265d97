// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/project_recording.h"

namespace dewpoint::setup {

RecordedCamera recordedCamera(const ProjectCamera& camera) {
  RecordedCamera recorded;
  recorded.name = camera.camera.name;
  recorded.kind = camera.source == SourceKind::Video ? RecordedCamera::Kind::Video
                                                     : RecordedCamera::Kind::Images;
  recorded.path = camera.location;
  recorded.rotateDegrees = camera.rotateDegrees;
  recorded.isMirrored = camera.isMirrored;
  recorded.crop = camera.crop;
  recorded.delaySeconds = camera.delay;
  recorded.timesFile = camera.captureTimeFile;
  recorded.width = camera.camera.intrinsics.width;
  recorded.height = camera.camera.intrinsics.height;
  return recorded;
}

} // namespace dewpoint::setup
