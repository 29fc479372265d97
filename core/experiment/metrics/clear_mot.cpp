// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/clear_mot.h"

#include "core/filter/assignment.h"

#include <algorithm>
#include <limits>
#include <map>

namespace dewpoint::experiment {
namespace {

/// Goes through a sequence frame by frame and remembers who was matched with whom.
class Matcher {
public:
  explicit Matcher(double gate) : gate_(gate) {}

  const ClearMot& counts() const { return counts_; }

  void add(const TrackFrame& frame) {
    Eigen::MatrixXd distance = distances(frame);
    std::vector<Eigen::Index> estimateOf(frame.truth.size(), kUnassigned);
    keepMatches(frame, distance, estimateOf);
    matchTheRest(distance, estimateOf);
    count(frame, distance, estimateOf);
    ++step_;
  }

private:
  /// What is known of one truth.
  struct History {
    int identity = 0;       ///< of the estimate it was matched with last
    std::int64_t since = 0; ///< step of that match
    bool interrupted = false;
  };

  /// The truth that holds this identity: the one matched with it last. Two truths may remember the
  /// same identity when one of them went away.
  Eigen::Index holderOf(const TrackFrame& frame, int identity) const {
    Eigen::Index holder = kUnassigned;
    std::int64_t latest = -1;
    for (std::size_t i = 0; i < frame.truth.size(); ++i) {
      const auto known = histories_.find(frame.truth[i].identity);
      if (known == histories_.end() || known->second.identity != identity ||
          known->second.since <= latest)
        continue;
      holder = static_cast<Eigen::Index>(i);
      latest = known->second.since;
    }
    return holder;
  }

  void keepMatches(const TrackFrame& frame, const Eigen::MatrixXd& distance,
                   std::vector<Eigen::Index>& estimateOf) const {
    for (Eigen::Index j = 0; j < distance.cols(); ++j) {
      const int identity = frame.estimates[static_cast<std::size_t>(j)].identity;
      const Eigen::Index i = holderOf(frame, identity);
      if (i != kUnassigned && distance(i, j) <= gate_)
        estimateOf[static_cast<std::size_t>(i)] = j;
    }
  }

  void matchTheRest(const Eigen::MatrixXd& distance, std::vector<Eigen::Index>& estimateOf) const {
    constexpr double kForbidden = std::numeric_limits<double>::infinity();
    Eigen::MatrixXd cost =
        distance.unaryExpr([&](double value) { return value <= gate_ ? value : kForbidden; });
    for (Eigen::Index i = 0; i < cost.rows(); ++i) {
      const Eigen::Index j = estimateOf[static_cast<std::size_t>(i)];
      if (j == kUnassigned)
        continue;
      cost.row(i).setConstant(kForbidden);
      cost.col(j).setConstant(kForbidden);
    }
    const Assignment rest = assignMinimumCost(cost);
    for (std::size_t i = 0; i < estimateOf.size(); ++i)
      if (estimateOf[i] == kUnassigned)
        estimateOf[i] = rest.columnOfRow[i];
  }

  void count(const TrackFrame& frame, const Eigen::MatrixXd& distance,
             const std::vector<Eigen::Index>& estimateOf) {
    std::int64_t matches = 0;
    for (std::size_t i = 0; i < estimateOf.size(); ++i) {
      const int truth = frame.truth[i].identity;
      if (estimateOf[i] == kUnassigned) {
        markInterrupted(truth);
        continue;
      }
      ++matches;
      counts_.distanceSum += distance(static_cast<Eigen::Index>(i), estimateOf[i]);
      noteMatch(truth, frame.estimates[static_cast<std::size_t>(estimateOf[i])].identity);
    }
    const auto truths = static_cast<std::int64_t>(frame.truth.size());
    counts_.truthCount += truths;
    counts_.matches += matches;
    counts_.misses += truths - matches;
    counts_.falsePositives += static_cast<std::int64_t>(frame.estimates.size()) - matches;
  }

  void markInterrupted(int truth) {
    const auto known = histories_.find(truth);
    if (known != histories_.end())
      known->second.interrupted = true;
  }

  void noteMatch(int truth, int identity) {
    const auto [known, isNew] = histories_.try_emplace(truth, History{identity, step_, false});
    History& history = known->second;
    if (!isNew && history.identity != identity)
      ++counts_.identitySwitches;
    if (history.interrupted)
      ++counts_.fragmentations;
    history = {identity, step_, false};
  }

  double gate_;
  std::int64_t step_ = 0;
  std::map<int, History> histories_;
  ClearMot counts_;
};

double ratio(double numerator, std::int64_t denominator) {
  return denominator == 0 ? std::numeric_limits<double>::quiet_NaN()
                          : numerator / static_cast<double>(denominator);
}

} // namespace

double ClearMot::mota() const {
  return 1.0 - ratio(static_cast<double>(misses + falsePositives + identitySwitches), truthCount);
}

double ClearMot::motp() const {
  return ratio(distanceSum, matches);
}

ClearMot computeClearMot(std::span<const TrackFrame> frames, double gate) {
  Matcher matcher(gate);
  for (const TrackFrame& frame : frames)
    matcher.add(frame);
  return matcher.counts();
}

} // namespace dewpoint::experiment
