// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/identity_evaluation.h"

#include "core/base/units.h"
#include "core/trajectory/trajectory_reader.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <map>
#include <optional>

namespace dewpoint::experiment {
namespace {

/// Adds the samples of one trajectory to the frames, as truths or as estimates.
void fill(const Trajectory& trajectory, const IdentityComparison& comparison,
          std::vector<TrackPoint> TrackFrame::*where, std::map<std::int64_t, TrackFrame>& frames) {
  std::map<std::string, int> identities;
  for (const TrajectorySample& sample : trajectory.samples) {
    if (!sample.isValid || !sample.position.allFinite()) {
      continue;
    }
    const int identity =
        identities.emplace(sample.target, static_cast<int>(identities.size())).first->second;
    TrackPoint point{identity, sample.position};
    if (comparison.ignoresHeight) {
      point.position.z() = 0.0;
    }
    TrackFrame& frame = frames[sample.frame];
    frame.frame = sample.frame;
    frame.time = sample.time;
    (frame.*where).push_back(point);
  }
}

bool hasFrames(const Trajectory& trajectory) {
  return !trajectory.samples.empty() && trajectory.samples.front().frame != kNoFrame;
}

} // namespace

Result<std::vector<TrackFrame>> makeTrackFrames(const Trajectory& estimate, const Trajectory& truth,
                                                const IdentityComparison& comparison) {
  if (!hasFrames(estimate) || !hasFrames(truth)) {
    return failure(ErrorCode::Mismatch, "", "frame", "identities are compared by frame number");
  }
  std::map<std::int64_t, TrackFrame> frames;
  for (const TrajectorySample& sample : truth.samples) {
    frames[sample.frame].frame = sample.frame; // also where nobody is there
    frames[sample.frame].time = sample.time;
  }
  const auto ofTruth = frames.size();
  fill(truth, comparison, &TrackFrame::truth, frames);
  fill(estimate, comparison, &TrackFrame::estimates, frames);
  std::vector<TrackFrame> result;
  bool common = false;
  for (auto& [number, frame] : frames) {
    common = common || (!frame.truth.empty() && !frame.estimates.empty());
    result.push_back(std::move(frame));
  }
  if (!common || ofTruth == 0) {
    return failure(ErrorCode::Mismatch, "", "frame", "no frame has both a truth and an estimate");
  }
  return result;
}

Result<IdentityEvaluation> evaluateIdentities(const Trajectory& estimate, const Trajectory& truth,
                                              const IdentityComparison& comparison) {
  const auto frames = makeTrackFrames(estimate, truth, comparison);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  IdentityEvaluation result;
  result.comparison = comparison;
  result.frameCount = static_cast<std::int64_t>(frames->size());
  result.clearMot = computeClearMot(*frames, comparison.gate);
  result.hota = computeHota(*frames, comparison.gate);
  result.gospa = averageGospa(*frames, {comparison.gate, 2.0});
  return result;
}

std::string identityText(const IdentityEvaluation& e) {
  std::string text = fmt::format("identities, gate {:.3f} m{}, {} frames\n", e.comparison.gate,
                                 e.comparison.ignoresHeight ? " on the floor" : "", e.frameCount);
  text += fmt::format("  CLEAR MOT          MOTA {:.3f}, MOTP {:.1f} mm\n", e.clearMot.mota(),
                      inMillimeters(e.clearMot.motp()));
  text += fmt::format("                     {} misses, {} false, {} switches, {} fragmentations "
                      "of {} truths\n",
                      e.clearMot.misses, e.clearMot.falsePositives, e.clearMot.identitySwitches,
                      e.clearMot.fragmentations, e.clearMot.truthCount);
  text += fmt::format("  HOTA               {:.3f} (detection {:.3f}, association {:.3f}, "
                      "localization {:.3f})\n",
                      e.hota.hota, e.hota.detectionAccuracy, e.hota.associationAccuracy,
                      e.hota.localizationAccuracy);
  text += fmt::format("  GOSPA              {:.1f} mm ({:.3f} missed, {:.3f} false per frame)\n",
                      inMillimeters(e.gospa.mean), e.gospa.missedTargetsPerFrame,
                      e.gospa.falseTargetsPerFrame);
  return text;
}

nlohmann::json identityJson(const IdentityEvaluation& e) {
  return {{"unit", "m"},
          {"gate", e.comparison.gate},
          {"ground", e.comparison.ignoresHeight},
          {"frames", e.frameCount},
          {"mota", e.clearMot.mota()},
          {"motp", e.clearMot.motp()},
          {"truths", e.clearMot.truthCount},
          {"misses", e.clearMot.misses},
          {"false_positives", e.clearMot.falsePositives},
          {"identity_switches", e.clearMot.identitySwitches},
          {"fragmentations", e.clearMot.fragmentations},
          {"hota", e.hota.hota},
          {"detection", e.hota.detectionAccuracy},
          {"association", e.hota.associationAccuracy},
          {"localization", e.hota.localizationAccuracy},
          {"gospa", e.gospa.mean},
          {"gospa_missed_per_frame", e.gospa.missedTargetsPerFrame},
          {"gospa_false_per_frame", e.gospa.falseTargetsPerFrame}};
}

} // namespace dewpoint::experiment
