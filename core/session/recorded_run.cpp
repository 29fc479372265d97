// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/recorded_run.h"

#include "core/camera_motion/agreement/disagreement_sentence.h"
#include "core/project/project_check.h"
#include "core/session/watch/camera_watches.h"

#include <algorithm>
#include <iterator>

namespace dewpoint::session {
namespace {

/// Keeps what becomes of the frames of a run.
class ResultCollector final : public FrameObserver {
public:
  ResultCollector(RecordedRun& kept, int particleLimit)
      : kept_(kept), particleLimit_(particleLimit) {}

  Status onFrameTracked(const TrackingRun& run) override {
    std::ranges::move(run.samples(), std::back_inserter(kept_.trajectory.samples));
    std::ranges::move(run.boxSamples(), std::back_inserter(kept_.boxTrack.samples));
    for (std::size_t k = 0; particleLimit_ > 0 && k < run.targets().size(); ++k) {
      kept_.particles[{run.frames()->index, k}] = particlesOf(run, k, particleLimit_);
    }
    ++kept_.frameCount;
    return {};
  }

private:
  RecordedRun& kept_;
  int particleLimit_;
};

void addNotice(const std::string& text, std::vector<std::string>& notices) {
  if (std::ranges::find(notices, text) == notices.end()) {
    notices.push_back(text);
  }
}

} // namespace

ParticleSample particlesOf(const TrackingRun& run, std::size_t target, int limit) {
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  run.copyParticles(target, limit, positions, weights);
  return {positions, weights};
}

Result<RecordedRun> recordRun(const Project& project, FrameSetSource& source,
                              const std::vector<cv::Mat>& backgroundImages,
                              const RecordRunOptions& order, const RunProgress& progress) {
  if (const auto good = checkMethodTargets(project); !good) {
    return tl::make_unexpected(good.error());
  }
  auto run = TrackingRun::create(project, order.threadCount, backgroundImages);
  if (!run) {
    return tl::make_unexpected(run.error());
  }
  // The parameters in use stand in the header.
  const Project used = run->definition()->appliedTo(project);
  RecordedRun kept;
  kept.trajectory.header = trajectoryHeader(used);
  kept.boxTrack.header = boxTrackHeader(used);

  CameraWatches watches(run->rig());
  ResultCollector keeper(kept, order.particleLimit);
  std::vector<FrameObserver*> observers(order.observers.begin(), order.observers.end());
  observers.insert(observers.end(), {&watches, &keeper});
  const auto total = order.frames.countIn(source);
  bool isWanted = true;
  const Status tracked = trackFrames(source, order.frames, *run, observers, [&] {
    isWanted = progress(kept.frameCount, total);
    return isWanted;
  });
  if (!tracked && kept.frameCount == 0) {
    return tl::make_unexpected(tracked.error());
  }
  kept.isFinished = tracked && (isWanted || kept.frameCount == total);
  if (!tracked) {
    kept.endError = tracked.error();
  }
  for (const Target& target : run->targets()) {
    kept.targetNames.push_back(target.name);
  }
  for (const Error& notice : source.notices()) {
    addNotice(errorSentence(notice), kept.notices);
  }
  for (const Error& notice : watches.motionWatch().notices()) {
    addNotice(errorSentence(notice), kept.notices);
  }
  for (const CameraDisagreement& found :
       watches.agreementWatch().disagreements(run->definition()->family())) {
    addNotice(describeDisagreement(found, run->rig()), kept.notices);
  }
  return kept;
}

} // namespace dewpoint::session
