// SPDX-License-Identifier: GPL-3.0-or-later
//
// From how many particles on is it cheaper to evaluate the color of a whole image than that of the
// 5x5 windows alone? Barrera et al. 2005, section III-A, count pixels: 25 N against 320 x 240, so
// windows are worthwhile for N < 3072. Here both are timed, in turn and in one run, for the
// arithmetic of the paper (a conversion to HSI with an arc cosine per pixel) and for the product,
// which switches by itself at ColorWindow's own number. One QVGA image that is new at each
// iteration; the fastest of many repetitions counts.
#include "bench/ball_scene.h"
#include "core/base/random.h"
#include "core/color/hsi.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr std::array<Eigen::Index, 10> kCounts{100,  200,  400,  800,  1280,
                                               2000, 3072, 4500, 7000, 12000};
constexpr int kRepetitions = 30;
constexpr double kCloudSigma = 0.1;                   ///< meters: windows all over the image
constexpr std::int64_t kWhole = 1'000'000'000;        ///< windows: more than any image has pixels
constexpr int kPaperCount = 320 * 240 / 25;           ///< 3072
const Eigen::Vector3d kCloudCenter(0.35, 0.45, 0.15); ///< world, meters: the scene's ball

/// Particles all over the image, rows x y z.
Eigen::ArrayXXd cloud() {
  const RandomStream stream(1, 0, 0, RandomPurpose::Simulation);
  Eigen::ArrayXXd states(kCounts.back(), 3);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    const auto normal = stream.normal4(static_cast<std::uint32_t>(i));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      states(i, axis) = kCloudCenter[axis] + kCloudSigma * normal[static_cast<std::size_t>(axis)];
    }
  }
  return states;
}

/// The paper's rule with the colors of the whole image found first.
class NaiveWholeImage {
public:
  explicit NaiveWholeImage(const NaiveColorWindow& naive) : naive_(naive) {}

  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) {
    const cv::Mat& image = naive_.images[0];
    matches_.create(image.size(), CV_8UC1);
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const auto& pixel = image.at<cv::Vec3b>(y, x);
        matches_.at<unsigned char>(y, x) =
            matches(hsiFromBgr(pixel[0], pixel[1], pixel[2]), naive_.range) ? 1 : 0;
      }
    }
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const auto pixel = naive_.projectors[0].project({rows(i, 0), rows(i, 1), rows(i, 2)});
      const double column = pixel ? std::floor(pixel->x() + 0.5) : -1.0;
      const double row = pixel ? std::floor(pixel->y() + 0.5) : -1.0;
      const bool inside = column >= 0.0 && column < image.cols && row >= 0.0 && row < image.rows;
      const int count = inside ? countAround(int(column), int(row)) : 0;
      logLikelihood[i] += std::log(std::max(count, 1) / 25.0);
    }
  }

private:
  int countAround(int column, int row) const {
    int count = 0;
    for (int y = std::max(row - 2, 0); y <= std::min(row + 2, matches_.rows - 1); ++y) {
      for (int x = std::max(column - 2, 0); x <= std::min(column + 2, matches_.cols - 1); ++x) {
        count += matches_.at<unsigned char>(y, x);
      }
    }
    return count;
  }

  const NaiveColorWindow& naive_;
  cv::Mat matches_;
};

using Evaluate = std::function<void(ConstStateRows rows, LogWeightSegment logLikelihood)>;

/// Windows alone and the whole image, by one arithmetic.
struct Contest {
  std::string name;
  Evaluate lazy;
  Evaluate whole;
};

double microseconds(const Evaluate& evaluate, ConstStateRows rows, Eigen::ArrayXd& logLikelihood) {
  logLikelihood.setZero();
  const auto begin = std::chrono::steady_clock::now();
  evaluate(rows, logLikelihood);
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  return took.count();
}

struct Times {
  double lazy = std::numeric_limits<double>::infinity(); ///< microseconds
  double whole = std::numeric_limits<double>::infinity();
};

/// The fastest of each, measured in turn; nothing when they differ in what they find.
std::optional<Times> measure(const Contest& contest, ConstStateRows rows) {
  Times times;
  Eigen::ArrayXd lazy(rows.rows());
  Eigen::ArrayXd whole(rows.rows());
  for (int k = 0; k < kRepetitions; ++k) {
    times.lazy = std::min(times.lazy, microseconds(contest.lazy, rows, lazy));
    times.whole = std::min(times.whole, microseconds(contest.whole, rows, whole));
  }
  return (lazy == whole).all() ? std::optional(times) : std::nullopt;
}

/// Particles at which both take as long, on a line between the counts beside it.
std::string crossing(const std::vector<Times>& all) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double now = all[k].lazy - all[k].whole;
    if (now < 0.0) {
      continue;
    }
    if (k == 0) {
      return fmt::format("below {}", kCounts.front());
    }
    const double before = all[k - 1].lazy - all[k - 1].whole;
    const double share = before / (before - now);
    return fmt::format("at about {:.0f}", double(kCounts.at(k - 1)) +
                                              share * double(kCounts.at(k) - kCounts.at(k - 1)));
  }
  return fmt::format("above {}", kCounts.back());
}

/// False when lazy and whole differ.
bool run(const Contest& contest, const Eigen::ArrayXXd& states) {
  fmt::print("{}\n{:>8} {:>12} {:>12} {:>12}\n", contest.name, "N", "windows, us", "image, us",
             "ratio");
  std::vector<Times> all;
  for (const Eigen::Index count : kCounts) {
    const auto times = measure(contest, states.topRows(count));
    if (!times) {
      fmt::print("the two differ in what they find\n");
      return false;
    }
    all.push_back(*times);
    fmt::print("{:>8} {:>12.1f} {:>12.1f} {:>12.2f}\n", count, times->lazy, times->whole,
               times->lazy / times->whole);
  }
  fmt::print(
      "windows alone stop paying {} particles (counted in pixels, as the paper does: {})\n\n",
      crossing(all), kPaperCount);
  return true;
}

int runAll() {
  BallScene scene({paperRig().front()}, kCounts.front());
  NaiveWholeImage naiveWhole(scene.naive);
  const auto product = [&](std::int64_t windows) {
    return [&scene, windows](ConstStateRows rows, LogWeightSegment logLikelihood) {
      scene.product.setImage(0, scene.images[0]);
      scene.product.prepare(windows);
      scene.product.addLogLikelihood(rows, logLikelihood);
    };
  };
  const std::vector<Contest> contests{
      {"the paper's arithmetic",
       [&](ConstStateRows rows, LogWeightSegment out) { scene.naive.addLogLikelihood(rows, out); },
       [&](ConstStateRows rows, LogWeightSegment out) { naiveWhole.addLogLikelihood(rows, out); }},
      {"the product", product(0), product(kWhole)}};
  const Eigen::ArrayXXd states = cloud();
  return std::ranges::all_of(contests, [&](const Contest& contest) { return run(contest, states); })
             ? 0
             : 1;
}

} // namespace
} // namespace dewpoint::bench

int main() {
  return dewpoint::bench::runAll();
}
