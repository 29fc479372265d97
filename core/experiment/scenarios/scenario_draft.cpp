// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/scenario_draft.h"

#include "core/experiment/scenarios/target_truth.h"
#include "core/simulation/scene.h"
#include "core/simulation/sensor.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

// The constants of grade `room`.
constexpr double kRadialDistortion = -0.15; // k1; k2 keeps the image monotonous to its corners
/// k2.
constexpr double kRadialDistortion2 = 0.04;
constexpr double kFocalError = 0.005;    // standard deviation, of the focal length
constexpr double kPositionError = 0.002; // meters, per axis
constexpr double kTurnError = 0.2 * std::numbers::pi / 180.0; // about a random axis
/// Quality of JPEG in the grade `Room`.
constexpr int kJpegQuality = 70;
/// Loss of light in the corners.
constexpr double kVignette = 0.25;
constexpr double kSideLight = 0.12; // at most, per direction

/// Keeps the noise's seed apart from the draws'.
constexpr std::uint32_t kNoisePart = 0x5EED;

void addDistortion(CameraRig& rig) {
  for (Camera& camera : rig) {
    camera.distortion[0] = kRadialDistortion;
    camera.distortion[1] = kRadialDistortion2;
  }
}

CameraRig withCalibrationNoise(CameraRig rig, Draws& draws) {
  for (Camera& camera : rig) {
    const double focal = 1.0 + draws.normal(kFocalError);
    camera.intrinsics.focalX *= focal;
    camera.intrinsics.focalY *= focal;
    const Eigen::Vector3d position =
        camera.center() + Eigen::Vector3d(draws.normal(kPositionError),
                                          draws.normal(kPositionError),
                                          draws.normal(kPositionError));
    const Eigen::AngleAxisd turn(draws.normal(kTurnError), draws.direction());
    camera.cameraFromWorld.linear() = turn * camera.cameraFromWorld.linear();
    camera.cameraFromWorld.translation() = -(camera.cameraFromWorld.linear() * position);
  }
  return rig;
}

/// The extents are those of the samples, in their order.
Trajectory truthOf(const ScenarioDraft& draft, std::vector<TargetExtent>& extents) {
  Trajectory truth;
  truth.header.entries = {{"scenario", draft.name}, {"seed", fmt::format("{}", draft.seed)}};
  for (const Camera& camera : draft.rig) {
    truth.header.cameras.push_back({camera.name, camera.center(), camera.opticalAxis()});
  }
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    for (const std::size_t target : draft.targets) {
      const simulation::StageBody& body = draft.stage.bodies[target];
      TrajectorySample sample;
      sample.time = draft.timeOf(frame);
      sample.frame = frame;
      sample.target = body.name;
      const TargetTruth now = targetTruth(body, sample.time);
      sample.position = now.position;
      extents.push_back(now.extent);
      sample.cameras = static_cast<int>(draft.rig.size());
      sample.valid = body.presentAt(sample.time);
      truth.samples.push_back(std::move(sample));
    }
  }
  return truth;
}

/// The number of the newest frame that a camera has taken by `time`; negative: none yet.
std::int64_t newestFrame(const CameraClock& clock, double time) {
  constexpr double kRounding = 1e-6; // of a frame: taken exactly at `time` counts
  return static_cast<std::int64_t>(
      std::floor((time - clock.offset) * clock.framesPerSecond + kRounding));
}

/// The frame that a camera contributes to set `frame`; null when there is none.
FramePtr frameOf(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame) {
  if (draft.lost && draft.lost(camera, frame)) {
    return nullptr;
  }
  CameraClock clock{draft.framesPerSecond, 0.0};
  std::int64_t own = frame;
  if (!draft.clocks.empty()) {
    clock = draft.clocks.at(camera);
    own = newestFrame(clock, draft.timeOf(frame));
    if (own < 0 || (frame > 0 && own == newestFrame(clock, draft.timeOf(frame - 1)))) {
      return nullptr;
    }
  }
  const double time = clock.offset + static_cast<double>(own) / clock.framesPerSecond;
  return std::make_shared<const Frame>(
      Frame{own, timeStamp(time), simulation::renderStage(draft.stage, camera, time, own)});
}

FrameSetPtr frameSetOf(const ScenarioDraft& draft, std::int64_t frame) {
  FrameSet set{frame, timeStamp(draft.timeOf(frame)), {}};
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    set.frames.push_back(frameOf(draft, camera, frame));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

/// The images' faults of grade `room`; the calibration's are the believed rig's.
void roughen(simulation::Stage& stage, Draws& draws) {
  stage.jpegQuality = kJpegQuality;
  for (const auto& view : stage.views) {
    const double right = draws.uniform(-kSideLight, kSideLight);
    const double down = draws.uniform(-kSideLight, kSideLight);
    stage.unevenness.push_back(
        simulation::unevenLight({view->width, view->height}, kVignette, right, down));
  }
}

ScenarioRun runOf(ScenarioDraft draft) {
  ScenarioRun run;
  run.scenario = draft.name;
  run.grade = draft.grade;
  run.seed = draft.seed;
  run.trueRig = draft.rig;
  run.rig = draft.rig;
  if (draft.grade == Grade::Room) {
    Draws faults(draft.seed, draft.name + " room");
    run.rig = withCalibrationNoise(draft.rig, faults);
    roughen(draft.stage, faults);
  }
  for (const std::size_t target : draft.targets) {
    const simulation::StageBody& body = draft.stage.bodies[target];
    run.targets.push_back(pinkTarget(body.name, draft.radiusKnown ? body.radius : 0.0));
  }
  run.startCenter = draft.startCenter;
  run.startHalf = draft.startHalf;
  run.framesPerSecond = draft.framesPerSecond;
  run.frameCount = draft.frameCount;
  run.truth = truthOf(draft, run.extents);
  run.events = draft.events;
  run.equalCandidates = draft.equalCandidates;
  const auto shared = std::make_shared<const ScenarioDraft>(std::move(draft));
  run.frames = [shared](std::int64_t frame) { return frameSetOf(*shared, frame); };
  if (shared->teach) {
    shared->teach(*shared, run);
  }
  return run;
}

Result<ScenarioRun> runOf(const ScenarioRecipe& recipe, simulation::ViewCache& cache,
                          std::uint64_t seed, Grade grade) {
  ScenarioDraft draft{recipe.name, grade, seed, Draws(seed, recipe.name), recipe.rig};
  if (grade == Grade::Room) {
    addDistortion(draft.rig);
  }
  for (const Camera& camera : draft.rig) {
    draft.stage.views.push_back(cache.view(camera, recipe.furnishing));
  }
  draft.stage.seed = derivedSeed(seed, hashOf(recipe.name) ^ kNoisePart);
  if (!recipe.complete(draft)) {
    return failure(ErrorCode::NotFound, "", recipe.name,
                   fmt::format("no place was found for what must be seen (seed {})", seed));
  }
  return runOf(std::move(draft));
}

} // namespace

ScenarioDeclaration declared(ScenarioRecipe recipe, std::shared_ptr<simulation::ViewCache> cache) {
  ScenarioDeclaration declaration;
  declaration.name = recipe.name;
  declaration.family = recipe.name.substr(0, recipe.name.find('-'));
  declaration.sentence = recipe.sentence;
  declaration.make = [recipe = std::move(recipe), cache = std::move(cache)](std::uint64_t seed,
                                                                            Grade grade) {
    return runOf(recipe, *cache, seed, grade);
  };
  return declaration;
}

Target pinkTarget(const std::string& name, double radius) {
  const SceneBall pink;
  return {name, radius,
          ColorRange{pink.hueMin, pink.hueMax, pink.saturationMin, pink.saturationMax,
                     pink.intensityMin, pink.intensityMax}};
}

void addTarget(ScenarioDraft& draft, simulation::Path path, double radius) {
  draft.targets.push_back(draft.stage.bodies.size());
  simulation::StageBody& body = draft.stage.bodies.emplace_back();
  body.name = fmt::format("ball {}", draft.targets.size());
  body.radius = radius;
  body.path = std::move(path);
}

void startNearTruth(ScenarioDraft& draft) {
  constexpr double kOff = 0.05;
  constexpr double kHalf = 0.1;
  const Eigen::Vector3d off =
      draft.draws.inBox(Eigen::Vector3d::Constant(-kOff), Eigen::Vector3d::Constant(kOff));
  draft.startCenter = targetTruth(draft.stage.bodies[draft.targets.front()], 0.0).position + off;
  draft.startHalf = Eigen::Vector3d::Constant(kHalf);
}

void startAroundAll(ScenarioDraft& draft) {
  constexpr double kAround = 0.05;
  Eigen::AlignedBox3d box;
  for (const std::size_t target : draft.targets) {
    box.extend(draft.stage.bodies[target].path(0.0));
  }
  draft.startCenter = box.center();
  draft.startHalf = 0.5 * box.sizes() + Eigen::Vector3d::Constant(kAround);
}

} // namespace dewpoint::experiment::scenarios
