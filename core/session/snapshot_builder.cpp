// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot_builder.h"

#include "core/base/overloaded.h"
#include "core/color/match_image.h"
#include "core/observation/boxes/box_histogram.h"
#include "core/session/box_counterparts.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace dewpoint::session {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Particles of each target: more cannot be distinguished.
constexpr int kParticlesShown = 10000;
constexpr int kMapReach = 48;            ///< pixels
constexpr std::size_t kMostInMask = 255; ///< targets that one byte tells apart

TargetSnapshot snapshotOf(const TrackedTarget& trackedFrame, const Target& target) {
  TargetSnapshot shown;
  shown.target = target;
  shown.estimate = trackedFrame.estimate;
  shown.particles = trackedFrame.particles.cast<double>();
  shown.weights = trackedFrame.weights.cast<double>();
  shown.positionCandidates = trackedFrame.positionCandidates;
  shown.cameraReports = trackedFrame.cameraReports;
  shown.status = trackedFrame.status;
  shown.boxParticles = trackedFrame.boxParticles;
  return shown;
}

/// Of whom nothing is to be shown at this frame.
TargetSnapshot absent(const Target& target) {
  TargetSnapshot shown;
  shown.target = target;
  shown.estimate = AbsentEstimate{};
  shown.status = TargetStatus::Gone;
  return shown;
}

bool areTargetsFound(const TrackingRun& run) {
  return run.definition()->family().findsTargets();
}

/// Targets of the run that are not in the frame shown. Nothing is believed of them then, but they
/// are known; those that are found are not there yet.
void addOthers(const TrackingRun& run, TrackSnapshot& snapshot) {
  const bool areFound = areTargetsFound(run);
  if (snapshot.isTracked && !areFound) {
    return;
  }
  for (std::size_t k = snapshot.targets.size(); k < run.targets().size(); ++k) {
    const Target& target = run.targets()[k];
    if (areFound) {
      snapshot.targets.push_back(absent(target));
    } else {
      snapshot.targets.emplace_back().target = target;
    }
  }
}

/// Where boxes are followed a moment shows the targets that there are now, in their order.
void showPresentBoxes(const TrackingRun& run, TrackSnapshot& snapshot) {
  std::vector<TargetSnapshot> then = std::exchange(snapshot.targets, {});
  const auto nameOf = [](const TargetSnapshot& shown) { return shown.target.name; };
  const std::vector<Target>& targets = run.targets();
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const int old = indexOfSameTarget(then, nameOf, targets.size(), k, targets[k].name);
    if (old >= 0) {
      snapshot.targets.push_back(then[static_cast<std::size_t>(old)]);
      snapshot.targets.back().target = targets[k];
    } else { // it was added later
      snapshot.targets.push_back(absent(targets[k]));
    }
    snapshot.targets.back().stateWhileAbsent = TrackingState::NoBox;
  }
}

/// A renamed or hidden target is so in all frames. Of another number of targets nobody knows which
/// they are, and those that are found get their names from the run.
void showPresentNames(const TrackingRun& run, TrackSnapshot& snapshot) {
  const std::vector<Target>& targets = run.targets();
  if (areTargetsFound(run) || snapshot.targets.size() != targets.size()) {
    return;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    snapshot.targets[k].target.name = targets[k].name;
    snapshot.targets[k].target.isShown = targets[k].isShown;
  }
}

void addShapes(TrackSnapshot& snapshot) {
  for (TargetSnapshot& target : snapshot.targets) {
    const bool hasBody = std::visit(Overloaded{[](const SphereEstimate&) { return false; },
                                               [](const BoxEstimate&) { return false; },
                                               [](const PersonEstimate&) { return true; },
                                               [](const AbsentEstimate&) { return false; }},
                                    target.estimate);
    if (hasBody && target.particles.rows() > 0) {
      target.shape = std::make_shared<const PersonShape>(
          personShape(BodyCloud{target.particles, target.weights}));
    }
  }
}

/// The colors of a box, as they were given and in the image shown.
void addHistogram(const ReferenceColorReporting& colors, std::size_t index, const BoxEstimate& box,
                  TrackSnapshot& snapshot) {
  const auto camera = static_cast<std::size_t>(box.camera);
  if (camera >= snapshot.frames->frames.size() || !snapshot.frames->frames[camera] ||
      snapshot.frames->frames[camera]->image.type() != CV_8UC3) {
    return;
  }
  ColorHistograms histograms{colors.referenceHistogram(index),
                             boxHistogram(snapshot.frames->frames[camera]->image, box.box)};
  if (!histograms.reference.empty() && !histograms.candidate.empty()) {
    snapshot.targets[index].histograms =
        std::make_shared<const ColorHistograms>(std::move(histograms));
  }
}

/// The colors of all targets that are boxes.
void addHistograms(const TrackingRun& run, TrackSnapshot& snapshot) {
  const auto* const colors = run.capability<ReferenceColorReporting>();
  const std::size_t count = std::min(snapshot.targets.size(), run.targets().size());
  for (std::size_t k = 0; colors != nullptr && k < count; ++k) {
    std::visit(Overloaded{[](const SphereEstimate&) {},
                          [&](const BoxEstimate& box) { addHistogram(*colors, k, box, snapshot); },
                          [](const PersonEstimate&) {}, [](const AbsentEstimate&) {}},
               snapshot.targets[k].estimate);
  }
}

/// Which pixels have the colors of the targets shown; what matches several targets is the first
/// one's.
std::vector<cv::Mat> colorMasks(const TrackSnapshot& snapshot) {
  std::vector<cv::Mat> masks;
  const auto& frames = snapshot.frames->frames;
  for (std::size_t camera = 0; camera < frames.size(); ++camera) {
    const FramePtr& frame = frames[camera];
    cv::Mat mask;
    for (std::size_t k = 0; k < std::min(snapshot.targets.size(), kMostInMask); ++k) {
      const auto& target = snapshot.targets[k];
      const auto& followed = colorsOf(target.estimate); // empty: they are as they were learned
      if (frame && target.target.isShown) {
        const ColorClassifier color(camera < followed.size() ? followed[camera]
                                                             : target.target.colors());
        const cv::Mat matched = matchImage(frame->image, color);
        if (mask.empty()) {
          mask = cv::Mat::zeros(matched.size(), CV_8UC1);
        }
        mask.setTo(255 - static_cast<int>(k), matched & (mask == 0));
      }
    }
    masks.push_back(mask);
  }
  return masks;
}

/// The motion masks of a method for people after its last frame, in the sizes of the images
/// (CV_8UC1, 0 or 255); empty where there is none.
std::vector<cv::Mat> motionMasks(const TrackingRun& run, const PeopleFinding& finding) {
  std::vector<cv::Mat> masks;
  for (std::size_t camera = 0; camera < run.rig().size(); ++camera) {
    cv::Mat mask = finding.foregroundMask(camera);
    const Intrinsics& size = run.rig()[camera].intrinsics;
    if (!mask.empty() && mask.size() != cv::Size(size.width, size.height)) {
      cv::Mat larger;
      cv::resize(mask, larger, cv::Size(size.width, size.height), 0.0, 0.0, cv::INTER_NEAREST);
      mask = larger;
    }
    masks.push_back(mask);
  }
  return masks;
}

/// The maps of a method's last frame, in the sizes of the images.
std::vector<LikelihoodMap> motionMaps(const TrackingRun& run, const MotionMapping& mapping) {
  std::vector<LikelihoodMap> maps = mapping.motionLikelihoodMaps();
  for (std::size_t camera = 0; camera < std::min(maps.size(), run.rig().size()); ++camera) {
    LikelihoodMap& map = maps[camera];
    const Intrinsics& intrinsics = run.rig()[camera].intrinsics;
    const cv::Size size(intrinsics.width, intrinsics.height);
    if (!map.area.empty() && map.area.size() != size) {
      cv::Mat larger;
      cv::resize(map.logLikelihood, larger, size, 0.0, 0.0, cv::INTER_LINEAR);
      map.logLikelihood = larger;
      map.area = {{0, 0}, size};
    }
  }
  return maps;
}

} // namespace

void SnapshotBuilder::show(const TrackedFrame& trackedFrame, const TrackingRun& run,
                           const History* history, std::int64_t tailEnd, TrackSnapshot& snapshot) {
  snapshot.iterationCount = trackedFrame.totalIterationCount;
  snapshot.peopleCameras = trackedFrame.peopleCameras;
  snapshot.targets.clear();
  for (std::size_t k = 0; k < trackedFrame.targets.size(); ++k) {
    snapshot.targets.push_back(
        snapshotOf(trackedFrame.targets[k], (*trackedFrame.targetDefinitions)[k]));
    if (history != nullptr) {
      snapshot.targets.back().tailPositions = history->tail(k, snapshot.frame, tailEnd);
    }
  }
  addOthers(run, snapshot);
  if (run.definition()->family().retracksAfterEdit) {
    showPresentBoxes(run, snapshot);
  }
  showPresentNames(run, snapshot);
}

void SnapshotBuilder::addImages(const TrackingRun& run, TrackSnapshot& snapshot) const {
  if (options_.includesBodyShapes) {
    addShapes(snapshot);
  }
  if (!snapshot.frames) {
    return;
  }
  if (!snapshot.isPreview) {
    addHistograms(run, snapshot);
  }
  // Of targets that were found nobody knows which true ones they are.
  if (!areTargetsFound(run)) {
    for (TargetSnapshot& target : snapshot.targets) {
      target.truth = truth_.at(target.target.name, snapshot.frame);
    }
  }
  // A target without a color has no mask.
  if (options_.includesMasks && !snapshot.isPreview && snapshot.family.hasColorMasks()) {
    snapshot.masks = colorMasks(snapshot);
  }
}

void SnapshotBuilder::fillFromCurrentFrame(const TrackingRun& run, const History* history,
                                           bool isRecorded, TrackSnapshot& snapshot) const {
  snapshot.frames = run.frames();
  snapshot.frame = run.frames() ? run.frames()->index : -1;
  snapshot.clocks = run.clockEstimates();
  const TrackedFrame* recorded = history != nullptr ? history->at(snapshot.frame) : nullptr;
  snapshot.isTracked = recorded != nullptr;
  const std::int64_t tailEnd = isRecorded ? snapshot.frame : snapshot.frame - 1;
  show(run.currentFrame(recorded, kParticlesShown), run, history, tailEnd, snapshot);
  for (std::size_t k = 0; k < snapshot.targets.size(); ++k) { // all of them, and to the last bit
    run.copyParticles(k, kParticlesShown, snapshot.targets[k].particles,
                      snapshot.targets[k].weights);
  }
  addImages(run, snapshot);
  if (requestsMaps(run, snapshot)) {
    addMaps(run, snapshot);
  }
}

Status SnapshotBuilder::fillFromPastFrame(const TrackingRun& run, TimeTravel& travel,
                                          std::int64_t frame, bool quickly,
                                          TrackSnapshot& snapshot) const {
  auto frames = quickly ? travel.previewAt(frame, snapshot.isPreview) : travel.framesAt(frame);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  snapshot.frames = std::move(*frames);
  snapshot.frame = frame;
  snapshot.clocks = run.clockEstimates();
  const TrackedFrame* trackedFrame = travel.history().at(frame);
  snapshot.isTracked = trackedFrame != nullptr;
  show(trackedFrame != nullptr ? *trackedFrame : TrackedFrame(), run, &travel.history(), frame,
       snapshot);
  addImages(run, snapshot);
  return {};
}

void SnapshotBuilder::fillFromDefinition(const RunDefinition& definition, TrackSnapshot& snapshot) {
  snapshot.rig = definition.rig;
  snapshot.family = definition.family();
  snapshot.backgroundImages = definition.backgroundImages;
  snapshot.seed = definition.seed;
}

Status SnapshotBuilder::fillFromAnyFrame(const TrackingRun& run, TimeTravel& travel,
                                         std::int64_t frame,
                                         const TimeTravel::ShouldContinue& shouldContinue,
                                         TrackSnapshot& snapshot) const {
  if (!shouldContinue()) {
    return failure(ErrorCode::Canceled, "", "", "");
  }
  if (travel.nearestFrame(frame) != frame) {
    return failure(ErrorCode::NotFound, "", "", fmt::format("frame {}", frame));
  }
  snapshot.isPast = true; // as it was recorded, so that the current frame looks like the others
  if (const Status shown = fillFromPastFrame(run, travel, frame, false, snapshot); !shown) {
    return shown;
  }
  if (lacksMaps(run, snapshot)) {
    if (const TrackingRun* then = travel.runAt(frame, run, shouldContinue)) {
      addMaps(*then, snapshot);
    }
  }
  return {};
}

bool SnapshotBuilder::requestsMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const {
  return run.definition()->family().hasMotionMasks
             ? (options_.includesMasks || options_.includesMaps) && snapshot.frames != nullptr
             : options_.includesMaps && snapshot.isTracked;
}

bool SnapshotBuilder::lacksMaps(const TrackingRun& run, const TrackSnapshot& snapshot) const {
  return snapshot.isPast && snapshot.isTracked && !snapshot.isPreview &&
         requestsMaps(run, snapshot);
}

void SnapshotBuilder::addMaps(const TrackingRun& run, TrackSnapshot& snapshot) const {
  const auto* const finding = run.capability<PeopleFinding>();
  if (finding != nullptr && options_.includesMasks) {
    snapshot.masks = motionMasks(run, *finding);
    snapshot.masksShowMotion = true;
  }
  const auto* const motion = run.capability<MotionMapping>();
  if (motion != nullptr && options_.includesMaps) {
    snapshot.motionMaps = motionMaps(run, *motion);
  }
  const auto* const mapping = run.capability<LikelihoodMapping>();
  for (std::size_t k = 0; mapping != nullptr && k < snapshot.targets.size(); ++k) {
    snapshot.targets[k].maps = mapping->likelihoodMaps(k, kMapReach);
  }
}

} // namespace dewpoint::session
