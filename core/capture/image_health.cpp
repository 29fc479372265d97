// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/image_health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

constexpr int kRows = 48;         ///< of an image that are looked at, evenly spaced. Chosen
constexpr int kBlackColumns = 64; ///< of these rows, for its brightness. Chosen
constexpr auto kRatePeriod = 2s;  ///< for which a rate is measured
/// After opening, before a camera can be slow: drivers settle, and buffers fill.
constexpr auto kSettling = 1500ms;
constexpr double kLeastRate = 4.0; ///< images per second; of a slower one, a second says nothing
/// A camera that sent its last image longer ago is silent, not slow.
constexpr auto kSilent = 500ms;
constexpr std::size_t kFewestImages = 7; ///< that repetition can be told from
/// Copies in a row that count as repetition; with more, the camera is rather frozen. Chosen.
constexpr int kMostCopies = 2;

/// The rows that are looked at.
template <class Use> void forRows(const cv::Mat& image, const Use& use) {
  const int count = std::min(kRows, image.rows);
  for (int k = 0; k < count; ++k) {
    use(image.ptr<std::uint8_t>((2 * k + 1) * image.rows / (2 * count)));
  }
}

/// FNV-1a over words of eight bytes.
std::uint64_t contentOf(const cv::Mat& image) {
  std::uint64_t hash = 14695981039346656037ULL;
  const std::size_t bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  forRows(image, [&](const std::uint8_t* row) {
    for (std::size_t at = 0; at < bytes; at += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, row + at, std::min(sizeof word, bytes - at));
      hash = (hash ^ word) * 1099511628211ULL;
    }
  });
  return hash;
}

bool isBlack(const cv::Mat& image) {
  int bright = 0;
  int all = 0;
  const int step = std::max(1, image.cols / kBlackColumns);
  forRows(image, [&](const std::uint8_t* row) {
    for (int column = 0; column < image.cols; column += step) {
      const std::uint8_t* pixel = row + std::ptrdiff_t{3} * column;
      bright += std::max({pixel[0], pixel[1], pixel[2]}) > ImageHealth::kBlackLevel ? 1 : 0;
      ++all;
    }
  });
  return bright <= ImageHealth::kMaxBrightShareOfBlackImage * all;
}

using Since = std::optional<ImageHealth::Clock::time_point>;

void note(bool isSo, ImageHealth::Clock::time_point now, Since& since) {
  if (!isSo) {
    since.reset();
  } else if (!since) {
    since = now;
  }
}

} // namespace

ImageHealth::ImageHealth(double requestedRate, double delay)
    : requestedRate_(requestedRate), delay_(std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(std::max(0.0, delay)))) {}

void ImageHealth::restart(Clock::time_point now) {
  seen_.clear();
  blackSince_.reset();
  sameSince_.reset();
  lateSince_.reset();
  begun_ = now;
  periodBegin_ = now + kSettling;
  imagesOfPeriod_ = 0;
}

/// Whether an image was sent before: as the one before it, or earlier in the window.
bool ImageHealth::isRepeat(std::uint64_t content) const {
  const auto differs = [&](const Seen& image) { return image.contentHash != content; };
  const auto run = std::find_if(seen_.rbegin(), seen_.rend(), differs); // ends before the newest
  const auto copies = run - seen_.rbegin();
  return (copies > 0 && copies <= kMostCopies) ||
         (copies == 0 && std::ranges::find(seen_, content, &Seen::contentHash) != seen_.end());
}

void ImageHealth::learnRate(Clock::time_point now) {
  if (now < periodBegin_) {
    return;
  }
  ++imagesOfPeriod_;
  if (now - periodBegin_ >= kRatePeriod) {
    const double seconds = std::chrono::duration<double>(now - periodBegin_).count();
    bestRate_ = std::max(bestRate_, static_cast<double>(imagesOfPeriod_ - 1) / seconds);
    periodBegin_ = now;
    imagesOfPeriod_ = 1;
  }
}

void ImageHealth::add(const cv::Mat& image, Clock::time_point arrived,
                      std::optional<Clock::time_point> captured) {
  learnRate(arrived);
  if (!seen_.empty() && arrived - seen_.back().arrivalTime > kSilent) {
    begun_ = arrived;
  }
  while (!seen_.empty() && arrived - seen_.front().arrivalTime > kObservationPeriod) {
    seen_.pop_front();
  }
  const std::uint64_t content = contentOf(image);
  const bool isSame = !seen_.empty() && seen_.back().contentHash == content;
  const bool isRepeated = isRepeat(content);
  if (isSame && !sameSince_) {
    sameSince_ = seen_.back().arrivalTime;
  } else if (!isSame) {
    sameSince_.reset();
  }
  note(isBlack(image), arrived, blackSince_);
  note(captured && arrived - *captured > kMaxLatency + delay_, arrived, lateSince_);
  seen_.push_back({arrived, content, isRepeated});
}

/// Of a run of images that began then: whether the last one is long after it.
bool ImageHealth::isLongAgo(const std::optional<Clock::time_point>& since) const {
  return since && !seen_.empty() && seen_.back().arrivalTime - *since >= kMinFaultDuration;
}

bool ImageHealth::isSlow(Clock::time_point now) const {
  const double rate = expectedRate();
  if (rate < kLeastRate || seen_.empty() || now - seen_.back().arrivalTime > kSilent ||
      now - begun_ < kSettling) {
    return false;
  }
  const auto recent = std::ranges::count_if(
      seen_, [&](const Seen& image) { return now - image.arrivalTime < kObservationPeriod; });
  return static_cast<double>(recent) < kMinRateShare * rate;
}

bool ImageHealth::isRepeating() const {
  const auto repeated = std::ranges::count(seen_, true, &Seen::isRepeated);
  return seen_.size() >= kFewestImages &&
         static_cast<double>(repeated) >= kMinRepeatedShare * static_cast<double>(seen_.size());
}

std::optional<ImageFault> ImageHealth::fault(Clock::time_point now) const {
  if (isLongAgo(blackSince_)) {
    return ImageFault{ErrorCode::ImagesBlack, "is its lens covered, or the light off?"};
  }
  if (isLongAgo(sameSince_)) {
    return ImageFault{ErrorCode::ImagesFrozen, "it sends the same image all the time"};
  }
  if (isRepeating()) {
    return ImageFault{ErrorCode::ImagesRepeat, "at least three of ten were sent before"};
  }
  if (isLongAgo(lateSince_)) {
    return ImageFault{ErrorCode::ImagesLate,
                      fmt::format("more than {:g} s after they were captured",
                                  std::chrono::duration<double>(kMaxLatency + delay_).count())};
  }
  if (isSlow(now)) {
    return ImageFault{ErrorCode::ImagesFew,
                      fmt::format("fewer than {:.0f} per second instead of {:.0f}",
                                  kMinRateShare * expectedRate(), expectedRate())};
  }
  return std::nullopt;
}

bool isImageFault(ErrorCode code) {
  return code >= ErrorCode::ImagesBlack && code <= ErrorCode::ImagesFew;
}

} // namespace dewpoint::capture
