// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/clips/calibrated_clip.h"

#include "core/experiment/scenarios/random_draws.h"
#include "core/geometry/image_bounds.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/setup/clicks/click_learning.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace dewpoint::experiment {
namespace {

Status checkSizes(const CalibratedClip& clip, const FrameSet& set) {
  for (std::size_t camera = 0; camera < clip.rig.size(); ++camera) {
    const FramePtr& frame = set.frames[camera];
    const Intrinsics& intrinsics = clip.rig[camera].intrinsics;
    if (!frame) {
      return failure(ErrorCode::FileUnreadable, clip.cameraPaths[camera].string(), "",
                     "its first image cannot be read");
    }
    if (frame->image.cols != intrinsics.width || frame->image.rows != intrinsics.height) {
      return failure(ErrorCode::Mismatch, clip.cameraPaths[camera].string(), "size",
                     fmt::format("{} x {} pixels, the calibration is for {} x {}",
                                 frame->image.cols, frame->image.rows, intrinsics.width,
                                 intrinsics.height));
    }
  }
  return {};
}

Result<Target> learnedTarget(const ClipTarget& target, const CameraRig& rig, ClipFrames& frames) {
  const FrameSetPtr set = frames.at(target.click.frame);
  std::vector<cv::Mat> images;
  images.reserve(set->frames.size());
  for (const FramePtr& frame : set->frames) {
    images.push_back(frame ? frame->image : cv::Mat());
  }
  auto sample = takeSample(images.at(static_cast<std::size_t>(target.click.camera)), target.click);
  if (!sample) {
    return tl::make_unexpected(sample.error());
  }
  sample->frame = target.click.frame;
  auto learned = setup::learnFromClicks(
      rig, {.images = images, .backgroundImages = {}, .frame = target.click.frame}, {*sample});
  if (!learned) {
    return tl::make_unexpected(learned.error());
  }
  Target result;
  result.name = target.name;
  result.color = learned->color.range;
  result.otherColors = learned->color.otherRanges;
  result.samples = std::move(learned->samples);
  result.radius = learned->part ? learned->part->radius : 0.0;
  return result;
}

/// The marks of a clip: its own, or the projections of its positions into the images that hold
/// them.
std::vector<MarkedCenter> marksUsedBy(const CalibratedClip& clip) {
  if (!clip.markedCenters.empty()) {
    return clip.markedCenters;
  }
  std::vector<MarkedCenter> marks;
  for (std::size_t camera = 0; camera < clip.rig.size(); ++camera) {
    const Projector projector(clip.rig[camera]);
    for (const ClipPosition& truth : clip.positions) {
      const auto pixel = projector.project(truth.position);
      if (pixel && isInImage(clip.rig[camera].intrinsics, *pixel)) {
        marks.push_back({truth.instant, truth.target, camera, *pixel});
      }
    }
  }
  return marks;
}

std::vector<std::int64_t> measuredInstants(const ScenarioRun& run) {
  std::set<std::int64_t> frames;
  for (const TrajectorySample& sample : run.truth.samples) {
    frames.insert(sample.frame);
  }
  for (const MarkedCenter& mark : run.markedCenters) {
    frames.insert(mark.frame);
  }
  return {frames.begin(), frames.end()};
}

Trajectory truthOfClip(const CalibratedClip& clip) {
  Trajectory truth;
  for (const ClipPosition& position : clip.positions) {
    TrajectorySample sample;
    sample.frame = position.instant;
    sample.time =
        clip.instants[static_cast<std::size_t>(position.instant)].time - clip.instants.front().time;
    sample.target = clip.targets[position.target].name;
    sample.position = position.position;
    truth.samples.push_back(std::move(sample));
  }
  return truth;
}

/// Where the targets are at first: as the clip says, or the earliest position of each.
std::vector<Eigen::Vector3d> startsOf(const CalibratedClip& clip) {
  if (!clip.startPositions.empty()) {
    return clip.startPositions;
  }
  std::vector<Eigen::Vector3d> starts;
  for (std::size_t target = 0; target < clip.targets.size(); ++target) {
    const ClipPosition* first = nullptr;
    for (const ClipPosition& position : clip.positions) {
      if (position.target == target && (first == nullptr || position.instant < first->instant)) {
        first = &position;
      }
    }
    if (first != nullptr) {
      starts.push_back(first->position);
    }
  }
  return starts;
}

/// The box of the search: around the starts, shifted by as much as the seed says.
void placeStart(const CalibratedClip& clip, ScenarioRun& run) {
  const auto starts = startsOf(clip);
  Eigen::Vector3d low = starts.front();
  Eigen::Vector3d high = starts.front();
  for (const Eigen::Vector3d& start : starts) {
    low = low.cwiseMin(start);
    high = high.cwiseMax(start);
  }
  RandomDraws draws(run.seed, clip.name);
  const Eigen::Vector3d most = Eigen::Vector3d::Constant(0.5 * clip.startMargin);
  run.startCenter = 0.5 * (low + high) + draws.drawPointInBox(-most, most);
  run.startHalfSize = 0.5 * (high - low) + Eigen::Vector3d::Constant(clip.startMargin);
}

} // namespace

std::optional<Eigen::Vector3d> triangulateMarks(const CameraRig& rig,
                                                const std::vector<MarkedCenter>& marks,
                                                std::int64_t instant, std::size_t target) {
  std::vector<Ray> rays;
  for (const MarkedCenter& mark : marks) {
    if (mark.frame == instant && mark.target == target) {
      if (const auto ray = Unprojector(rig[mark.camera]).ray(mark.pixel)) {
        rays.push_back(*ray);
      }
    }
  }
  return nearestPoint(rays);
}

Result<ScenarioRun> makeClipRun(const CalibratedClip& clip, std::uint64_t seed) {
  auto opened = ClipFrames::open(clip.cameraPaths, clip.instants);
  if (!opened) {
    return tl::make_unexpected(opened.error());
  }
  const std::shared_ptr<ClipFrames> frames = std::move(*opened);
  if (const auto fits = checkSizes(clip, *frames->at(0)); !fits) {
    return tl::make_unexpected(fits.error());
  }
  ScenarioRun run;
  run.scenario = clip.name;
  run.grade = Grade::Real;
  run.seed = seed;
  run.rig = clip.rig;
  run.trueRig = clip.rig;
  run.framesPerSecond = clip.framesPerSecond;
  run.frameCount = frames->instantCount();
  for (const ClipTarget& target : clip.targets) {
    auto learned = learnedTarget(target, clip.rig, *frames);
    if (!learned) {
      return tl::make_unexpected(learned.error());
    }
    run.targets.push_back(std::move(*learned));
  }
  run.truth = truthOfClip(clip);
  run.markedCenters = marksUsedBy(clip);
  run.markGatePx = clip.markGatePx;
  run.measuredFrames = measuredInstants(run);
  if (startsOf(clip).empty()) {
    return failure(ErrorCode::MissingKey, clip.name, "truth", "no target has a first position");
  }
  placeStart(clip, run);
  run.frames = [frames](std::int64_t frame) { return frames->at(frame); };
  return run;
}

} // namespace dewpoint::experiment
