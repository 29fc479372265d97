// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/sugandi_tracker.h"

#include "core/base/random.h"
#include "core/color/rgb_bins.h"
#include "core/filter/estimate.h"
#include "core/filter/evenly_picked.h"
#include "core/filter/multinomial_resampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dewpoint::tracking {
namespace {

cv::Rect everything(const cv::Mat& image) {
  return {{0, 0}, image.size()};
}

} // namespace

SugandiTracker::SugandiTracker(const ParameterValues& parameters) {
  configure(parameters);
}

void SugandiTracker::configure(const ParameterValues& parameters) {
  positionSigma_ = parameters.at("position_sigma");
  likelihoodSigma_ = parameters.at("likelihood_sigma");
  particleCount_ = static_cast<Eigen::Index>(parameters.at("particles"));
}

Status SugandiTracker::start(const cv::Mat& bgr, const ImageBox& box, std::uint64_t seed) {
  if (const auto checked = checkBox(bgr, box); !checked) {
    return checked;
  }
  seed_ = seed;
  frame_ = 0;
  box_ = box;
  const Eigen::Vector2d center = box.center();
  cv::Mat bins;
  findRgbBins(bgr, everything(bgr), bins);
  BoxKernel kernel(box);
  const auto reference = weightedHistogram(bins, kRgbBinCount, kernel, center.x(), center.y());
  similarity_.emplace(reference, std::move(kernel));
  states_.resize(particleCount_, 4);
  states_.rowwise() = Eigen::Array4d(center.x(), center.y(), center.x(), center.y()).transpose();
  weighted_ = states_;
  weights_.setConstant(particleCount_, 1.0 / double(particleCount_));
  return {};
}

/// Equation 1 with F and G of equation 4.
void SugandiTracker::propagate(ThreadTeam& team) {
  const RandomStream stream(seed_, frame_, 0, RandomPurpose::Motion);
  team.forEachRange(states_.rows(), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
      const auto noise = stream.normal4(static_cast<std::uint32_t>(i));
      for (Eigen::Index axis = 0; axis < 2; ++axis) {
        const double now = states_(i, axis);
        states_(i, axis) = 2.0 * now - states_(i, axis + 2) +
                           positionSigma_ * noise[static_cast<std::size_t>(axis)];
        states_(i, axis + 2) = now;
      }
    }
  });
}

/// All pixels that any particle looks at.
cv::Rect SugandiTracker::regionOfParticles(const cv::Size& image) const {
  const BoxKernel& kernel = similarity_->kernel();
  const auto low = [](double least, int size) { // a pixel more, for the rounding
    return std::max(0.0, std::floor(least - 0.5 * size) - 1.0);
  };
  const auto high = [](double most, int size, int limit) {
    return std::min(double(limit), std::ceil(most + 0.5 * size) + 1.0);
  };
  const double left = low(states_.col(0).minCoeff(), kernel.width());
  const double top = low(states_.col(1).minCoeff(), kernel.height());
  const double right = high(states_.col(0).maxCoeff(), kernel.width(), image.width);
  const double bottom = high(states_.col(1).maxCoeff(), kernel.height(), image.height);
  if (right <= left || bottom <= top) {
    return {};
  }
  return {static_cast<int>(left), static_cast<int>(top), static_cast<int>(right - left),
          static_cast<int>(bottom - top)};
}

/// Equation 11 in logarithms; what all particles share cancels when they are normalized.
void SugandiTracker::weigh(ThreadTeam& team) {
  Eigen::ArrayXd logWeights(states_.rows());
  const double factor = 1.0 / (2.0 * likelihoodSigma_ * likelihoodSigma_);
  team.forEachRange(states_.rows(), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i) {
      logWeights(i) = -factor * (1.0 - similarity_->at(states_(i, 0), states_(i, 1)));
    }
  });
  degenerate_ = !normalize(logWeights, weights_, team);
}

BoxEstimate SugandiTracker::estimateBox() const {
  const StateEstimate state = estimate(states_, weights_);
  BoxEstimate result;
  result.box = ImageBox::around(state.mean.head<2>(), box_.width, box_.height);
  result.similarity = similarity_->at(state.mean.x(), state.mean.y());
  result.spreadPixels = std::sqrt(std::max(0.0, state.covariance(0, 0) + state.covariance(1, 1)));
  result.effectiveSampleSize = state.effectiveSampleSize;
  result.particleCount = static_cast<int>(states_.rows());
  result.isDegenerate = degenerate_;
  return result;
}

void SugandiTracker::resample() {
  Ancestors ancestors;
  MultinomialResampling().drawAncestors(weights_, particleCount_,
                                        {seed_, frame_, 0, RandomPurpose::Resampling}, ancestors);
  weighted_ = states_(ancestors, Eigen::all);
  weighted_.swap(states_);
}

BoxEstimate SugandiTracker::step(const cv::Mat& bgr, ThreadTeam& team) {
  assert(similarity_ && bgr.type() == CV_8UC3);
  ++frame_;
  propagate(team);
  similarity_->loadColors(bgr, regionOfParticles(bgr.size()));
  weigh(team);
  const BoxEstimate result = estimateBox();
  resample();
  return result;
}

void SugandiTracker::copyParticles(int limit, Eigen::ArrayXXd& centers,
                                   Eigen::ArrayXd& weights) const {
  pickEvenly(weighted_, weights_, limit, 2, centers, weights);
}

std::size_t SugandiTracker::memoryBytes() const {
  const auto numbers =
      static_cast<std::size_t>(states_.size() + weighted_.size() + weights_.size());
  return sizeof(SugandiTracker) + sizeof(double) * numbers +
         (similarity_ ? similarity_->memoryBytes() : 0);
}

} // namespace dewpoint::tracking
