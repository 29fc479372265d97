// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/convergence_study.h"

#include "core/base/statistics.h"
#include "core/session/run/frame_loop.h"
#include "core/simulation/scene/scene_renderer.h"
#include "core/tracking/barrera/barrera_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace dewpoint::experiment {
namespace {

/// Meters: the paper's "position error < 3 cm once converged".
constexpr double kPaperError = 0.03;
/// World, meters: where the paper puts all its particles at first.
const Eigen::Vector3d kPaperStart(0.4, 0.1, 0.2);
constexpr int kDistinctFrames = 16; // chosen: frames of a still ball differ by their noise only

Scene stillScene(const ConvergenceCase& setup) {
  Scene scene = demoScene();
  scene.balls.front().motion = Motion::Still;
  scene.balls.front().position = setup.ballPosition;
  scene.cameras = setup.cameras;
  scene.hasClutter = setup.hasClutter;
  return scene;
}

Camera lookingAt(Camera camera, const Eigen::Vector3d& point) {
  camera.cameraFromWorld = lookAt(camera.center(), point);
  return camera;
}

std::vector<FrameSetPtr> renderFrames(const Scene& scene) {
  const SceneRenderer renderer(scene);
  std::vector<FrameSetPtr> sets;
  for (int k = 0; k < kDistinctFrames; ++k) {
    FrameSet set{k, timeStamp(k / scene.framesPerSecond), {}};
    for (int camera = 0; camera < static_cast<int>(scene.cameras.size()); ++camera) {
      set.frames.push_back(
          std::make_shared<const Frame>(Frame{k, set.time, renderer.render(camera, k)}));
    }
    sets.push_back(std::make_shared<const FrameSet>(std::move(set)));
  }
  return sets;
}

Target targetOf(const SceneBall& ball) {
  return {ball.name, ball.radius,
          ColorRange{ball.hueMin, ball.hueMax, ball.saturationMin, ball.saturationMax,
                     ball.intensityMin, ball.intensityMax}};
}

ParameterValues parametersOf(const ConvergenceCase& setup) {
  ParameterValues parameters(barreraParameters());
  const char* const axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    // Within the declared range by construction of the cases.
    (void)parameters.set(std::string("start_") + axes[axis], setup.startPosition[axis]);
    (void)parameters.set(std::string("start_half_") + axes[axis], setup.startHalfSize[axis]);
  }
  return parameters;
}

/// A few frames over and over, counted on: the random numbers go by frame number.
class RepeatedFrames final : public FrameSetSource {
public:
  explicit RepeatedFrames(const std::vector<FrameSetPtr>& frames) : frames_(frames) {}

  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override { return 30.0; } // nobody waits for them
  Result<FrameSetPtr> next() override {
    FrameSet frame = *frames_[static_cast<std::size_t>(next_) % frames_.size()];
    frame.index = next_++;
    return std::make_shared<const FrameSet>(std::move(frame));
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  const std::vector<FrameSetPtr>& frames_;
  std::int64_t next_ = 0;
};

/// Brings what the run believes of its target to a watch.
class BeliefObserver final : public FrameObserver {
public:
  explicit BeliefObserver(const ConvergenceCallback& watch) : watch_(watch) {}

  Status onFrameTracked(const TrackingRun& run) override {
    watch_(static_cast<int>(run.iterationCount()), run, std::get<SphereEstimate>(run.estimate(0)));
    return {};
  }

private:
  const ConvergenceCallback& watch_;
};

/// The run of a still scene that is to find its ball, and the scene's frames.
struct Trial {
  TrackingRun run;
  double motionSigma = 0.0; ///< meters per axis and iteration
  std::vector<FrameSetPtr> frames;
  Eigen::Vector3d axis; ///< optical axis of the first camera, world
};

/// One iteration per frame, as the method does unless it is told otherwise.
Status watchRun(Trial& trial, std::uint64_t seed, int iterations,
                const ConvergenceCallback& watch) {
  trial.run.restart(seed);
  RepeatedFrames source(trial.frames);
  BeliefObserver observer(watch);
  const std::array<FrameObserver*, 1> observers{&observer};
  return session::trackFrames(source, {0, iterations}, trial.run, observers, [] { return true; });
}

/// The cloud after each iteration: its mean, and its spread around it (world, meters).
struct CloudPath {
  std::vector<Eigen::Vector3d> means;
  std::vector<double> spreads;
};

Result<CloudPath> pathOfRun(Trial& trial, std::uint64_t seed, int iterations) {
  CloudPath path;
  return watchRun(trial, seed, iterations,
                  [&](int, const TrackingRun&, const SphereEstimate& estimate) {
                    path.means.push_back(estimate.mean);
                    path.spreads.push_back(estimate.spread());
                  })
      .map([&] { return path; });
}

Result<Trial> prepare(const Scene& scene, const ConvergenceCase& setup) {
  auto definition = std::make_shared<RunDefinition>();
  definition->method = "barrera";
  definition->parameters = parametersOf(setup);
  const double motionSigma = definition->parameters.at("motion_sigma");
  definition->targets = {targetOf(scene.balls.front())};
  definition->rig = std::make_shared<const CameraRig>(scene.cameras);
  return TrackingRun::create(std::move(definition), 1).map([&](TrackingRun run) {
    return Trial{std::move(run), motionSigma, renderFrames(scene),
                 scene.cameras.front().opticalAxis()};
  });
}

/// Sums over the iterations of converged clouds.
struct ErrorSum {
  double squares = 0.0; ///< m²
  double depth = 0.0;   ///< meters along the optical axis
  int count = 0;

  double rmse() const { return std::sqrt(squares / std::max(1, count)); }
  void add(const ErrorSum& other) {
    squares += other.squares;
    depth += other.depth;
    count += other.count;
  }
};

/// The errors of the means from an iteration (from 1) on.
ErrorSum errorsFrom(int iteration, const std::vector<Eigen::Vector3d>& means,
                    const Eigen::Vector3d& truth, const Eigen::Vector3d& axis) {
  ErrorSum sum;
  for (auto k = static_cast<std::size_t>(iteration - 1); k < means.size(); ++k) {
    const Eigen::Vector3d error = means[k] - truth;
    sum.add({error.squaredNorm(), error.dot(axis), 1});
  }
  return sum;
}

/// Runs with the case's seeds and what they add up to.
Result<ConvergenceResult> resultOf(const ConvergenceCase& setup, Trial& trial) {
  ConvergenceResult result{setup};
  std::vector<double> iterations;
  ErrorSum all;
  for (int run = 0; run < setup.runCount; ++run) {
    const std::uint64_t seed = setup.firstSeed + static_cast<std::uint64_t>(run);
    const auto path = pathOfRun(trial, seed, setup.iterationCount);
    if (!path) {
      return tl::make_unexpected(path.error());
    }
    const auto converged = convergenceIteration(path->spreads, trial.motionSigma);
    if (!converged) {
      continue;
    }
    const ErrorSum errors = errorsFrom(*converged, path->means, setup.ballPosition, trial.axis);
    ++result.convergedRunCount;
    result.accurateRunCount += errors.rmse() < kPaperError ? 1 : 0;
    iterations.push_back(*converged);
    all.add(errors);
  }
  result.medianIterations = median(std::move(iterations));
  result.rmse = all.rmse();
  result.depthBias = all.depth / std::max(1, all.count);
  return result;
}

/// Meters along the optical axis after each iteration, mean over the runs, starting on the ball.
Result<std::vector<double>> driftOf(const Eigen::Vector3d& start, Trial& trial, int runs,
                                    int iterations, std::uint64_t firstSeed) {
  std::vector<double> moved(static_cast<std::size_t>(iterations), 0.0);
  for (int run = 0; run < runs; ++run) {
    const auto path = pathOfRun(trial, firstSeed + static_cast<std::uint64_t>(run), iterations);
    if (!path) {
      return tl::make_unexpected(path.error());
    }
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k] += (path->means[k] - start).dot(trial.axis) / runs;
    }
  }
  return moved;
}

} // namespace

std::optional<int> convergenceIteration(std::span<const double> spreads, double motionSigma) {
  const double bound = std::sqrt(3.0) * motionSigma;
  std::size_t begin = spreads.size(); // of the spreads below the bound at the end
  while (begin > 0 && spreads[begin - 1] < bound) {
    --begin;
  }
  return begin == spreads.size() ? std::nullopt : std::optional(static_cast<int>(begin) + 1);
}

std::vector<ConvergenceCase> barreraConvergenceCases(int runs, std::uint64_t firstSeed) {
  const Eigen::Vector3d near(0.5, 0.5, 0.15);
  const Eigen::Vector3d far(0.8, 0.7, 0.15);
  const Eigen::Vector3d aside(0.7, 0.75, 0.15); // just outside camera 2's image in the demo's rig
  const Eigen::Vector3d meterAway(0.6, 1.05, 0.15);
  CameraRig atTheBall = demoRig();
  for (Camera& camera : atTheBall) {
    camera = lookingAt(camera, meterAway);
  }
  std::vector<ConvergenceCase> cases{
      {"paper start, ball at 0.5 0.5 0.15", near, kPaperStart, Eigen::Vector3d::Zero(), runs, 150},
      {"paper start, ball at 0.8 0.7 0.15", far, kPaperStart, Eigen::Vector3d::Zero(), runs, 150},
      {"paper start, ball at 0.7 0.75 0.15", aside, kPaperStart, Eigen::Vector3d::Zero(), runs,
       150},
      {"paper start, ball at 0.6 1.05 0.15, cameras at it", meterAway, kPaperStart,
       Eigen::Vector3d::Zero(), runs, 150, atTheBall, false},
      barreraFigure3Case(runs, firstSeed),
      {"start beyond the ball, 0.5 0.9 0.15",
       near,
       {0.5, 0.9, 0.15},
       Eigen::Vector3d::Zero(),
       runs,
       150},
      {"uniform start, desk 1 x 1 x 0.5 m", near, {0.5, 0.5, 0.25}, {0.5, 0.5, 0.25}, runs, 150},
      {"uniform start, room 4 x 4 x 2 m", near, {0.5, 0.5, 1.0}, {2.0, 2.0, 1.0}, runs, 150},
  };
  for (ConvergenceCase& one : cases) {
    one.firstSeed = firstSeed;
  }
  return cases;
}

ConvergenceCase barreraFigure3Case(int runs, std::uint64_t firstSeed) {
  ConvergenceCase setup{"paper start, figure 3: ball at 0.3 1.1 0.15",
                        {0.3, 1.1, 0.15},
                        kPaperStart,
                        Eigen::Vector3d::Zero(),
                        runs,
                        150};
  // Camera 1 looks 27 degrees to the left of +Y: it sees the start 117 px to the left of its
  // image's center, and the ball 102 px to the right.
  setup.cameras[0] = lookingAt(setup.cameras[0], {0.0, 1.0, 0.15});
  setup.cameras[1] = lookingAt(setup.cameras[1], setup.ballPosition);
  setup.hasClutter = false;
  setup.firstSeed = firstSeed;
  return setup;
}

Result<ConvergenceResult> studyConvergence(const ConvergenceCase& setup) {
  return prepare(stillScene(setup), setup).and_then([&](Trial trial) {
    return resultOf(setup, trial);
  });
}

Status watchConvergence(const ConvergenceCase& setup, std::uint64_t seed,
                        const ConvergenceCallback& watch) {
  return prepare(stillScene(setup), setup).and_then([&](Trial trial) {
    return watchRun(trial, seed, setup.iterationCount, watch);
  });
}

Result<std::vector<double>> measureDriftCurve(int runs, int iterations, std::uint64_t firstSeed) {
  ConvergenceCase setup;
  setup.ballPosition = {0.5, 0.5, 0.15};
  setup.startPosition = setup.ballPosition;
  setup.cameras.resize(1);
  return prepare(stillScene(setup), setup).and_then([&](Trial trial) {
    return driftOf(setup.startPosition, trial, runs, iterations, firstSeed);
  });
}

Result<double> measureDrift(int runs, int iterations, std::uint64_t firstSeed) {
  return measureDriftCurve(runs, iterations, firstSeed).map([&](const std::vector<double>& moved) {
    return moved.back() / iterations;
  });
}

} // namespace dewpoint::experiment
