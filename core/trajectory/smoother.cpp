// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/smoother.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace dewpoint::trajectory {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Measurements that a path needs.
constexpr std::size_t kFewestMeasurements = 5;
/// Measurements that the model is fitted to.
constexpr std::size_t kMostMeasurementsToFit = 2000;
/// Squared standard deviations beyond which a measurement does not belong to the path (chi-square
/// with three degrees of freedom: one in 10^8 does), and how many of those in a row are a new path.
constexpr double kGate = 40.0;
constexpr int kNewPathMeasurements = 3;
/// After that many instants without a measurement the target may be mistaken for so many instants;
/// and how many later measurements have to agree with what was before.
constexpr std::size_t kGapInstants = 3;
constexpr std::size_t kMistakeInstants = 25;
constexpr int kMinConfirmingMeasurements = 5;
/// The gate of measurements that may be a mistake: one right one in 900 is dropped with them.
constexpr double kDoubtfulGate = 16.0;
/// Measurements to either side that an outlier pulls along, and how often outliers are looked for.
constexpr std::size_t kNeighbors = 10;
constexpr int kMostPasses = 10;
/// A filled position less certain than this is none, meters.
constexpr double kUsefulSigma = 0.1;
/// An estimate that is taken for a measurement is not better than this, meters: it has to be
/// inverted.
constexpr double kLeastSigma = 1e-5;

/// Of the progress: one step of the fit.
constexpr double kProgressPerStep = 0.03;

using Path = std::vector<PathPoint>;

/// Minus infinity for a model under which it cannot be computed: one so extreme that covariances
/// are no longer positive definite, or overflow.
double logLikelihood(std::span<const Path> paths, const PathModel& model) {
  double sum = 0.0;
  for (const Path& path : paths) {
    sum += pathLogLikelihood(path, model, kGate);
  }
  return std::isnan(sum) ? -std::numeric_limits<double>::infinity() : sum;
}

struct Fitted {
  PathModel model;
  double logLikelihood = 0.0;
};

/// Pattern search (Hooke and Jeeves 1961) over the logarithms of strength and noise factor.
Fitted fitOrder(std::span<const Path> paths, int order,
                const std::function<bool()>& shouldContinue) {
  constexpr double kFirstStep = 2.0; // e² = 7.4-fold
  constexpr double kLastStep = 0.06;
  constexpr double kMostLog = 25.0;
  const auto modelAt = [&](const std::array<double, 2>& logs) {
    return PathModel{order, std::exp(logs[0]), std::exp(logs[1])};
  };
  std::array<double, 2> logs{2.0 * (order - 2), 0.0};
  double best = logLikelihood(paths, modelAt(logs));
  const auto tryMove = [&](std::size_t axis, double step) {
    auto trial = logs;
    trial[axis] += step;
    const double found =
        std::abs(trial[axis]) > kMostLog ? best : logLikelihood(paths, modelAt(trial));
    if (found <= best) {
      return false;
    }
    best = found;
    logs = trial;
    return true;
  };
  for (double step = kFirstStep; step > kLastStep; step *= 0.5) {
    for (bool moved = true; moved && (!shouldContinue || shouldContinue());) {
      moved = false;
      for (std::size_t axis = 0; axis < logs.size(); ++axis) {
        moved = tryMove(axis, step) || tryMove(axis, -step) || moved;
      }
    }
  }
  return {modelAt(logs), best};
}

bool isUsable(const PositionMeasurement& seen) {
  return seen.position.allFinite() && seen.covariance.allFinite() &&
         seen.covariance.llt().info() == Eigen::Success;
}

/// What one sample says of its frame alone.
std::optional<PositionMeasurement> measurementOf(const TrajectorySample& sample,
                                                 bool hasMeasurements) {
  if (!sample.isValid) {
    return std::nullopt;
  }
  std::optional<PositionMeasurement> measurement = sample.measurement;
  if (!hasMeasurements) {
    measurement = PositionMeasurement{sample.position, sample.covariance};
    measurement->covariance.diagonal().array() += kLeastSigma * kLeastSigma;
  }
  return measurement && isUsable(*measurement) ? measurement : std::nullopt;
}

/// One target's samples in the order of time, and what belongs together of them.
class TargetSmoother {
public:
  /// `shouldContinue` is asked at each step, `wanted` more often within one.
  TargetSmoother(std::vector<TrajectorySample*> samples, double longestGap,
                 std::function<bool()> shouldContinue, std::function<bool()> wanted)
      : samples_(std::move(samples)), longestGap_(longestGap),
        shouldContinue_(std::move(shouldContinue)), wanted_(std::move(wanted)) {
    std::erase_if(samples_, [](const auto* sample) { return !std::isfinite(sample->time); });
    std::ranges::stable_sort(samples_, {}, [](const auto* sample) { return sample->time; });
    const bool hasMeasurements = std::ranges::any_of(
        samples_, [](const auto* sample) { return sample->measurement.has_value(); });
    for (const auto* sample : samples_) {
      points_.push_back({sample->time, measurementOf(*sample, hasMeasurements)});
    }
  }

  void run() {
    const auto measurements = std::ranges::count_if(
        points_, [](const auto& point) { return point.measurement.has_value(); });
    if (measurements < static_cast<std::ptrdiff_t>(kFewestMeasurements)) {
      return;
    }
    std::vector<std::size_t> begins = beginsAfterGaps();
    const PathModel model = fitPathModel(pathsFrom(begins), shouldContinue_);
    begins = withoutStrayMeasurements(begins, model);
    for (std::size_t k = 0; k < begins.size() && shouldContinue_(); ++k) {
      smoothPart(begins[k], k + 1 < begins.size() ? begins[k + 1] : points_.size(), model);
    }
  }

private:
  /// The points at which paths begin: at a measurement behind none for too long.
  std::vector<std::size_t> beginsAfterGaps() const {
    std::vector<std::size_t> begins;
    double last = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (points_[k].measurement) {
        if (points_[k].time - last > longestGap_) {
          begins.push_back(k);
        }
        last = points_[k].time;
      }
    }
    return begins;
  }

  std::vector<Path> pathsFrom(const std::vector<std::size_t>& begins) const {
    std::vector<Path> paths;
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : points_.size();
      paths.emplace_back(points_.begin() + static_cast<std::ptrdiff_t>(begins[k]),
                         points_.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return paths;
  }

  /// Looks far from the path are dropped; where several in a row are, the target has jumped and a
  /// new path begins.
  std::vector<std::size_t> withoutStrayMeasurements(const std::vector<std::size_t>& begins,
                                                    PathModel model) {
    model.noiseFactor = std::max(1.0, model.noiseFactor); // as stated, at least
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : points_.size();
      std::size_t begin = begins[k];
      while (begin < end && wanted_()) {
        if (result.empty() || result.back() != begin) { // the same again once a mistake is dropped
          result.push_back(begin);
        }
        begin = dropStrayMeasurements(begin, end, model);
      }
    }
    return result;
  }

  /// Where the next path begins; `end` if there is none before.
  std::size_t dropStrayMeasurements(std::size_t begin, std::size_t end, const PathModel& model) {
    std::vector<std::size_t> stray;
    std::vector<std::size_t> alone; // strays before a measurement that is where the path is
    const auto part = std::span(points_).subspan(begin, end - begin);
    forEachNormalizedInnovation(part, model, kGate, [&](std::size_t k, double surprise) {
      if (surprise <= kGate) {
        alone.insert(alone.end(), stray.begin(), stray.end());
        stray.clear();
      } else {
        stray.push_back(begin + k);
      }
      return stray.size() < kNewPathMeasurements && (k % 1000 != 0 || wanted_());
    });
    drop(alone);
    if (stray.size() == kNewPathMeasurements) {
      return dropWrongMeasurement(begin, end, stray.front(), model) ? begin : stray.front();
    }
    drop(stray);
    return end;
  }

  /// After a gap nearly any place is believed, also a wrong one; then those that follow look like a
  /// jump. But when, without the few looks behind the gap, the later ones agree with the path
  /// before it, some of these few were a mistake: those that are not on the path are dropped, and
  /// true is returned.
  bool dropWrongMeasurement(std::size_t begin, std::size_t end, std::size_t jump,
                            const PathModel& model) {
    const std::size_t first = firstAfterGap(begin, jump);
    if (first <= begin) {
      return false;
    }
    std::vector<PathPoint> without(points_.begin() + static_cast<std::ptrdiff_t>(begin),
                                   points_.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t k = first; k < jump; ++k) {
      without[k - begin].measurement.reset();
    }
    for (std::size_t k = jump; k < std::min(end, jump + kMistakeInstants) && wanted_(); ++k) {
      if (agrees(without, model, k - begin)) {
        const auto path = smoothPath(without, model, wanted_);
        std::vector<std::size_t> mistakes;
        for (std::size_t measurement = first; measurement < k; ++measurement) {
          if (points_[measurement].measurement &&
              !isOnPath(*points_[measurement].measurement, path[measurement - begin], model)) {
            mistakes.push_back(measurement);
          }
        }
        const bool any = !mistakes.empty();
        drop(mistakes);
        return any;
      }
      without[k - begin].measurement.reset();
    }
    return false;
  }

  /// The first look behind the last gap before the jump, if that is not long ago and something was
  /// seen before the gap; otherwise `begin`.
  std::size_t firstAfterGap(std::size_t begin, std::size_t jump) const {
    std::size_t unseen = 0;
    std::size_t first = jump;
    for (std::size_t k = jump; k-- > begin && first + kMistakeInstants > jump;) {
      if (points_[k].measurement && unseen >= kGapInstants) {
        return first;
      }
      first = points_[k].measurement ? k : first;
      unseen = points_[k].measurement ? 0 : unseen + 1;
    }
    return begin;
  }

  /// Whether the next looks from `from` on are those that were expected.
  static bool agrees(const std::vector<PathPoint>& path, const PathModel& model, std::size_t from) {
    int agreeing = 0;
    bool expected = true;
    forEachNormalizedInnovation(path, model, kGate, [&](std::size_t k, double surprise) {
      if (k >= from) {
        expected = surprise <= kGate;
        agreeing += expected ? 1 : 0;
      }
      return expected && agreeing < kMinConfirmingMeasurements;
    });
    return agreeing == kMinConfirmingMeasurements;
  }

  static bool isOnPath(const PositionMeasurement& measurement, const PathEstimate& path,
                       const PathModel& model) {
    const Eigen::Vector3d off = measurement.position - path.position;
    const Eigen::Matrix3d spread = path.covariance + model.noiseFactor * measurement.covariance;
    return off.dot(spread.llt().solve(off)) <= kDoubtfulGate;
  }

  void drop(std::vector<std::size_t>& measurements) {
    for (const std::size_t measurement : measurements) {
      points_[measurement].measurement.reset();
    }
    measurements.clear();
  }

  void smoothPart(std::size_t begin, std::size_t end, const PathModel& model) {
    const auto part = std::span(points_).subspan(begin, end - begin);
    auto estimates = smoothPath(part, model, wanted_);
    for (int pass = 0;
         pass < kMostPasses && shouldContinue_() && dropOutliers(part, estimates, model); ++pass) {
      estimates = smoothPath(part, model, wanted_);
    }
    const auto shared = sharedErrorCovariances(part, model, wanted_);
    const double share = std::max(0.0, 1.0 - model.noiseFactor);
    std::size_t last = 0;
    for (std::size_t k = 0; k < part.size(); ++k) {
      last = part[k].measurement ? k : last;
    }
    for (std::size_t k = 0; k < part.size(); ++k) {
      TrajectorySample& sample = *samples_[begin + k];
      if (k > last && !sample.isValid) {
        continue; // nobody says that the target is still there
      }
      sample.position = estimates[k].position;
      sample.covariance = estimates[k].covariance + share * shared[k];
      sample.isValid = sample.isValid || isUseful(sample.covariance);
    }
  }

  /// Drops looks that are far from the path as seen from both sides; of neighboring ones only the
  /// farthest, because it pulls the path away from the others. False if there was none.
  static bool dropOutliers(std::span<PathPoint> part, const std::vector<PathEstimate>& estimates,
                           const PathModel& model) {
    std::vector<double> squares(part.size());
    for (std::size_t k = 1; k < part.size(); ++k) { // the first one begins the path
      if (part[k].measurement) {
        const Eigen::Vector3d off = part[k].measurement->position - estimates[k].position;
        squares[k] = off.dot(part[k].measurement->covariance.llt().solve(off)) /
                     std::max(1.0, model.noiseFactor);
      }
    }
    bool dropped = false;
    for (std::size_t k = 1; k < part.size(); ++k) {
      const std::size_t from = k - std::min(k, kNeighbors);
      const std::size_t count = std::min(part.size() - from, 2 * kNeighbors + 1);
      if (squares[k] > kGate &&
          squares[k] >= std::ranges::max(std::span(squares).subspan(from, count))) {
        part[k].measurement.reset();
        dropped = true;
      }
    }
    return dropped;
  }

  static bool isUseful(const Eigen::Matrix3d& covariance) {
    return covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff() <
           kUsefulSigma * kUsefulSigma;
  }

  std::vector<TrajectorySample*> samples_;
  double longestGap_;
  std::function<bool()> shouldContinue_;
  std::function<bool()> wanted_;
  std::vector<PathPoint> points_;
};

} // namespace

PathModel fitPathModel(std::span<const std::vector<PathPoint>> paths,
                       const std::function<bool()>& shouldContinue) {
  std::vector<Path> used;
  std::size_t left = kMostMeasurementsToFit;
  for (const Path& path : paths) {
    const std::size_t count = std::min(left, path.size());
    used.emplace_back(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count));
    left -= count;
  }
  Fitted best = fitOrder(used, 2, shouldContinue);
  for (int order = 3; order <= kMaxPathOrder; ++order) {
    const Fitted other = fitOrder(used, order, shouldContinue);
    best = other.logLikelihood > best.logLikelihood ? other : best;
  }
  return best.model;
}

Trajectory smoothedTrajectory(const Trajectory& live, const SmootherOptions& options) {
  Trajectory result = live;
  // Particles are of the run; what is known after it has none.
  result.header.hasBestParticles = false;
  std::map<std::string, std::vector<TrajectorySample*>> targets;
  for (TrajectorySample& sample : result.samples) {
    sample.bestParticle.reset();
    targets[sample.target].push_back(&sample);
  }
  bool stopped = false;
  double done = 0.0;
  // How often it is asked varies with the run; each time the share grows a little towards the
  // whole.
  double share = 0.0;
  const auto wanted = [&] {
    stopped = stopped || (options.progress &&
                          !options.progress((done + share) / static_cast<double>(targets.size())));
    return !stopped;
  };
  const auto shouldContinue = [&] {
    share += kProgressPerStep * (1.0 - share);
    return wanted();
  };
  for (auto& [name, samples] : targets) {
    TargetSmoother(std::move(samples), options.maxFilledGapSeconds, shouldContinue, wanted).run();
    done += 1.0;
    share = 0.0;
  }
  return stopped ? live : result;
}

} // namespace dewpoint::trajectory
