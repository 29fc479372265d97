// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/background_model.h"

#include "core/base/vector_kernel.h"
#include "core/observation/background/label_image.h"
#include "core/observation/background/light_change.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 2).

constexpr int kRowPhases = 4; ///< every frame learns every fourth row
constexpr int kObservationsUntilKnown = BackgroundModel::kObservationsUntilKnown;
constexpr int kMostConfident = 16; ///< agreeing observations, remembered at most
constexpr int kReplaceAfter = 24;  ///< observations of something new that replace the old
/// Observations of what is usual, while every target is elsewhere, that count as a background
/// image: one more than it takes to know a pixel.
constexpr int kEmptyAfter = 4;
/// Of familiar_, above any number of observations.
constexpr std::uint8_t kFromBackgroundImage = 255;

/// The mean goes half the way to a new value while it is young, later an eighth.
constexpr int kYoungShift = 1;
constexpr int kOldShift = 3;

/// 1 where a channel is the usual one, else 0. In bytes throughout: 14 + 255 / 8 fits one.
DEWPOINT_KERNEL std::uint8_t channelAgrees(std::uint8_t value, std::uint8_t mean) {
  const std::uint8_t higher = value > mean ? value : mean;
  const std::uint8_t lower = value > mean ? mean : value;
  const auto size = static_cast<std::uint8_t>(higher - lower);
  const auto allowed = static_cast<std::uint8_t>(BackgroundModel::kBaseTolerance +
                                                 (mean >> BackgroundModel::kToleranceShiftBits));
  return size <= allowed ? 1 : 0;
}

struct AgreeKernel {
  /// agree[i] = 1 where pixel i (three bytes) shows what is usual there.
  DEWPOINT_KERNEL void run(const std::uint8_t* pixel, const std::uint8_t* mean, std::int64_t count,
                           std::uint8_t* agree) {
    constexpr std::int64_t kBlock = 512;
    std::uint8_t channels[3 * kBlock]; // compared as they lie; only the answers are taken apart
    for (std::int64_t begin = 0; begin < count; begin += kBlock) {
      const std::int64_t length = count - begin < kBlock ? count - begin : kBlock;
      const std::uint8_t* __restrict now = pixel + 3 * begin;
      const std::uint8_t* __restrict usual = mean + 3 * begin;
      std::uint8_t* __restrict out = agree + begin;
      for (std::int64_t i = 0; i < 3 * length; ++i) {
        channels[i] = channelAgrees(now[i], usual[i]);
      }
      for (std::int64_t i = 0; i < length; ++i) {
        out[i] = channels[3 * i] & channels[3 * i + 1] & channels[3 * i + 2];
      }
    }
  }
};

/// All bits set where the condition holds: selections by masks stay within bytes, which keeps the
/// loops as wide as the processor can.
DEWPOINT_KERNEL std::uint8_t mask(bool condition) {
  return condition ? std::uint8_t{0xFF} : std::uint8_t{0};
}
DEWPOINT_KERNEL std::uint8_t select(std::uint8_t mask, std::uint8_t yes, std::uint8_t no) {
  return static_cast<std::uint8_t>((yes & mask) | (no & ~mask));
}

struct LabelKernel {
  /// Overwrites label[i], 1 where the pixel shows what is usual there, by its label.
  DEWPOINT_KERNEL void run(const std::uint8_t* confidence, const std::uint8_t* matched,
                           std::int64_t count, std::uint8_t* label) {
    constexpr auto kBackground = static_cast<std::uint8_t>(PixelLabel::Background);
    constexpr auto kUnknown = static_cast<std::uint8_t>(PixelLabel::Unknown);
    constexpr auto kUnlearned = static_cast<std::uint8_t>(PixelLabel::Unlearned);
    constexpr auto kTarget = static_cast<std::uint8_t>(PixelLabel::Target);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::uint8_t known = select(mask(label[i] != 0), kBackground, kUnknown);
      const std::uint8_t rest =
          select(mask(confidence[i] >= kObservationsUntilKnown), known, kUnlearned);
      const std::uint8_t relit = mask((matched[i] != 0) & (rest != kBackground));
      label[i] = select(mask(matched[i] == 0xFF) | relit, kTarget, rest);
    }
  }
};

struct FamiliarKernel {
  /// Overwrites Target by Explained where the background image is seen: `agree` is 1 there and
  /// `familiar` at least kEmptyAfter.
  DEWPOINT_KERNEL void run(const std::uint8_t* familiar, const std::uint8_t* agree,
                           std::int64_t count, std::uint8_t* label) {
    constexpr auto kExplained = static_cast<std::uint8_t>(PixelLabel::Explained);
    constexpr auto kTarget = static_cast<std::uint8_t>(PixelLabel::Target);
    for (std::int64_t i = 0; i < count; ++i) {
      const std::uint8_t empty =
          mask((label[i] == kTarget) & (agree[i] != 0) & (familiar[i] >= kEmptyAfter));
      label[i] = select(empty, kExplained, label[i]);
    }
  }
};

/// What becomes of a pixel: keep its mean, move it a little or half the way, or replace it.
enum Move : std::uint8_t { Keep, MoveOld, MoveYoung, Replace };

struct CountKernel {
  /// Updates confidence and novelty; move[i] (1 where the pixel shows what is usual) becomes what
  /// is to be done with the mean. news[i]: 1 known and usual, 2 known and new, 0 not known.
  DEWPOINT_KERNEL void run(std::int64_t count, std::uint8_t* move, std::uint8_t* confidence,
                           std::uint8_t* novel, std::uint8_t* news) {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::uint8_t usual = mask(move[i] != 0);
      const std::uint8_t known = mask(confidence[i] >= kObservationsUntilKnown);
      const auto waited = static_cast<std::uint8_t>(novel[i] + 1);
      const std::uint8_t late = mask(waited >= kReplaceAfter);
      const auto replace = static_cast<std::uint8_t>(~usual & (~known | late));
      const std::uint8_t young = mask(confidence[i] < kMostConfident);
      const auto more = static_cast<std::uint8_t>(confidence[i] + (young & 1));
      move[i] = select(usual, select(known, MoveOld, MoveYoung), select(replace, Replace, Keep));
      news[i] = static_cast<std::uint8_t>(known & select(usual, 1, 2));
      novel[i] = static_cast<std::uint8_t>(waited & ~usual & ~replace);
      confidence[i] = select(usual, more, select(replace, 1, confidence[i]));
    }
  }
};

struct ForgetKernel {
  /// familiar = 0 where the mean is replaced.
  DEWPOINT_KERNEL void run(const std::uint8_t* move, std::int64_t count, std::uint8_t* familiar) {
    for (std::int64_t i = 0; i < count; ++i) {
      familiar[i] &= static_cast<std::uint8_t>(~mask(move[i] == Replace));
    }
  }
};

struct ProveKernel {
  /// Counts one more observation without a target where a pixel shows what is usual, which moves
  /// its mean a little or half the way.
  DEWPOINT_KERNEL void run(const std::uint8_t* move, std::int64_t count, std::uint8_t* familiar) {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::uint8_t more =
          mask(((move[i] == MoveOld) | (move[i] == MoveYoung)) & (familiar[i] < kEmptyAfter));
      familiar[i] = static_cast<std::uint8_t>(familiar[i] + (more & 1));
    }
  }
};

struct TallyKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* news, std::int64_t count, std::int64_t* known,
                           std::int64_t* fresh) {
    std::int32_t knownHere = 0;
    std::int32_t freshHere = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      knownHere += news[i] != 0 ? 1 : 0;
      freshHere += news[i] >> 1;
    }
    *known += knownHere;
    *fresh += freshHere;
  }
};

struct MoveKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* pixel, const std::uint8_t* move, std::int64_t count,
                           std::uint8_t* mean) {
    for (std::int64_t i = 0; i < count; ++i) {
      for (int channel = 0; channel < 3; ++channel) {
        const std::int64_t at = 3 * i + channel;
        const auto difference = static_cast<std::int16_t>(pixel[at] - mean[at]);
        const auto old =
            static_cast<std::int16_t>((difference + (1 << (kOldShift - 1))) >> kOldShift);
        const auto young = static_cast<std::int16_t>((difference + 1) >> kYoungShift);
        const std::int16_t step = move[i] == MoveOld ? old : young;
        const auto stepped = static_cast<std::uint8_t>(mean[at] + step);
        const std::uint8_t changed = move[i] == Replace ? pixel[at] : stepped;
        mean[at] = move[i] == Keep ? mean[at] : changed;
      }
    }
  }
};

} // namespace

BackgroundModel::BackgroundModel(const BackgroundModel& other)
    : mean_(other.mean_.clone()), confidence_(other.confidence_.clone()),
      novel_(other.novel_.clone()), backgroundImage_(other.backgroundImage_),
      familiar_(other.familiar_.clone()), lightIsNew_(other.lightIsNew_), phase_(other.phase_),
      known_(other.known_), new_(other.new_), moves_(other.moves_), news_(other.news_),
      novelShare_(other.novelShare_), light_(other.light_) {}

BackgroundModel& BackgroundModel::operator=(BackgroundModel other) noexcept {
  std::swap(mean_, other.mean_);
  std::swap(confidence_, other.confidence_);
  std::swap(novel_, other.novel_);
  std::swap(backgroundImage_, other.backgroundImage_);
  std::swap(familiar_, other.familiar_);
  lightIsNew_ = other.lightIsNew_;
  phase_ = other.phase_;
  known_ = other.known_;
  new_ = other.new_;
  moves_.swap(other.moves_);
  news_.swap(other.news_);
  novelShare_ = other.novelShare_;
  light_ = other.light_;
  return *this;
}

std::size_t BackgroundModel::memoryBytes() const {
  return mean_.total() * mean_.elemSize() + confidence_.total() + novel_.total() +
         familiar_.total();
}

void BackgroundModel::reset() {
  mean_ = cv::Mat();
  light_.setOnes();
  novelShare_ = 0.0;
  phase_ = 0;
  familiar_ = cv::Mat();
  lightIsNew_ = false;
  if (backgroundImage_.type() == CV_8UC3 && !backgroundImage_.empty()) {
    start(backgroundImage_);
    confidence_.setTo(kMostConfident);
    familiar_ = cv::Mat(backgroundImage_.size(), CV_8UC1, cv::Scalar(kFromBackgroundImage));
    lightIsNew_ = true;
  }
}

void BackgroundModel::adaptToLight(const cv::Mat& image) {
  if (!mean_.empty() && mean_.size() == image.size() && image.type() == CV_8UC3) {
    if (const auto gain = estimateLightChange(image, mean_, confidence_, light_)) {
      cv::multiply(mean_, cv::Scalar((*gain)[0], (*gain)[1], (*gain)[2]), mean_);
      light_ = *gain * light_;
    }
  }
  if (lightIsNew_) { // the reference is the light of now, not that of the background image
    resetReferenceLight();
    lightIsNew_ = false;
  }
}

void BackgroundModel::start(const cv::Mat& image) {
  mean_ = image.clone();
  light_.setOnes();
  confidence_ = cv::Mat::zeros(image.size(), CV_8UC1);
  novel_ = cv::Mat::zeros(image.size(), CV_8UC1);
  familiar_ = cv::Mat();
  moves_.resize(static_cast<std::size_t>(image.cols));
  news_.resize(static_cast<std::size_t>(image.cols));
}

void BackgroundModel::learn(const cv::Mat& image, const std::vector<ExcludedCircle>& hidden,
                            bool noTargetElsewhere) {
  if (image.empty() || image.type() != CV_8UC3) {
    return;
  }
  if (mean_.size() != image.size()) {
    start(image);
  }
  known_ = 0;
  new_ = 0;
  if (noTargetElsewhere && familiar_.empty()) {
    familiar_ = cv::Mat::zeros(image.size(), CV_8UC1);
  }
  for (int row = phase_; row < image.rows; row += kRowPhases) {
    learnRow(image, row, hidden, noTargetElsewhere);
  }
  phase_ = (phase_ + 1) % kRowPhases;
  novelShare_ = known_ > 0 ? static_cast<double>(new_) / known_ : 0.0;
}

void BackgroundModel::forgetFamiliarPixels() {
  if (!familiar_.empty()) {
    familiar_.setTo(0, familiar_ < kFromBackgroundImage);
  }
}

void BackgroundModel::forgetFamiliarPixels(const ExcludedCircle& circle) {
  if (familiar_.empty()) {
    return;
  }
  cv::Mat inside = cv::Mat::zeros(familiar_.size(), CV_8UC1);
  cv::circle(inside, {cvRound(circle.center.x()), cvRound(circle.center.y())},
             static_cast<int>(std::ceil(circle.radius)), 255, cv::FILLED);
  familiar_.setTo(0, inside & (familiar_ < kFromBackgroundImage));
}

void BackgroundModel::learnPixels(const cv::Mat& image, int row, int begin, int end,
                                  bool noTargetElsewhere) {
  const std::int64_t count = end - begin;
  const std::uint8_t* pixel = image.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * begin;
  std::uint8_t* mean = mean_.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * begin;
  std::uint8_t* moves = moves_.data();
  runKernel<AgreeKernel>(pixel, static_cast<const std::uint8_t*>(mean), count, moves);
  runKernel<CountKernel>(count, moves, confidence_.ptr<std::uint8_t>(row) + begin,
                         novel_.ptr<std::uint8_t>(row) + begin, news_.data());
  if (!familiar_.empty()) {
    runKernel<ForgetKernel>(static_cast<const std::uint8_t*>(moves), count,
                            familiar_.ptr<std::uint8_t>(row) + begin);
  }
  if (noTargetElsewhere) {
    runKernel<ProveKernel>(static_cast<const std::uint8_t*>(moves), count,
                           familiar_.ptr<std::uint8_t>(row) + begin);
  }
  runKernel<MoveKernel>(pixel, static_cast<const std::uint8_t*>(moves), count, mean);
  runKernel<TallyKernel>(static_cast<const std::uint8_t*>(news_.data()), count, &known_, &new_);
}

void BackgroundModel::learnRow(const cv::Mat& image, int row,
                               const std::vector<ExcludedCircle>& hidden, bool noTargetElsewhere) {
  int begin = 0;
  while (begin < image.cols) {
    // The next stretch of the row that no target hides.
    int end = image.cols;
    for (const ExcludedCircle& circle : hidden) {
      const double above = row - circle.center.y();
      const double halfSquared = circle.radius * circle.radius - above * above;
      if (!(halfSquared > 0.0)) {
        continue;
      }
      const double half = std::sqrt(halfSquared);
      const double columns = image.cols;
      const int left = static_cast<int>(std::clamp(circle.center.x() - half, 0.0, columns));
      const int right = static_cast<int>(std::clamp(circle.center.x() + half + 1.0, 0.0, columns));
      if (begin >= left && begin < right) {
        begin = right;
        end = std::max(end, begin);
      } else if (left > begin) {
        end = std::min(end, left);
      }
    }
    if (begin < end) {
      learnPixels(image, row, begin, end, noTargetElsewhere);
    }
    begin = std::max(begin, end);
  }
}

void BackgroundModel::labelRow(const cv::Mat& image, int column, int row, int count,
                               const std::uint8_t* matched, std::uint8_t* labels) const {
  static const std::vector<std::uint8_t> nothingKnown(16384, 0);
  const bool known = mean_.size() == image.size();
  const std::uint8_t* confidence = nothingKnown.data();
  if (known) {
    confidence = confidence_.ptr<std::uint8_t>(row) + column;
    runKernel<AgreeKernel>(image.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * column,
                           mean_.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * column,
                           std::int64_t{count}, labels);
  }
  const std::int64_t most = known ? count : std::min<std::int64_t>(count, std::ssize(nothingKnown));
  const bool familiar = known && !familiar_.empty();
  const std::vector<std::uint8_t> agree(labels, labels + (familiar ? count : 0));
  runKernel<LabelKernel>(confidence, matched, most, labels);
  if (familiar) {
    runKernel<FamiliarKernel>(familiar_.ptr<std::uint8_t>(row) + column, agree.data(),
                              std::int64_t{count}, labels);
  }
}

} // namespace dewpoint::observation
