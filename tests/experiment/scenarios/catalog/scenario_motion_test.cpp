// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/time.h"
#include "core/color/match_image.h"
#include "core/experiment/baselines/baseline_blobs.h"
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/scenario.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

/// The targets' true places at a frame in which all are there.
std::vector<Eigen::Vector3d> validTruthAt(const ScenarioRun& run, std::int64_t frame) {
  const auto first = static_cast<std::size_t>(frame) * run.targets.size();
  for (std::size_t k = first; k < first + run.targets.size(); ++k) {
    EXPECT_TRUE(run.truth.samples.at(k).isValid);
  }
  return truthAt(run, frame);
}

/// The matching pixels within 1.3 radii of a disc's middle: how many per pixel of the disc, and
/// how far their center of mass is from its middle.
struct Match {
  double share = 0.0;
  double offPx = 0.0;
};

Match matchOf(const cv::Mat& image, const Target& target, const ImageDisc& disc) {
  const cv::Mat mask = matchImage(image, ColorClassifier(target.color));
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int row = 0; row < mask.rows; ++row) {
    for (int column = 0; column < mask.cols; ++column) {
      const Eigen::Vector2d pixel(column, row);
      if (mask.at<std::uint8_t>(row, column) != 0 &&
          (pixel - disc.center).norm() < 1.3 * disc.radius) {
        sum += pixel;
        ++count;
      }
    }
  }
  const double all = 3.14159 * disc.radius * disc.radius;
  return {count / all, count > 0 ? (sum / count - disc.center).norm() : HUGE_VAL};
}

/// True if no other target's disc touches that of `target`.
bool standsAlone(const std::vector<ImageDisc>& discs, std::size_t target) {
  for (std::size_t other = 0; other < discs.size(); ++other) {
    if (other != target && (discs[other].center - discs[target].center).norm() <
                               1.4 * (discs[other].radius + discs[target].radius)) {
      return false;
    }
  }
  return true;
}

/// Each ball that stands alone in an image is where its truth re-projects to: most of its disc
/// matches (the ball's shaded side may not), and what matches is centered within a fifth of the
/// radius or so (a shaded rim moves the center of mass).
void expectTruthInImages(const ScenarioRun& run, std::int64_t frame) {
  const FrameSetPtr set = run.frames(frame);
  const auto places = validTruthAt(run, frame);
  int seen = 0;
  for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
    std::vector<ImageDisc> discs;
    for (std::size_t k = 0; k < places.size(); ++k) {
      discs.push_back(discOf(run.trueRig[camera], places[k], run.targets[k].radius));
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (set->frames[camera] == nullptr || !standsAlone(discs, k)) {
        continue;
      }
      ++seen;
      const Match match = matchOf(set->frames[camera]->image, run.targets[k], discs[k]);
      EXPECT_GT(match.share, 0.7) << run.scenario << " camera " << camera << " frame " << frame;
      EXPECT_LT(match.offPx, 0.25 * discs[k].radius)
          << run.scenario << " camera " << camera << " frame " << frame;
    }
  }
  EXPECT_GT(seen, 0) << run.scenario;
}

void expectBitsOfSeed(const std::string& name, std::int64_t frame) {
  const FrameSetPtr one = scenarioRun(name).frames(frame);
  const FrameSetPtr same = scenarioRun(name).frames(frame);
  const FrameSetPtr other = scenarioRun(name, 2).frames(frame);
  for (std::size_t camera = 0; camera < one->frames.size(); ++camera) {
    ASSERT_EQ(one->frames[camera] == nullptr, same->frames[camera] == nullptr);
    if (one->frames[camera] == nullptr) {
      continue;
    }
    const cv::Mat& image = one->frames[camera]->image;
    EXPECT_EQ(cv::norm(image, same->frames[camera]->image, cv::NORM_INF), 0.0) << name;
    EXPECT_EQ(one->frames[camera]->captureTime, same->frames[camera]->captureTime);
    if (other->frames[camera] != nullptr) {
      EXPECT_GT(cv::norm(image, other->frames[camera]->image, cv::NORM_INF), 0.0) << name;
    }
  }
}

std::vector<ScenarioEvent> eventsOf(const ScenarioRun& run, ScenarioEvent::Kind kind) {
  std::vector<ScenarioEvent> events;
  std::ranges::copy_if(run.events, std::back_inserter(events),
                       [&](const ScenarioEvent& event) { return event.kind == kind; });
  return events;
}

TEST(Scenarios, TruthIsWhatTheImagesShow) {
  for (const std::string name : {"S0-slow", "S5-two", "S5-four", "S6-2", "S6-4", "S6-dropouts"}) {
    const ScenarioRun run = scenarioRun(name);
    expectTruthInImages(run, 0);
    expectTruthInImages(run, run.frameCount / 2);
  }
}

TEST(Scenarios, SameSeedSameBits) {
  for (const std::string name : {"S5-two", "S6-3", "S6-dropouts", "S7-offsets", "S7-rates",
                                 "S8-ramp", "S8-temperature", "S9-bump"}) {
    expectBitsOfSeed(name, 100);
  }
}

TEST(ScenarioOcclusion, HalfOfTheDiscIsHiddenInOneCamera) {
  for (const std::string name : {"S2-still", "S2-moving", "S2-three-cameras"}) {
    const ScenarioRun run = scenarioRun(name);
    // The moving plate is in its place from 1.3 s, frame 39, on.
    for (const std::int64_t frame : {40, 90, 140, 179}) {
      std::vector<double> shares;
      for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
        const ImageDisc disc =
            discOf(run.trueRig[camera], validTruthAt(run, frame)[0], run.targets[0].radius);
        const cv::Mat image = run.frames(frame)->frames[camera]->image;
        shares.push_back(matchOf(image, run.targets[0], disc).share);
      }
      std::ranges::sort(shares);
      EXPECT_GT(shares[1], 0.7) << name << " frame " << frame << ": all others see the ball";
      EXPECT_GT(shares[0] / shares[1], 0.35) << name << " frame " << frame;
      EXPECT_LT(shares[0] / shares[1], 0.65) << name << " frame " << frame;
    }
  }
}

TEST(ScenarioBlackout, OnlyTheBlindCamerasAreDark) {
  for (const std::string name : {"S3-one-blind", "S3-one-blind-three-cameras", "S3-all-blind"}) {
    const ScenarioRun run = scenarioRun(name);
    const auto begins = eventsOf(run, ScenarioEvent::Kind::BlackoutBegin);
    const auto ends = eventsOf(run, ScenarioEvent::Kind::BlackoutEnd);
    ASSERT_EQ(begins.size(), 2U);
    ASSERT_EQ(ends.size(), 2U);
    for (std::size_t k = 0; k < begins.size(); ++k) {
      EXPECT_EQ(ends[k].frame - begins[k].frame, 15) << "0.5 s";
      for (const std::int64_t frame :
           {begins[k].frame - 1, begins[k].frame, ends[k].frame - 1, ends[k].frame}) {
        const FrameSetPtr set = run.frames(frame);
        for (std::size_t camera = 0; camera < run.rig.size(); ++camera) {
          const bool blind = frame >= begins[k].frame && frame < ends[k].frame &&
                             (begins[k].camera < 0 || begins[k].camera == static_cast<int>(camera));
          // Without light there is the positive half of the noise of 3 gray levels: 1.2 on average.
          EXPECT_EQ(cv::mean(set->frames[camera]->image)[0] < 3.0, blind)
              << name << " camera " << camera << " frame " << frame;
        }
      }
    }
  }
}

TEST(ScenarioCrossing, BallsNeverTouchButPassBeforeEachOther) {
  const std::map<std::string, std::pair<std::size_t, std::int64_t>> expected{
      {"S5-two", {2, 600}}, {"S5-four", {4, 600}}, {"S5-eight", {8, 3600}}};
  for (const auto& [name, size] : expected) {
    const ScenarioRun run = scenarioRun(name);
    ASSERT_EQ(run.targets.size(), size.first);
    EXPECT_EQ(run.frameCount, size.second);
    EXPECT_EQ(run.framesPerSecond, 30.0);
    EXPECT_EQ(run.rig.size(), 4U);
    double nearest = HUGE_VAL;
    int covered = 0;
    for (std::int64_t frame = 0; frame < run.frameCount; ++frame) {
      const auto places = validTruthAt(run, frame);
      for (std::size_t k = 1; k < places.size(); ++k) {
        for (std::size_t other = 0; other < k; ++other) {
          nearest = std::min(nearest, (places[k] - places[other]).norm());
          for (const Camera& camera : run.trueRig) {
            const ImageDisc one = discOf(camera, places[k], run.targets[k].radius);
            const ImageDisc two = discOf(camera, places[other], run.targets[other].radius);
            covered += (one.center - two.center).norm() < one.radius ? 1 : 0;
          }
        }
      }
    }
    EXPECT_GE(nearest, 2.5 * run.targets[0].radius) << name;
    EXPECT_GT(covered, 0) << name << ": one ball before the other in some image";
    // The search's box holds all of them.
    for (const Eigen::Vector3d& place : validTruthAt(run, 0)) {
      EXPECT_TRUE(((place - run.startCenter).array().abs() <= run.startHalfSize.array()).all())
          << name;
    }
  }
}

TEST(ScenarioCameras, OnePerName) {
  for (const int count : {2, 3, 4, 6, 8}) {
    const ScenarioRun run = scenarioRun("S6-" + std::to_string(count));
    EXPECT_EQ(run.rig.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(run.frames(3)->frames.size(), static_cast<std::size_t>(count));
  }
}

TEST(ScenarioCameras, DropOutOneAfterAnother) {
  const ScenarioRun run = scenarioRun("S6-dropouts");
  const auto gone = eventsOf(run, ScenarioEvent::Kind::CameraLost);
  const auto back = eventsOf(run, ScenarioEvent::Kind::CameraBack);
  ASSERT_EQ(gone.size(), 4U);
  ASSERT_EQ(back.size(), 4U);
  std::vector<bool> had(4, false);
  for (std::size_t k = 0; k < gone.size(); ++k) {
    ASSERT_EQ(gone[k].camera, back[k].camera);
    had.at(static_cast<std::size_t>(gone[k].camera)) = true;
    for (const std::int64_t frame :
         {gone[k].frame - 1, gone[k].frame, back[k].frame - 1, back[k].frame}) {
      const FrameSetPtr set = run.frames(frame);
      for (int camera = 0; camera < 4; ++camera) {
        const bool away =
            camera == gone[k].camera && frame >= gone[k].frame && frame < back[k].frame;
        EXPECT_EQ(set->frames[static_cast<std::size_t>(camera)] == nullptr, away)
            << "camera " << camera << " frame " << frame;
      }
    }
  }
  EXPECT_TRUE(std::ranges::all_of(had, std::identity{})) << "each camera has its turn";
}

/// Seconds from the set's time to each camera's exposure; NaN where there is no frame.
std::vector<double> delaysOf(const FrameSet& set) {
  std::vector<double> delays;
  for (const FramePtr& frame : set.frames) {
    delays.push_back(frame ? seconds(frame->captureTime - set.time)
                           : std::numeric_limits<double>::quiet_NaN());
  }
  return delays;
}

/// The set's time is its truth's: sets come regularly.
void expectRegularSets(const ScenarioRun& run) {
  for (const std::int64_t frame : {0, 1, 29, 100}) {
    EXPECT_EQ(run.frames(frame)->time, timeStamp(static_cast<double>(frame) / 30.0));
  }
}

TEST(ScenarioClocks, OffsetsStayAndDiffer) {
  const ScenarioRun run = scenarioRun("S7-offsets");
  expectRegularSets(run);
  const std::vector<double> first = delaysOf(*run.frames(0));
  ASSERT_EQ(first.size(), 3U);
  // One is in time, one early by half of 1/30 s, the third between them.
  EXPECT_NEAR(std::ranges::max(first), 0.0, 1e-6);
  EXPECT_NEAR(std::ranges::min(first), -0.5 / 30.0, 1e-6);
  for (const std::int64_t frame : {1, 77}) {
    const std::vector<double> later = delaysOf(*run.frames(frame));
    for (std::size_t camera = 0; camera < first.size(); ++camera) {
      EXPECT_NEAR(later[camera], first[camera], 1e-6);
    }
  }
}

TEST(ScenarioClocks, RatesGiveSomeSetsFewerFrames) {
  const ScenarioRun run = scenarioRun("S7-rates");
  expectRegularSets(run);
  std::vector<int> counts(3, 0);
  for (std::int64_t frame = 0; frame < 30; ++frame) {
    const std::vector<double> delays = delaysOf(*run.frames(frame));
    for (std::size_t camera = 0; camera < counts.size(); ++camera) {
      if (!std::isnan(delays[camera])) {
        ++counts[camera];
        EXPECT_LE(delays[camera], 1e-6) << "a set holds nothing from later";
        EXPECT_GT(delays[camera], -1.0 / 30.0) << "nor what belongs to the set before";
      }
    }
  }
  std::ranges::sort(counts);
  EXPECT_EQ(counts, (std::vector<int>{15, 25, 30})) << "frames of the first second";
}

struct ValueRange {
  double low = HUGE_VAL;
  double high = 0.0;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

TEST(ScenarioLight, RampsByFour) {
  const ScenarioRun run = scenarioRun("S8-ramp");
  ValueRange brightness;
  for (std::int64_t frame = 0; frame < run.frameCount; frame += 3) {
    const cv::Scalar mean = cv::mean(run.frames(frame)->frames[0]->image);
    brightness.add(mean[0] + mean[1] + mean[2]);
  }
  // From 0.35 to 1.4; what is brightest then saturates, hence the 20 %.
  EXPECT_NEAR(brightness.high / brightness.low, 4.0, 0.8);
}

TEST(ScenarioLight, ChangesItsColor) {
  const ScenarioRun run = scenarioRun("S8-temperature");
  ValueRange blueByRed;
  for (std::int64_t frame = 0; frame < run.frameCount; frame += 5) {
    const cv::Scalar mean = cv::mean(run.frames(frame)->frames[1]->image);
    blueByRed.add(mean[0] / mean[2]);
  }
  // Planck's law at 460 and 620 nm (exponents 31278 K and 23206 K over the temperature): blue to
  // red is 1.242 times that of 5500 K at 6500 K and 0.726 times at 4500 K.
  EXPECT_NEAR(blueByRed.high / blueByRed.low, 1.242 / 0.726, 0.1);
}

/// How far the largest blob is from where the truth re-projects with the rig that is believed.
double blobOffPx(const ScenarioRun& run, std::size_t camera, std::int64_t frame) {
  const cv::Mat image = run.frames(frame)->frames[camera]->image;
  const auto blobs = findBlobs(matchImage(image, ColorClassifier(run.targets[0].color)));
  const auto pixel = Projector(run.rig[camera]).project(validTruthAt(run, frame)[0]);
  return blobs.empty() || !pixel ? HUGE_VAL : (blobs[0].center - *pixel).norm();
}

TEST(ScenarioBump, TheCameraNoLongerStandsWhereItIsBelieved) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const ScenarioRun run = scenarioRun("S9-bump", seed);
    const auto motions = eventsOf(run, ScenarioEvent::Kind::CameraMoved);
    ASSERT_EQ(motions.size(), 1U);
    for (std::size_t camera = 0; camera < run.rig.size(); ++camera) {
      EXPECT_LT(blobOffPx(run, camera, motions[0].frame - 1), 2.5);
      const double after = blobOffPx(run, camera, motions[0].frame);
      // 1.5 degrees are 9.2 pixels at 350; 1 cm is at most 6 at the ball's distance.
      if (static_cast<int>(camera) == motions[0].camera) {
        EXPECT_GT(after, 3.0);
        EXPECT_LT(after, 18.0);
      } else {
        EXPECT_LT(after, 2.5);
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
