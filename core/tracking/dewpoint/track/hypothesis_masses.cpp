// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/hypothesis_masses.h"

#include "core/tracking/dewpoint/track/track_constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::tracking {
namespace {

// Judgments (docs/method-dewpoint.md, sections 5 and 6).

constexpr std::size_t kMaxHypotheses = 6; ///< per target
constexpr double kMinProbability = 1e-8;  ///< of a hypothesis that is kept
/// Probability of the likeliest hypothesis from which on no new hypotheses are searched.
constexpr double kNoSearchProbability = 0.98;
/// Frames after which one of several objects that look just like the target is taken for it.
constexpr int kUpdatesToResolve = 5;
/// Most probability of what may be a part of something larger: likely enough to be shown, too
/// little to be sure.
constexpr double kMostWithoutRim = 0.9;
/// Share of the probability of all hypotheses from which on those that are not the likeliest make
/// the target ambiguous.
constexpr double kRivalShare = 0.1;

} // namespace

double absenceProbability(const std::vector<TrackHypothesis>& hypotheses) {
  double present = 0.0;
  for (const TrackHypothesis& hypothesis : hypotheses) {
    present += hypothesis.probability;
  }
  return std::max(kMinAbsence, 1.0 - present);
}

double absenceProbabilityInSharedViews(const std::vector<TrackHypothesis>& hypotheses) {
  double present = 0.0;
  for (const TrackHypothesis& hypothesis : hypotheses) {
    present += hypothesis.onlyOneCameraSees ? 0.0 : hypothesis.probability;
  }
  return std::max(kMinAbsence, 1.0 - present);
}

void limitOneCameraHypotheses(std::vector<TrackHypothesis>& hypotheses) {
  for (TrackHypothesis& hypothesis : hypotheses) {
    if (hypothesis.onlyOneCameraSees) {
      hypothesis.probability = std::min(hypothesis.probability, hypothesis.lastSharedProbability);
    } else {
      hypothesis.lastSharedProbability = hypothesis.probability;
    }
  }
}

void limitHypothesesWithoutRim(std::vector<TrackHypothesis>& hypotheses) {
  for (TrackHypothesis& hypothesis : hypotheses) {
    if (!hypothesis.hasRim()) {
      hypothesis.probability = std::min(hypothesis.probability, kMostWithoutRim);
    }
  }
}

bool isUndecided(const std::vector<TrackHypothesis>& hypotheses) {
  if (hypotheses.size() < 2) {
    return false;
  }
  double all = 0.0;
  double rivals = 0.0;
  for (const TrackHypothesis& hypothesis : hypotheses) {
    all += hypothesis.probability;
    rivals = &hypothesis == &hypotheses.front() ? 0.0 : rivals + hypothesis.probability;
  }
  return all > 0.5 && rivals >= kRivalShare * all;
}

Eigen::Matrix3d mixtureCovariance(const std::vector<TrackHypothesis>& hypotheses) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  double all = 0.0;
  for (const TrackHypothesis& hypothesis : hypotheses) {
    const Eigen::Vector3d apart = hypothesis.position() - hypotheses.front().position();
    sum += hypothesis.probability *
           (hypothesis.gaussian.covariance.topLeftCorner<3, 3>() + apart * apart.transpose());
    all += hypothesis.probability;
  }
  return all > 0.0 ? Eigen::Matrix3d(sum / all) : sum;
}

double evidenceBeyondSaturation(const TrackHypothesis& hypothesis) {
  return std::max(0.0,
                  hypothesis.logLikelihoodRatio - TrackHypothesis::kSaturationShare *
                                                      hypothesis.fullyVisibleLogLikelihoodRatio);
}

double probabilityOfMostLikely(std::span<const double> logMasses, double absence) {
  const auto top = std::max_element(logMasses.begin(), logMasses.end());
  double others = absence;
  for (auto mass = logMasses.begin(); mass != logMasses.end(); ++mass) {
    others += mass == top ? 0.0 : std::exp(*mass);
  }
  return 1.0 / (1.0 + others * std::exp(-*top));
}

bool mustSearch(const std::vector<TrackHypothesis>& hypotheses,
                const std::vector<double>& logMasses) {
  const auto top = std::max_element(logMasses.begin(), logMasses.end());
  if (top == logMasses.end()) {
    return true;
  }
  const TrackHypothesis& hypothesis = hypotheses[static_cast<std::size_t>(top - logMasses.begin())];
  return hypothesis.onlyOneCameraSees ||
         probabilityOfMostLikely(logMasses, absenceProbability(hypotheses)) <
             kNoSearchProbability ||
         hypothesis.logLikelihoodRatio <
             TrackHypothesis::kMostlyVisibleShare * hypothesis.fullyVisibleLogLikelihoodRatio ||
         hypothesis.fullyVisibleLogLikelihoodRatio <= 0.0;
}

void normalizeMasses(std::vector<TrackHypothesis>& hypotheses,
                     const std::vector<double>& logMasses) {
  const double logAbsence = std::log(absenceProbability(hypotheses));
  double largest = logAbsence;
  for (const double mass : logMasses) {
    largest = std::max(largest, mass);
  }
  double total = std::exp(logAbsence - largest);
  for (const double mass : logMasses) {
    total += std::exp(mass - largest);
  }
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    hypotheses[k].probability = std::exp(logMasses[k] - largest) / total;
  }
}

void mergeAndPrune(std::vector<TrackHypothesis>& hypotheses) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  std::vector<TrackHypothesis> kept;
  for (TrackHypothesis& hypothesis : hypotheses) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const TrackHypothesis& other) {
      return (other.position() - hypothesis.position()).norm() < 0.5 * other.radius;
    });
    if (same != kept.end()) {
      same->probability += hypothesis.probability;
    } else if (kept.size() < kMaxHypotheses && hypothesis.probability > kMinProbability) {
      kept.push_back(std::move(hypothesis));
    }
  }
  hypotheses = std::move(kept);
}

bool isOccupied(const Eigen::Vector3d& position, double radius,
                const std::vector<OccupiedSphere>& occupied) {
  return std::any_of(occupied.begin(), occupied.end(), [&](const OccupiedSphere& other) {
    return (other.center - position).norm() < kTouching * (other.radius + radius);
  });
}

std::optional<double> resolveAmbiguity(std::vector<TrackHypothesis>& hypotheses) {
  if (hypotheses.size() < 2 || hypotheses.front().updateCount < kUpdatesToResolve ||
      !hypotheses.front().isSaturated()) {
    return std::nullopt;
  }
  const double chosen = hypotheses.front().probability;
  double rivals = 0.0;
  std::vector<TrackHypothesis> kept{hypotheses.front()};
  for (std::size_t k = 1; k < hypotheses.size(); ++k) {
    if (hypotheses[k].isSaturated() && hypotheses[k].updateCount >= kUpdatesToResolve) {
      rivals += hypotheses[k].probability;
    } else {
      kept.push_back(hypotheses[k]);
    }
  }
  kept.front().probability += rivals;
  hypotheses = std::move(kept);
  return rivals / (rivals + chosen);
}

} // namespace dewpoint::tracking
