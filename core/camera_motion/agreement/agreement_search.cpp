// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/agreement_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace dewpoint::camera_motion {
namespace {

// Judgments: how often a rig has each fault, against nothing being wrong. Natural logarithms.
constexpr double kFaultPrior = -4.6;   ///< one in a hundred, of each camera or pair
constexpr double kUnknownPrior = -6.9; ///< one in a thousand: the usual reasons have names

// Chosen on tuning seeds.
constexpr double kUnexplained = 1.0;   ///< mean log likelihood of sightings up to which it is bad
constexpr double kExplained = 2.0;     ///< from which a fault explains them
constexpr double kWellExplained = 3.0; ///< of a single object that all see
constexpr double kUsualErrors = -2.5;  ///< log prior of errors that need no other reason
constexpr std::size_t kMostExchanges = 2; ///< that are named as alternatives
constexpr double kMostDelay = 0.5;        ///< seconds, the largest that is searched for
/// Between delays that are tried, which a fit refines: image intervals, and seconds.
constexpr double kDelayStep = 1.5;
constexpr double kLeastDelayStep = 0.03;

struct Candidate {
  CameraDisagreement disagreement;
  bool explains = true; ///< most of what was seen agrees under it
};

/// The candidates with their log odds, collected.
class Candidates {
public:
  explicit Candidates(const AgreementFit& asDeclared) : asDeclared_(asDeclared) {}

  void add(CameraDisagreement disagreement, const AgreementFit& fit) {
    disagreement.logOdds = kFaultPrior + fit.logEvidence - asDeclared_.logEvidence;
    all_.push_back({std::move(disagreement), fit.lowestMeanLogLikelihood > kExplained});
  }
  /// What is known is that some cameras see unrelated things.
  void addUnknown(std::vector<std::size_t> cameras, double logEvidence) {
    all_.push_back({{.fault = CameraFault::Unknown,
                     .cameras = std::move(cameras),
                     .logOdds = kUnknownPrior + logEvidence - asDeclared_.logEvidence}});
  }
  std::optional<CameraDisagreement> decided(bool alsoUnknown) {
    std::ranges::stable_sort(all_, std::ranges::greater(),
                             [](const Candidate& one) { return one.disagreement.logOdds; });
    if (all_.empty() || all_.front().disagreement.logOdds < kMinLogOdds) {
      return std::nullopt;
    }
    if (auto named = clearlyBest()) {
      return named;
    }
    const auto unknown = std::ranges::find_if(
        all_, [](const Candidate& one) { return one.disagreement.fault == CameraFault::Unknown; });
    return alsoUnknown && unknown != all_.end() && unknown->disagreement.logOdds >= kMinLogOdds
               ? std::optional(unknown->disagreement)
               : std::nullopt;
  }

private:
  /// The best of the sorted candidates if it has a name and none but exchanges of other cameras
  /// that are as good comes near: in a rig that is like itself when it is rotated, several
  /// exchanges are the same.
  std::optional<CameraDisagreement> clearlyBest() const {
    CameraDisagreement best = all_.front().disagreement;
    std::vector<std::vector<std::size_t>> pairs{best.cameras};
    for (std::size_t i = 1; i < all_.size(); ++i) {
      const CameraDisagreement& other = all_[i].disagreement;
      if (best.logOdds - other.logOdds >= kMinLead) {
        break;
      }
      if (best.fault != CameraFault::Swapped || other.fault != CameraFault::Swapped ||
          !all_[i].explains || pairs.size() == kMostExchanges) {
        return std::nullopt;
      }
      pairs.push_back(other.cameras);
    }
    if (best.fault == CameraFault::Unknown || !all_.front().explains) {
      return std::nullopt;
    }
    if (best.fault == CameraFault::Swapped) {
      std::ranges::sort(pairs);
      best.cameras.clear();
      for (const auto& pair : pairs) {
        best.cameras.insert(best.cameras.end(), pair.begin(), pair.end());
      }
    }
    return best;
  }

  const AgreementFit& asDeclared_;
  std::vector<Candidate> all_;
};

void addSwapped(const AgreementModel& model, const CameraRig& rig, Candidates& candidates) {
  for (const auto& [a, b] : model.pairs()) {
    const Intrinsics& first = rig[a].intrinsics;
    const Intrinsics& second = rig[b].intrinsics;
    if (first.width != second.width || first.height != second.height) {
      continue;
    }
    AgreementHypothesis hypothesis;
    hypothesis.calibrationIndices.resize(rig.size());
    std::iota(hypothesis.calibrationIndices.begin(), hypothesis.calibrationIndices.end(),
              std::size_t{0});
    std::swap(hypothesis.calibrationIndices[a], hypothesis.calibrationIndices[b]);
    candidates.add({.fault = CameraFault::Swapped, .cameras = {a, b}}, model.fit(hypothesis));
  }
}

void addLate(const AgreementModel& model, Candidates& candidates) {
  const double step = std::max(kLeastDelayStep, kDelayStep * model.imageInterval());
  // Of two cameras one is late, and the other not early.
  const double earliest = model.cameraCount() > 2 ? -kMostDelay : step;
  for (std::size_t camera = 0; camera < model.cameraCount(); ++camera) {
    AgreementHypothesis hypothesis;
    hypothesis.cameraWithFreeDelay = camera;
    double best = -1e18;
    for (double delay = earliest; delay <= kMostDelay; delay += step) {
      if (const double value = model.approximateLogLikelihood(camera, delay); value > best) {
        best = value;
        hypothesis.initialDelay = delay;
      }
    }
    const AgreementFit fit = model.fit(hypothesis);
    const double delay = fit.errors[camera].delay;
    if (model.cameraCount() > 2 || delay > 0.0) {
      candidates.add({.fault = CameraFault::Late, .cameras = {camera}, .delay = delay}, fit);
    }
  }
}

void addRotated(const AgreementModel& model, Candidates& candidates) {
  std::vector<AgreementFit> fits;
  for (std::size_t camera = 0; camera < model.cameraCount(); ++camera) {
    AgreementHypothesis hypothesis;
    hypothesis.cameraWithFreeRotation = camera;
    fits.push_back(model.fit(hypothesis));
    if (model.cameraCount() > 2) {
      candidates.add({.fault = CameraFault::Rotated,
                      .cameras = {camera},
                      .rotationCorrections = {fits.back().errors[camera].turn}},
                     fits.back());
    }
  }
  if (fits.size() == 2) { // nothing tells which of both it is
    candidates.add({.fault = CameraFault::Rotated,
                    .cameras = {0, 1},
                    .rotationCorrections = {fits[0].errors[0].turn, fits[1].errors[1].turn}},
                   fits[0].logEvidence > fits[1].logEvidence ? fits[0] : fits[1]);
  }
}

void addUnknown(const AgreementModel& model, const AgreementFit& asDeclared,
                Candidates& candidates) {
  if (model.cameraCount() == 2) {
    candidates.addUnknown({0, 1}, 0.0);
    return;
  }
  const auto pairs = model.pairs();
  for (std::size_t camera = 0; camera < model.cameraCount(); ++camera) {
    double others = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].first != camera && pairs[i].second != camera) {
        others += asDeclared.pairLogLikelihoods[i];
      }
    }
    candidates.addUnknown({camera}, others);
  }
}

} // namespace

bool isGoodFit(const AgreementFit& asDeclared) {
  return asDeclared.lowestMeanLogLikelihood > kWellExplained && asDeclared.logPrior > kUsualErrors;
}

bool isBadFit(const AgreementFit& asDeclared) {
  return asDeclared.lowestMeanLogLikelihood < kUnexplained;
}

std::optional<CameraDisagreement> findFault(const AgreementModel& model, const CameraRig& rig,
                                            const AgreementFit& asDeclared, bool alsoUnknown) {
  Candidates candidates(asDeclared);
  addSwapped(model, rig, candidates);
  addLate(model, candidates);
  addRotated(model, candidates);
  addUnknown(model, asDeclared, candidates);
  return candidates.decided(alsoUnknown);
}

} // namespace dewpoint::camera_motion
