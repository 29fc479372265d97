// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/hota.h"

#include "core/filter/assignment.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace dewpoint::experiment {
namespace {

constexpr double kNoScore = std::numeric_limits<double>::quiet_NaN();
/// So that a similarity that is a threshold but for rounding reaches it.
constexpr double kRoundingMargin = 1e-9;

using IdentityPair = std::pair<int, int>; ///< truth, estimate

/// In how many frames each identity is there.
struct Appearances {
  std::map<int, std::int64_t> truth;
  std::map<int, std::int64_t> estimates;

  /// Jaccard index of two identities that share `common` frames.
  double alignment(const IdentityPair& pair, double common) const {
    return common /
           (static_cast<double>(truth.at(pair.first) + estimates.at(pair.second)) - common);
  }
};

struct Match {
  IdentityPair pair;
  double similarity = 0.0;
};

Eigen::MatrixXd similarities(const TrackFrame& frame, double gate) {
  return distances(frame).unaryExpr(
      [&](double distance) { return distance < gate ? 1.0 - distance / gate : 0.0; });
}

IdentityPair pairAt(const TrackFrame& frame, Eigen::Index row, Eigen::Index column) {
  return {frame.truth[static_cast<std::size_t>(row)].identity,
          frame.estimates[static_cast<std::size_t>(column)].identity};
}

Appearances countAppearances(std::span<const TrackFrame> frames) {
  Appearances appearances;
  for (const TrackFrame& frame : frames) {
    for (const TrackPoint& point : frame.truth)
      ++appearances.truth[point.identity];
    for (const TrackPoint& point : frame.estimates)
      ++appearances.estimates[point.identity];
  }
  return appearances;
}

/// Frames that each pair of identities could share; a frame with several candidates is divided
/// among them by their similarity.
std::map<IdentityPair, double> sharedFrames(std::span<const TrackFrame> frames, double gate) {
  std::map<IdentityPair, double> shared;
  for (const TrackFrame& frame : frames) {
    const Eigen::MatrixXd similarity = similarities(frame, gate);
    const Eigen::VectorXd rowSum = similarity.rowwise().sum();
    const Eigen::VectorXd columnSum = similarity.colwise().sum().transpose();
    for (Eigen::Index i = 0; i < similarity.rows(); ++i)
      for (Eigen::Index j = 0; j < similarity.cols(); ++j)
        if (similarity(i, j) > 0.0)
          shared[pairAt(frame, i, j)] +=
              similarity(i, j) / (rowSum[i] + columnSum[j] - similarity(i, j));
  }
  return shared;
}

std::vector<Match> matchAll(std::span<const TrackFrame> frames, double gate,
                            const Appearances& appearances) {
  const std::map<IdentityPair, double> shared = sharedFrames(frames, gate);
  std::vector<Match> matches;
  for (const TrackFrame& frame : frames) {
    const Eigen::MatrixXd similarity = similarities(frame, gate);
    Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(similarity.rows(), similarity.cols());
    for (Eigen::Index i = 0; i < cost.rows(); ++i)
      for (Eigen::Index j = 0; j < cost.cols(); ++j)
        if (const IdentityPair pair = pairAt(frame, i, j); similarity(i, j) > 0.0)
          cost(i, j) = -similarity(i, j) * appearances.alignment(pair, shared.at(pair));
    const Assignment assignment = assignMinimumCost(cost);
    for (Eigen::Index i = 0; i < cost.rows(); ++i) {
      const Eigen::Index j = assignment.columnOfRow[static_cast<std::size_t>(i)];
      if (j != kUnassigned && similarity(i, j) > 0.0)
        matches.push_back({pairAt(frame, i, j), similarity(i, j)});
    }
  }
  return matches;
}

std::int64_t total(const std::map<int, std::int64_t>& counts) {
  std::int64_t sum = 0;
  for (const auto& [identity, count] : counts)
    sum += count;
  return sum;
}

HotaAtThreshold scoreAt(const std::vector<Match>& matches, const Appearances& appearances,
                        double threshold) {
  HotaAtThreshold result;
  result.threshold = threshold;
  std::map<IdentityPair, std::int64_t> together;
  double similaritySum = 0.0;
  for (const Match& match : matches) {
    if (match.similarity < threshold - kRoundingMargin)
      continue;
    ++result.matches;
    ++together[match.pair];
    similaritySum += match.similarity;
  }
  result.misses = total(appearances.truth) - result.matches;
  result.falsePositives = total(appearances.estimates) - result.matches;
  const std::int64_t all = result.matches + result.misses + result.falsePositives;
  const auto found = static_cast<double>(result.matches);
  for (const auto& [pair, count] : together) {
    const auto frames = static_cast<double>(count);
    result.associationAccuracy += frames / found * appearances.alignment(pair, frames);
  }
  result.associationAccuracy = all == 0 ? kNoScore : result.associationAccuracy;
  result.detectionAccuracy = all == 0 ? kNoScore : found / static_cast<double>(all);
  result.localizationAccuracy = result.matches == 0 ? kNoScore : similaritySum / found;
  result.hota = std::sqrt(result.detectionAccuracy * result.associationAccuracy);
  return result;
}

} // namespace

Hota computeHota(std::span<const TrackFrame> frames, double gate) {
  const Appearances appearances = countAppearances(frames);
  const std::vector<Match> matches = matchAll(frames, gate, appearances);
  Hota result;
  int located = 0;
  for (int k = 0; k < kHotaThresholdCount; ++k) {
    HotaAtThreshold& here = result.thresholds[static_cast<std::size_t>(k)];
    here = scoreAt(matches, appearances, (k + 1) / 20.0);
    result.detectionAccuracy += here.detectionAccuracy / kHotaThresholdCount;
    result.associationAccuracy += here.associationAccuracy / kHotaThresholdCount;
    result.hota += here.hota / kHotaThresholdCount;
    if (here.matches > 0) {
      result.localizationAccuracy += here.localizationAccuracy;
      ++located;
    }
  }
  result.localizationAccuracy = located == 0 ? kNoScore : result.localizationAccuracy / located;
  return result;
}

} // namespace dewpoint::experiment
