// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/image_clip_run.h"

#include "core/base/units.h"
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/metrics/box_metrics.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <memory>

namespace dewpoint::experiment {
namespace {

/// Particles of our methods: those of the paper's better result (Sugandi et al. 2009).
constexpr int kClipParticles = 300;

/// Microseconds of processor time of this thread.
double threadMicroseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// The frames after the first: the truth at zero, the box as far away as its center is from the
/// true one, in pixels; not declared where the follower has given up.
std::vector<TargetFrame> framesInPixels(const BoxClip& clip,
                                        const std::vector<std::optional<ImageBox>>& found) {
  std::vector<TargetFrame> frames;
  for (std::size_t k = 1; k < found.size(); ++k) {
    TargetFrame frame;
    frame.frame = static_cast<std::int64_t>(k) - 1;
    frame.truth = Eigen::Vector3d::Zero();
    if (found[k]) {
      const double away = (found[k]->center() - clip.truth[k].center()).norm();
      frame.estimate = Eigen::Vector3d(away, 0.0, 0.0);
    }
    frames.push_back(frame);
  }
  return frames;
}

} // namespace

const std::vector<std::string>& imageClipMethods() {
  return boxFollowerNames();
}

Result<std::optional<SuiteResult>> followClip(const BoxClip& clip,
                                              const std::vector<cv::Mat>& images, const RunKey& key,
                                              const std::function<bool()>& stop) {
  auto follower = makeFollowerByName(key.method, kClipParticles, key.seed);
  if (!follower) {
    return tl::make_unexpected(follower.error());
  }
  const double begin = threadMicroseconds();
  if (const auto started = (*follower)->start(images.front(), clip.truth.front()); !started) {
    return tl::make_unexpected(started.error());
  }
  std::vector<std::optional<ImageBox>> found{clip.truth.front()};
  for (std::size_t frame = 1; frame < images.size(); ++frame) {
    if (stop()) {
      return std::nullopt;
    }
    found.push_back((*follower)->step(images[frame]));
  }
  const double took = threadMicroseconds() - begin;
  const auto frames = framesInPixels(clip, found);
  const BoxMetrics metrics = measureBoxes(found, clip.truth, clip.hitRadiusPx);
  SuiteResult result;
  SuiteRow& row = result.row;
  row.key = key;
  result.trace.key = key;
  const auto converged = framesToConverge(frames, clip.hitRadiusPx);
  row.framesToConverge =
      converged ? static_cast<double>(*converged) : std::numeric_limits<double>::infinity();
  row.lostPercent = inPercent(lostFrameShare(frames, clip.hitRadiusPx).value());
  row.rmsePx = metrics.rmse;
  row.boxSuccess = metrics.success;
  row.usPerFrame = took / static_cast<double>(images.size());
  row.frameCount = static_cast<double>(frames.size());
  // Nothing is known in millimeters, and no method states a P(exists).
  result.trace.errorsMm.emplace_back(frames.size(), std::numeric_limits<double>::quiet_NaN());
  result.trace.reliabilityCounts.resize(kReliabilityBins);
  return result;
}

} // namespace dewpoint::experiment
