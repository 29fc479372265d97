// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/clicked_correction.h"

#include "core/setup/clicks/clicked_position.h"

#include <algorithm>

namespace dewpoint::setup {

const PositionCorrection* correctionAt(const Project& project, std::int64_t frame, int target) {
  const auto found =
      std::ranges::find_if(project.corrections, [&](const PositionCorrection& correction) {
        return correction.frame == frame && correction.target == target;
      });
  return found == project.corrections.end() ? nullptr : &*found;
}

Result<PositionCorrection> correctionFromClick(const Project& project, const CameraRig& rig,
                                               std::int64_t frame, int target,
                                               const PointClick& click,
                                               const std::optional<Gaussian3>& estimate) {
  PositionCorrection correction;
  correction.frame = frame;
  correction.target = target;
  if (const PositionCorrection* before = correctionAt(project, frame, target)) {
    correction.clicks = before->clicks;
  }
  const auto former = std::ranges::find(correction.clicks, click.camera, &PointClick::camera);
  if (former != correction.clicks.end()) {
    former->pixel = click.pixel;
  } else {
    correction.clicks.push_back(click);
  }
  const auto found = positionFromClicks(rig, correction.clicks, estimate);
  if (!found) {
    return tl::make_unexpected(found.error());
  }
  correction.position = found->mean;
  correction.covariance = found->covariance;
  return correction;
}

} // namespace dewpoint::setup
