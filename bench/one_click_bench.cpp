// SPDX-License-Identifier: GPL-3.0-or-later
// How often one click in one camera finds the target in the others: a click anywhere on the target
// but its rim, in the first images of the accuracy suite's runs, and what learnFromClicks() makes
// of it.
//   one_click_bench GRADE FIRST_SEED LAST_SEED [SCENARIO ...]     (default: those of family S22)
#include "core/color/color_classifier.h"
#include "core/color/color_learning.h"
#include "core/color/match_image.h"
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/random_draws.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/geometry/sphere_image.h"
#include "core/setup/clicks/click_learning.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr double kWithin = 0.8;     // radii of the disc that is clicked, as in S22
constexpr double kSlackRadii = 0.3; // around the disc: a ball may be late by half a frame
constexpr double kMostlyMatched = 0.5;

/// How often a target that an image shows was found there.
struct Tally {
  int clicks = 0, views = 0;
  int right = 0, wrong = 0;    // samples found in other cameras
  int matched = 0, before = 0; // views in which the range separates the target, with and without

  void add(const Tally& other) {
    clicks += other.clicks;
    views += other.views;
    right += other.right;
    wrong += other.wrong;
    matched += other.matched;
    before += other.before;
  }
};

std::optional<SphereImage> discIn(const Camera& camera, const Eigen::Vector3d& center,
                                  double radius) {
  const auto disc = SphereProjector(camera).project(center, radius);
  const Intrinsics& size = camera.intrinsics;
  const bool inside = disc && disc->center.x() > disc->radius && disc->center.y() > disc->radius &&
                      disc->center.x() < size.width - disc->radius &&
                      disc->center.y() < size.height - disc->radius;
  return inside ? disc : std::nullopt;
}

/// Whether the largest object that matches is the target, and most of the target matches.
bool separates(const ColorRange& range, const cv::Mat& image, const SphereImage& disc) {
  const cv::Mat match = matchImage(image, ColorClassifier(range));
  cv::Mat labels, statistics, centers;
  const int count = cv::connectedComponentsWithStats(match, labels, statistics, centers);
  int largest = 0;
  for (int i = 1; i < count; ++i) {
    if (largest == 0 ||
        statistics.at<int>(i, cv::CC_STAT_AREA) > statistics.at<int>(largest, cv::CC_STAT_AREA)) {
      largest = i;
    }
  }
  if (largest == 0) {
    return false;
  }
  const Eigen::Vector2d center(centers.at<double>(largest, 0), centers.at<double>(largest, 1));
  cv::Mat mask = cv::Mat::zeros(image.size(), CV_8UC1);
  cv::circle(mask, {int(std::lround(disc.center.x())), int(std::lround(disc.center.y()))},
             std::max(1, int(std::lround(0.8 * disc.radius))), cv::Scalar(255), cv::FILLED);
  const double share = double(cv::countNonZero(match & mask)) / cv::countNonZero(mask);
  return (center - disc.center).norm() < (1.0 + kSlackRadii) * disc.radius &&
         share > kMostlyMatched;
}

Tally tryRun(const ScenarioRun& run, bool verbose) {
  Tally tally;
  const FrameSetPtr first = run.frames(0);
  setup::ClickedImages shown;
  for (const FramePtr& frame : first->frames) {
    shown.images.push_back(frame ? frame->image : cv::Mat());
  }
  const TrajectorySample* truth = nullptr;
  for (const TrajectorySample& sample : run.truth.samples) {
    if (sample.frame == 0 && sample.target == run.targets.front().name && sample.isValid) {
      truth = &sample;
    }
  }
  if (truth == nullptr) {
    return tally;
  }
  const double radius =
      run.extents.empty() ? run.targets.front().radius : run.extents.front().radius;
  std::vector<std::optional<SphereImage>> discs;
  std::vector<std::size_t> showing;
  for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
    discs.push_back(shown.images[camera].empty()
                        ? std::nullopt
                        : discIn(run.trueRig[camera], truth->position, radius));
    if (discs.back()) {
      showing.push_back(camera);
    }
  }
  if (showing.size() < 2) {
    return tally;
  }
  experiment::RandomDraws draws(run.seed, run.scenario + " one click");
  const std::size_t clicked =
      showing[static_cast<std::size_t>(draws.drawInteger(0, int(showing.size()) - 1))];
  const double aside = kWithin * std::sqrt(draws.drawUniform(0.0, 1.0)) * discs[clicked]->radius;
  const double angle = draws.drawUniform(0.0, experiment::kFullTurn);
  ColorSample place;
  place.camera = int(clicked);
  place.x = std::round(discs[clicked]->center.x() + aside * std::cos(angle));
  place.y = std::round(discs[clicked]->center.y() + aside * std::sin(angle));
  const auto sample = takeSample(shown.images[clicked], place);
  if (!sample) {
    return tally;
  }
  tally.clicks = 1;
  tally.views = int(showing.size()) - 1;
  const auto lesson = setup::learnFromClicks(run.rig, shown, {*sample});
  const auto before = learnColor({*sample}, shown.images);
  if (!lesson || !before) {
    return tally;
  }
  for (const ColorSample& found : lesson->samples) {
    if (found.isFoundByGeometry) {
      const auto& disc = discs[std::size_t(found.camera)];
      const bool right = disc && (Eigen::Vector2d(found.x, found.y) - disc->center).norm() <
                                     (1.0 + kSlackRadii) * disc->radius;
      (right ? tally.right : tally.wrong) += 1;
      if (verbose && !right) {
        fmt::print("  {} {} camera {} found {},{} ({} px); is {:.0f},{:.0f} r {:.1f}; click {} "
                   "{},{} ({} px)\n",
                   run.scenario, run.seed, found.camera, found.x, found.y, found.areaPx,
                   disc ? disc->center.x() : -1.0, disc ? disc->center.y() : -1.0,
                   disc ? disc->radius : 0.0, clicked, place.x, place.y, sample->areaPx);
      }
    }
  }
  for (const std::size_t camera : showing) {
    if (camera != clicked) {
      const bool now = separates(lesson->color.range, shown.images[camera], *discs[camera]);
      const bool then = separates(before->range, shown.images[camera], *discs[camera]);
      tally.matched += now;
      tally.before += then;
      if (verbose && !now) {
        fmt::print("  {} {} camera {} not separated; {} found\n", run.scenario, run.seed, camera,
                   lesson->samples.size() - 1);
      }
    }
  }
  return tally;
}

void print(const std::string& name, const Tally& tally) {
  const auto share = [&](int count) { return 100.0 * count / std::max(1, tally.views); };
  fmt::print("{:24} {:4} clicks {:4} views  found {:5.1f} %  wrong {:5.1f} %  separated {:5.1f} % "
             "(one camera alone {:5.1f} %)\n",
             name, tally.clicks, tally.views, share(tally.right), share(tally.wrong),
             share(tally.matched), share(tally.before));
  std::fflush(stdout);
}

} // namespace
} // namespace dewpoint::bench

int main(int argc, char** argv) {
  using namespace dewpoint;
  using namespace dewpoint::bench;
  if (argc < 4) {
    fmt::print("usage: one_click_bench GRADE FIRST_SEED LAST_SEED [SCENARIO ...]\n");
    return 2;
  }
  const auto grade = experiment::gradeFromName(argv[1]);
  if (!grade) {
    fmt::print("there is no grade {}\n", argv[1]);
    return 2;
  }
  const std::vector<std::string> wanted(argv + 4, argv + argc);
  Tally all;
  for (const experiment::ScenarioDeclaration& scenario : experiment::scenarioCatalog()) {
    const bool isWanted = wanted.empty() ? scenario.family == "S22"
                                         : std::ranges::count(wanted, scenario.name) > 0 ||
                                               std::ranges::count(wanted, scenario.family) > 0;
    if (!isWanted || scenario.isRecorded) {
      continue;
    }
    Tally tally;
    for (auto seed = std::strtoull(argv[2], nullptr, 10);
         seed <= std::strtoull(argv[3], nullptr, 10); ++seed) {
      if (const auto run = scenario.make(seed, *grade)) {
        tally.add(tryRun(*run, std::getenv("VERBOSE") != nullptr));
      }
    }
    print(scenario.name, tally);
    all.add(tally);
  }
  print("all", all);
  return 0;
}
