// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/click_box.h"

#include "core/color/color_region.h"
#include "core/observation/boxes/box_contrast.h"
#include "core/observation/boxes/box_without_margin.h"
#include "core/observation/boxes/fine_histogram.h"
#include "core/observation/boxes/target_colors.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace dewpoint::observation {
namespace {

// Origin: docs/method-sugandi.md has the steps; kMaxDistinctnessLoss was chosen on its clips, the
// origin of the other values is not recorded.

/// Sizes (square root of the area) in pixels of the reduced image; those of an image
/// that was made smaller are only what the larger one does not reach.
constexpr std::array<double, 8> kSizes{7.0, 8.5, 10.0, 12.0, 14.5, 17.0, 20.5, 24.0};
constexpr std::size_t kFirstOfSmaller = 4;
constexpr std::array<double, 7> kAspects{0.35, 0.5, 0.71, 1.0, 1.41, 2.0, 2.9};
constexpr double kLargest = 0.7;     ///< of the image's smaller side
constexpr double kClickReach = 80.0; ///< pixels around the click, in the reduced image
/// Steps of the click from the center, in sides of the box; it is taken to be normal about it.
constexpr int kClickSteps = 3;
constexpr double kStep = 0.1;
constexpr double kAim = 0.25;
/// Of the best score: a smaller object with so much is taken.
constexpr double kEnough = 0.8;
constexpr double kMargin = 1.3; ///< of the box in which the figure is sought, in its sides
/// Where the color region is grown: in sides of the object's box, and at least so many pixels.
constexpr double kNearby = 3.0;
constexpr double kLeastNearby = 640.0;
constexpr double kAgree = 0.5; ///< share in common from which two boxes mean the same object
/// Largest loss of distinctness of a larger box against the best one, 0 to 1.
constexpr double kMaxDistinctnessLoss = 0.09;

struct Candidate {
  ImageBox box;
  double score = 0.0;
};

/// A part of an image around a click, made smaller.
class Outlook {
public:
  Outlook(const cv::Mat& bgr, const Eigen::Vector2d& pixel, double scale)
      : part_(clippedToImage(ImageBox::around(pixel, std::max(2.0, 2.0 * kClickReach * scale),
                                              2.0 * kClickReach * scale),
                             bgr)),
        scale_(scale), click_((pixel - corner()) / scale), contrast_(smaller(bgr), click_) {}

  Candidate best(double size, double aspect) const {
    const double width = size * std::sqrt(aspect);
    const double height = size / std::sqrt(aspect);
    Candidate best;
    for (int i = -kClickSteps; i <= kClickSteps; ++i) {
      for (int j = -kClickSteps; j <= kClickSteps; ++j) {
        const Eigen::Vector2d off(kStep * i, kStep * j);
        const ImageBox box = ImageBox::around(
            click_ + Eigen::Vector2d(off.x() * width, off.y() * height), width, height);
        const double score =
            contrast_.contrastOf(box) * std::exp(-0.5 * off.squaredNorm() / (kAim * kAim));
        best = score > best.score ? Candidate{box, score} : best;
      }
    }
    best.box =
        ImageBox::around(corner() + scale_ * best.box.center(), scale_ * width, scale_ * height);
    return best;
  }

private:
  Eigen::Vector2d corner() const { return {part_.x, part_.y}; }
  cv::Mat smaller(const cv::Mat& bgr) const {
    cv::Mat small;
    if (scale_ == 1.0) {
      cv::GaussianBlur(bgr(part_), small, {3, 3}, 0.8);
      return small;
    }
    const auto side = [&](int pixels) { return std::max(1, static_cast<int>(pixels / scale_)); };
    cv::resize(bgr(part_), small, {side(part_.width), side(part_.height)}, 0, 0, cv::INTER_AREA);
    return small;
  }

  cv::Rect part_;
  double scale_;
  Eigen::Vector2d click_; ///< in the smaller image
  BoxContrast contrast_;
};

/// The best box of each size, by rising size.
std::vector<Candidate> bestOfSizes(const cv::Mat& bgr, const Eigen::Vector2d& pixel) {
  const double largest = kLargest * std::min(bgr.rows, bgr.cols);
  std::vector<Candidate> found;
  for (double scale = 1.0; kSizes[scale > 1.0 ? kFirstOfSmaller : 0] * scale <= largest;
       scale *= 2.0) {
    const Outlook outlook(bgr, pixel, scale);
    for (std::size_t i = scale > 1.0 ? kFirstOfSmaller : 0; i < kSizes.size(); ++i) {
      if (kSizes[i] * scale > largest) {
        break;
      }
      Candidate best;
      for (const double aspect : kAspects) {
        const Candidate next = outlook.best(kSizes[i], aspect);
        best = next.score > best.score ? next : best;
      }
      found.push_back(best);
    }
  }
  return found;
}

/// The smallest size that stands out among its neighbors and is nearly as good as the best of all:
/// a larger one that stands out is what the clicked object is part of, or lies on.
const Candidate* chosenOf(const std::vector<Candidate>& found) {
  const auto best = std::ranges::max_element(found, {}, &Candidate::score);
  for (auto one = found.begin(); one != found.end() && best->score > 0.0; ++one) {
    const bool rises = one == found.begin() || one->score > std::prev(one)->score;
    const bool falls = std::next(one) == found.end() || one->score >= std::next(one)->score;
    if (rises && falls && one->score >= kEnough * best->score) {
      return &*one;
    }
  }
  return nullptr;
}

ImageBox enlarged(const ImageBox& box, double times) {
  return ImageBox::around(box.center(), times * box.width, times * box.height);
}

ImageBox boxOf(const cv::Rect& pixels) {
  return {double(pixels.x), double(pixels.y), double(pixels.width), double(pixels.height)};
}

/// The bounding box of the color region at a pixel of an object, grown around that pixel.
ImageBox grownBox(const cv::Mat& bgr, const Eigen::Vector2d& pixel, const ImageBox& object) {
  const double side = std::max(kLeastNearby, kNearby * std::max(object.width, object.height));
  const cv::Rect part = clippedToImage(ImageBox::around(pixel, side, side), bgr);
  const cv::Point at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
  return boxOf(cv::boundingRect(growRegion(bgr(part), at - part.tl())) + part.tl());
}

/// The figure in a box that was found.
ImageBox figureOf(const cv::Mat& bgr, const Candidate& found) {
  return boxWithoutMargin(bgr, boxOf(clippedToImage(enlarged(found.box, kMargin), bgr)));
}

bool holdsMost(const ImageBox& box, const ImageBox& part) {
  return intersectionArea(box, part) >= kAgree * part.area();
}

/// How well the colors that would be learned from a box distinguish it from its surroundings: the
/// mean of TargetColors::similarityOf(), [0, 1].
double distinctness(const cv::Mat& bgr, const ImageBox& box) {
  TargetColors colors;
  colors.learn(bgr, box);
  return colors.similarityOf(bgr, box);
}

/// The largest figure that is nearly as distinct as the best one: a hand around a ball, or what is
/// behind it, is less distinct than the ball alone. Where the color region is part of the object,
/// the figure must contain it; if no such figure is distinct enough, the region is taken.
ImageBox largestDistinct(const cv::Mat& bgr, const std::vector<ImageBox>& figures,
                         const ImageBox& region, bool isPart) {
  std::vector<double> scores;
  std::ranges::transform(figures, std::back_inserter(scores),
                         [&](const ImageBox& figure) { return distinctness(bgr, figure); });
  const double most = std::max(std::ranges::max(scores), isPart ? distinctness(bgr, region) : 0.0);
  ImageBox largest = isPart ? region : ImageBox{};
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (scores[i] >= most - kMaxDistinctnessLoss && figures[i].area() > largest.area() &&
        (!isPart || holdsMost(figures[i], region))) {
      largest = figures[i];
    }
  }
  return largest;
}

} // namespace

std::optional<ImageBox> boxAroundClick(const cv::Mat& bgr, const Eigen::Vector2d& pixel) {
  const std::vector<Candidate> found = bestOfSizes(bgr, pixel);
  const Candidate* chosen = chosenOf(found);
  if (chosen == nullptr) {
    return std::nullopt;
  }
  const ImageBox object = figureOf(bgr, *chosen);
  const ImageBox region = grownBox(bgr, pixel, object);
  if (intersectionOverUnion(region, object) >= kAgree) {
    return region;
  }
  std::vector<ImageBox> figures;
  for (const Candidate* one = found.data(); one < chosen; ++one) {
    if (one->score > 0.0) {
      figures.push_back(figureOf(bgr, *one));
    }
  }
  figures.push_back(object);
  const ImageBox box = largestDistinct(bgr, figures, region, holdsMost(object, region));
  return intersectionOverUnion(region, box) >= kAgree ? region : box;
}

} // namespace dewpoint::observation
