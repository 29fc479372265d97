// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/wand_study.h"

#include "core/base/angle.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/experiment/scenarios/pink_target.h"
#include "core/experiment/scenarios/random_draws.h"
#include "core/setup/calibration/wand_views.h"
#include "core/simulation/room/view_cache.h"
#include "core/simulation/scene/rigs.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace dewpoint::experiment {
namespace {

/// Length of a recording, seconds; chosen: what somebody waves before the arm tires.
constexpr double kSeconds = 30.0;
constexpr double kStick = 0.6;   ///< meters between the balls; chosen: a broomstick's half
constexpr double kRadius = 0.04; ///< meters; chosen: tennis balls and a little more
/// Seconds, either way: half a frame.
constexpr double kClockError = 0.016;
constexpr double kOffsetBar = 5e-4;                ///< seconds that are required of time offsets
constexpr double kSolveBar = 5.0;                  ///< seconds that solving may take
const Eigen::Vector3d kViolet{200.0, 60.0, 130.0}; ///< BGR: a color that nothing in the hall has

/// How a person waves: the middle on a closed path about the hall's middle, the stick turning.
struct Wave {
  Eigen::Vector3d phase, turnPhase;
  double pace = 1.0;

  Eigen::Vector3d end(std::size_t ball, double t) const {
    const double w = 2.0 * std::numbers::pi * pace;
    const Eigen::Vector3d middle(0.75 * std::sin(w * t / 5.3 + phase.x()),
                                 0.75 * std::sin(w * t / 4.1 + phase.y()),
                                 1.0 + 0.4 * std::sin(w * t / 3.1 + phase.z()));
    const double a = w * t / 4.7 + turnPhase.x();
    const double b = 0.9 * std::sin(w * t / 6.3 + turnPhase.y());
    const Eigen::Vector3d along(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
    return middle + (ball == 0 ? -0.5 : 0.5) * kStick * along;
  }
};

Target violetTarget() {
  Target target = scenarios::pinkTarget("violet", kRadius);
  target.color = {250.0, 295.0, 0.2, 0.75, 0.1, 0.9};
  return target;
}

/// One seed's hall: what is true, and what is recorded of it.
class WandScene {
public:
  WandScene(std::uint64_t seed, const WandRecording& recording)
      : draws_(seed, "wand"), framesPerSecond_(recording.framesPerSecond) {
    const auto phases = [&] {
      const double full = 2.0 * std::numbers::pi;
      return draws_.drawPointInBox(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(full));
    };
    wave_.phase = phases();
    wave_.turnPhase = phases();
    wave_.pace = draws_.drawUniform(0.8, 1.2);
    rig_ = hallRig(4);
    static simulation::ViewCache cache;
    for (Camera& camera : rig_) {
      camera.distortion[0] = -0.15;
      camera.distortion[1] = 0.04;
      stage_.views.push_back(cache.view(camera, simulation::Furnishing::Hall));
    }
    stage_.seed = seed;
    stage_.jpegQuality = recording.jpegQuality;
    for (std::size_t ball = 0; ball < 2; ++ball) {
      simulation::StageBody& body = stage_.bodies.emplace_back();
      body.radius = kRadius;
      body.path = [this, ball](double t) { return wave_.end(ball, t); };
    }
    stage_.bodies.back().color = kViolet;
    for (std::size_t c = 1; c < rig_.size(); ++c) {
      clocks_[c] = draws_.drawUniform(-kClockError, kClockError);
    }
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      directions_.push_back({draws_.drawDirection(), draws_.drawDirection()});
    }
    project_.targets = {scenarios::pinkTarget("pink", kRadius), violetTarget()};
  }
  WandScene(const WandScene&) = delete;
  WandScene& operator=(const WandScene&) = delete;

  std::vector<std::vector<MarkerObservation>> record(bool unsynced) const {
    WandOptions options = optionsOf(WandCase::Near);
    WandViews views(rig_.size(), *wandColorClassifiers(project_, options));
    const auto frames = static_cast<std::int64_t>(kSeconds * framesPerSecond_);
    for (std::int64_t f = 0; f < frames; ++f) {
      const double time = static_cast<double>(f) / framesPerSecond_;
      FrameSet set{f, timeStamp(time), {}};
      for (std::size_t c = 0; c < rig_.size(); ++c) {
        const double taken = time + (unsynced ? clocks_.at(c) : 0.0);
        set.frames.push_back(std::make_shared<const Frame>(
            Frame{f, timeStamp(time), simulation::renderStage(stage_, c, taken, f)}));
      }
      views.add(set);
    }
    return views.views();
  }

  WandTrial trial(WandCase kind, const std::vector<std::vector<MarkerObservation>>& views) const {
    WandTrial trial;
    trial.kind = kind;
    const bool far = kind == WandCase::Far;
    Project project = project_;
    for (const Camera& camera : perturbedRig(far ? 0.3 : 0.1, (far ? 10.0 : 3.0) * kDegree)) {
      ProjectCamera& added = project.cameras.emplace_back();
      added.camera = camera;
    }
    auto problem = makeWandProblem(project, optionsOf(kind));
    problem->views = views;
    for (const auto& list : views) {
      trial.viewCount += list.size();
    }
    const auto result = calibrateFromWand(*problem);
    if (!result) {
      trial.failureReason = errorSentence(result.error());
      return trial;
    }
    measure(*result, trial);
    return trial;
  }

private:
  static WandOptions optionsOf(WandCase kind) {
    WandOptions options;
    const bool stick = kind != WandCase::OneBall;
    options.targets = {"pink"};
    if (stick) {
      options.targets.emplace_back("violet");
    }
    options.stickLength = stick ? kStick : 0.0;
    options.usesBallDiameter = !stick;
    options.estimatesTimeOffsets = kind == WandCase::Unsynced;
    if (kind == WandCase::Far) {
      options.initialPositionError = 0.3;
      options.initialRotationError = 10.0 * kDegree;
    }
    return options;
  }

  CameraRig perturbedRig(double position, double turn) const {
    CameraRig perturbed = rig_;
    for (std::size_t c = 0; c < perturbed.size(); ++c) {
      auto& pose = perturbed[c].cameraFromWorld;
      const Eigen::Vector3d center = perturbed[c].center() + position * directions_[c][0];
      pose.linear() = Eigen::AngleAxisd(turn, directions_[c][1]) * pose.linear();
      pose.translation() = -pose.linear() * center;
    }
    return perturbed;
  }

  void measure(const WandResult& result, WandTrial& trial) const {
    std::vector<Eigen::Vector3d> found, truth;
    const std::size_t balls = trial.kind == WandCase::OneBall ? 1 : 2;
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      found.push_back(result.cameras[c].center());
      truth.push_back(rig_[c].center());
    }
    for (const BundleState& state : result.bundle.states) {
      for (std::size_t ball = 0; state.isPositionKnown && ball < balls; ++ball) {
        found.push_back(state.ends[ball]);
        truth.push_back(wave_.end(ball, state.time));
      }
    }
    const Similarity back = fitSimilarity(found, truth, false);
    std::array<double, 2> sums{};
    for (std::size_t i = 0; i < found.size(); ++i) {
      sums[i < rig_.size() ? 0 : 1] += (back * found[i] - truth[i]).squaredNorm();
    }
    const auto cameras = static_cast<double>(rig_.size());
    trial.cameraPositionRms = std::sqrt(sums[0] / cameras);
    trial.ballPositionRms =
        std::sqrt(sums[1] / std::max(1.0, static_cast<double>(found.size()) - cameras));
    trial.scaleError = 1.0 / fitSimilarity(found, truth, true).scale - 1.0;
    for (std::size_t c = 0; c < rig_.size(); ++c) {
      const double clock = trial.kind == WandCase::Unsynced ? clocks_.at(c) : 0.0;
      trial.clockOffsetError =
          std::max(trial.clockOffsetError, std::abs(result.timeOffsets[c] - clock));
    }
    trial.medianReprojectionErrorPx = result.medianResidualPx;
    trial.solveSeconds = result.computationSeconds;
    const double bar = wandRmsLimit(trial.kind);
    trial.hasPassed = trial.cameraPositionRms <= bar && trial.ballPositionRms <= bar &&
                      trial.clockOffsetError <= kOffsetBar && trial.solveSeconds <= kSolveBar;
  }

  RandomDraws draws_;
  double framesPerSecond_;
  Wave wave_;
  CameraRig rig_;
  simulation::Stage stage_;
  std::array<double, 4> clocks_{}; ///< seconds by which each camera looks late; the first not
  std::vector<std::array<Eigen::Vector3d, 2>> directions_; ///< of the initial rig's errors
  Project project_;
};

} // namespace

std::vector<WandTrial> studyWand(std::uint64_t seed, const WandRecording& recording,
                                 const std::function<bool(const WandTrial&)>& report) {
  const WandScene hall(seed, recording);
  const auto synced = hall.record(false);
  std::vector<WandTrial> trials;
  for (const WandCase kind :
       {WandCase::Near, WandCase::Far, WandCase::OneBall, WandCase::Unsynced}) {
    trials.push_back(hall.trial(kind, kind == WandCase::Unsynced ? hall.record(true) : synced));
    trials.back().seed = seed;
    if (report && !report(trials.back())) {
      break;
    }
  }
  return trials;
}

double wandRmsLimit(WandCase kind) {
  switch (kind) {
  case WandCase::Unsynced:
    return 2e-3;
  case WandCase::OneBall:
    return std::numeric_limits<double>::infinity();
  default:
    return 1.5e-3;
  }
}

std::string wandCaseName(WandCase kind) {
  switch (kind) {
  case WandCase::Near:
    return "10 cm, 3 degrees off";
  case WandCase::Far:
    return "30 cm, 10 degrees off";
  case WandCase::OneBall:
    return "one ball, size from its diameter";
  default:
    return "10 cm, 3 degrees, clocks +-16 ms";
  }
}

} // namespace dewpoint::experiment
