// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/histogram_tracker.h"

#include "core/filter/estimate.h"
#include "core/filter/evenly_picked.h"
#include "core/filter/systematic_resampling.h"
#include "core/observation/boxes/box_without_margin.h"
#include "core/tracking/boxes/color_peaks.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace dewpoint::tracking {
namespace {

/// Targets of more pixels are looked at in a smaller image: they have colors enough.
constexpr double kWorkingArea = 48.0 * 48.0;
constexpr double kVelocityShare = 0.5; ///< of a random step that lasts
constexpr double kHiddenDamping = 0.7; ///< of the velocity, per image, while nothing is seen
constexpr double kLargestScale = 1.2;  ///< logarithm: from a third to three times the size
// Jumps.
constexpr std::size_t kPeaks = 6;
constexpr double kLeastPeak = 0.25;  ///< of the usual score
constexpr double kJumpSpread = 0.12; ///< of the box, about a peak
constexpr double kJumpCost = 5.0;    ///< logarithm; halved while hidden
constexpr double kHiddenJumpShare = 0.5;
constexpr double kReachGrowth = 0.5; ///< per image while hidden
constexpr double kSearchReach = 5.0; ///< times the reach: beyond, a jump costs 12.5
/// A place without the target's colors is never worse than this share of the usual: it may be
/// hidden there.
constexpr double kFloor = 0.35;
// Size (see fitSizeExponents()).
constexpr double kShell = 0.1;
constexpr double kLeastExponent = 0.4; ///< else a box with a margin could grow at no cost
constexpr double kMostExponent = 0.8;
// Adaptation.
constexpr double kSureAbove = 0.6; ///< of the usual score: the box is the target, learn from it
constexpr double kSurroundingsRate = 0.1;
constexpr double kUsualRate = 0.05;
constexpr double kLeastUsual = 0.5; ///< what one image can make the usual score fall to

constexpr double kLargestAspect = 0.5;

enum Column { kX, kY, kVx, kVy, kScale, kAspect, kColumns };

} // namespace

/// The random numbers of one particle in one image.
struct HistogramTracker::MotionDraws {
  std::array<double, 4> normal;
  std::array<double, 3> uniform;
};

HistogramTracker::HistogramTracker(const ParameterValues& parameters) {
  configure(parameters);
}

void HistogramTracker::configure(const ParameterValues& parameters) {
  positionSigma_ = parameters.at("position_sigma");
  scaleSigma_ = parameters.at("scale_sigma");
  aspectSigma_ = parameters.at("aspect_sigma");
  jumpShare_ = parameters.at("jump_share");
  jumpReach_ = parameters.at("jump_reach");
  sharpness_ = parameters.at("sharpness");
  adaptation_ = parameters.at("adaptation");
  hiddenBelow_ = parameters.at("hidden_below");
  particleCount_ = static_cast<Eigen::Index>(parameters.at("particles"));
}

cv::Mat HistogramTracker::shrunk(const cv::Mat& bgr) const {
  if (shrink_ == 1.0) {
    return bgr;
  }
  cv::Mat small;
  cv::resize(bgr, small, {}, shrink_, shrink_, cv::INTER_AREA);
  return small;
}

Status HistogramTracker::start(const cv::Mat& bgr, const ImageBox& box, std::uint64_t seed) {
  if (const auto checked = checkBox(bgr, box); !checked) {
    return checked;
  }
  seed_ = seed;
  frame_ = 0;
  shrink_ = std::min(1.0, std::sqrt(kWorkingArea / box.area()));
  drawn_ = {shrink_ * box.x, shrink_ * box.y, shrink_ * box.width, shrink_ * box.height};
  const cv::Mat image = shrunk(bgr);
  first_ = boxWithoutMargin(image, drawn_);
  box_ = first_;
  hiddenFrames_ = 0;
  colors_.learn(image, box_);
  map_.build(image, {{0, 0}, image.size()}, colors_);
  fitSizeExponents();
  firstLikeness_ = std::max(colors_.similarityOf(image, box_), 1e-6);
  states_ = Eigen::ArrayXXd::Zero(particleCount_, kColumns);
  states_.col(kX) = box_.center().x();
  states_.col(kY) = box_.center().y();
  weighted_ = states_;
  weights_.setConstant(particleCount_, 1.0 / double(particleCount_));
  return {};
}

/// The score of a box is its sum of P(target) above a half divided by width^p and height^q. Which p
/// and q make the given box the best of its size, so that sizes do not drift? By a further column
/// the sum grows by (mean P at the sides), width^p by p (mean P inside): p is the ratio of the two;
/// q likewise.
void HistogramTracker::fitSizeExponents() {
  const double inside = map_.sum(box_);
  const auto exponent = [&](double across, double down) {
    const auto grown = [&](double sign) {
      return map_.sum(ImageBox::around(box_.center(), (1.0 + sign * across) * box_.width,
                                       (1.0 + sign * down) * box_.height));
    };
    const double growth = (grown(1.0) - grown(-1.0)) / (2.0 * kShell);
    return inside > 0.0 ? std::clamp(growth / inside, kLeastExponent, kMostExponent)
                        : kMostExponent;
  };
  widthExponent_ = exponent(kShell, 0.0);
  heightExponent_ = exponent(0.0, kShell);
  usualScore_ = std::max(score(box_), 1e-6);
}

double HistogramTracker::sizeFactor(const ImageBox& box) const {
  return first_.area() * std::pow(box.width / first_.width, widthExponent_) *
         std::pow(box.height / first_.height, heightExponent_);
}

double HistogramTracker::score(const ImageBox& box) const {
  return map_.sum(box) / sizeFactor(box);
}

/// What was drawn lies about the figure as in the first image; in the whole image.
ImageBox HistogramTracker::drawnBoxAround(const ImageBox& figure) const {
  const double across = figure.width / first_.width / shrink_;
  const double down = figure.height / first_.height / shrink_;
  return {figure.x / shrink_ + across * (drawn_.x - first_.x),
          figure.y / shrink_ + down * (drawn_.y - first_.y), across * drawn_.width,
          down * drawn_.height};
}

double HistogramTracker::size() const {
  return std::sqrt(box_.area());
}

double HistogramTracker::reach() const {
  return jumpReach_ * size() * (1.0 + kReachGrowth * hiddenFrames_);
}

cv::Rect HistogramTracker::searchRegion() const {
  const double around = kSearchReach * reach();
  const double speed = states_.middleCols(kVx, 2).abs().maxCoeff();
  const double far = std::min(1e6, around + speed);
  const ImageBox all =
      ImageBox::around(box_.center(), 2.0 * (far + box_.width), 2.0 * (far + box_.height));
  return {static_cast<int>(all.x), static_cast<int>(all.y), static_cast<int>(all.width),
          static_cast<int>(all.height)};
}

ImageBox HistogramTracker::boxOf(const Eigen::ArrayXXd& states, Eigen::Index row) const {
  const double scale = states(row, kScale);
  const double aspect = 0.5 * states(row, kAspect);
  return ImageBox::around({states(row, kX), states(row, kY)},
                          std::exp(scale + aspect) * first_.width,
                          std::exp(scale - aspect) * first_.height);
}

/// To a place with the target's colors; the farther from where it was expected, the less likely.
void HistogramTracker::jump(Eigen::Index row, const std::vector<Eigen::Vector2d>& peaks,
                            const MotionDraws& draws, double& logWeight) {
  const auto picked = static_cast<std::size_t>(draws.uniform[1] * double(peaks.size()));
  const Eigen::Vector2d old(states_(row, kX), states_(row, kY));
  const Eigen::Vector2d velocity(states_(row, kVx), states_(row, kVy));
  const Eigen::Vector2d place =
      peaks[picked] +
      kJumpSpread * Eigen::Vector2d(draws.normal[0] * box_.width, draws.normal[1] * box_.height);
  const double distance = (place - old - velocity).norm() / reach();
  const bool hidden = hiddenFrames_ > 0;
  logWeight -= (hidden ? 0.5 : 1.0) * kJumpCost + 0.5 * distance * distance;
  const Eigen::Vector2d moved = hidden ? Eigen::Vector2d::Zero() : Eigen::Vector2d(place - old);
  states_.row(row).head<4>() << place.x(), place.y(), moved.x(), moved.y();
}

/// Nearly constant velocity.
void HistogramTracker::predictWithConstantVelocity(Eigen::Index row, const MotionDraws& draws) {
  const double sigma = positionSigma_ * size();
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double noise = sigma * draws.normal[static_cast<std::size_t>(axis)];
    double& velocity = states_(row, kVx + axis);
    velocity *= hiddenFrames_ > 0 ? kHiddenDamping : 1.0;
    states_(row, axis) += velocity + noise;
    velocity += kVelocityShare * noise;
  }
}

void HistogramTracker::move(const std::vector<Eigen::Vector2d>& peaks, Eigen::ArrayXd& logWeights,
                            ThreadTeam& team) {
  const RandomStream motion(seed_, frame_, 0, RandomPurpose::Motion);
  const RandomStream proposal(seed_, frame_, 0, RandomPurpose::Proposal);
  const double share = hiddenFrames_ > 0 ? std::max(jumpShare_, kHiddenJumpShare) : jumpShare_;
  team.forEachRange(states_.rows(), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      const MotionDraws draws{motion.normal4(index), proposal.uniform3(index)};
      double logWeight = 0.0;
      if (!peaks.empty() && draws.uniform[0] < share) {
        jump(i, peaks, draws, logWeight);
      } else {
        predictWithConstantVelocity(i, draws);
      }
      states_(i, kScale) = std::clamp(states_(i, kScale) + scaleSigma_ * draws.normal[2],
                                      -kLargestScale, kLargestScale);
      states_(i, kAspect) = std::clamp(states_(i, kAspect) + aspectSigma_ * draws.normal[3],
                                       -kLargestAspect, kLargestAspect);
      const double found = score(boxOf(states_, i)) / usualScore_;
      logWeights(i) = logWeight + sharpness_ * std::max(found, kFloor);
    }
  });
}

/// Several places may be likely at once, and their mean is none of them: the mean of the particles
/// about the best one.
BoxEstimate HistogramTracker::estimateMode(const cv::Mat& bgr) {
  Eigen::Index best = 0;
  weights_.maxCoeff(&best);
  Eigen::ArrayXd near = weights_;
  for (Eigen::Index i = 0; i < near.size(); ++i) {
    const bool isNear = std::abs(states_(i, kX) - states_(best, kX)) < 0.5 * box_.width &&
                        std::abs(states_(i, kY) - states_(best, kY)) < 0.5 * box_.height;
    near(i) = isNear ? near(i) : 0.0;
  }
  near /= near.sum();
  const StateEstimate state = estimate(states_, near);
  BoxEstimate result;
  result.box = boxOf(state.mean.transpose().array(), 0);
  const double share = score(result.box) / usualScore_;
  result.similarity = std::clamp(colors_.similarityOf(bgr, result.box) / firstLikeness_, 0.0, 1.0);
  result.spreadPixels =
      std::sqrt(std::max(0.0, state.covariance(kX, kX) + state.covariance(kY, kY))) / shrink_;
  result.effectiveSampleSize = 1.0 / weights_.square().sum();
  result.particleCount = static_cast<int>(states_.rows());
  result.isVisible = share >= hiddenBelow_;
  result.isDegenerate = degenerate_;
  return result;
}

/// `share`: the score of the box in which the target was found, over the usual one.
void HistogramTracker::adapt(const cv::Mat& bgr, double share) {
  if (share > kSureAbove) {
    colors_.adaptTarget(bgr, box_, adaptation_);
  }
  colors_.adaptSurroundings(bgr, box_, kSurroundingsRate);
  usualScore_ *= 1.0 + kUsualRate * (std::max(share, kLeastUsual) - 1.0);
}

void HistogramTracker::resample() {
  Ancestors ancestors;
  SystematicResampling().drawAncestors(weights_, particleCount_,
                                       {seed_, frame_, 0, RandomPurpose::Resampling}, ancestors);
  weighted_ = states_(ancestors, Eigen::all);
  weighted_.swap(states_);
}

BoxEstimate HistogramTracker::step(const cv::Mat& bgr, ThreadTeam& team) {
  assert(states_.rows() > 0 && bgr.type() == CV_8UC3);
  ++frame_;
  const cv::Mat image = shrunk(bgr);
  map_.build(image, searchRegion(), colors_);
  const double least = kLeastPeak * usualScore_ * sizeFactor(box_);
  const auto peaks = findColorPeaks(map_, box_.width, box_.height, kPeaks, least);
  Eigen::ArrayXd logWeights(states_.rows());
  move(peaks, logWeights, team);
  degenerate_ = !normalize(logWeights, weights_, team);
  BoxEstimate result = estimateMode(image);
  if (result.isVisible) {
    hiddenFrames_ = 0;
    box_ = result.box;
    adapt(image, score(box_) / usualScore_);
  } else {
    ++hiddenFrames_;
    result.box = box_;
  }
  result.box = drawnBoxAround(result.box);
  resample();
  return result;
}

void HistogramTracker::copyParticles(int limit, Eigen::ArrayXXd& centers,
                                     Eigen::ArrayXd& weights) const {
  pickEvenly(weighted_, weights_, limit, 2, centers, weights);
  centers /= shrink_;
}

std::size_t HistogramTracker::memoryBytes() const {
  const auto numbers =
      static_cast<std::size_t>(states_.size() + weighted_.size() + weights_.size());
  return sizeof(HistogramTracker) + sizeof(double) * numbers + colors_.memoryBytes() +
         map_.memoryBytes();
}

} // namespace dewpoint::tracking
