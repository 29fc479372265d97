// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/convergence_study.h"

#include "core/base/statistics.h"
#include "core/session/run/frame_loop.h"
#include "core/simulation/scene_renderer.h"
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

/// Meters: "position error < 3 cm once converged".
constexpr double kConvergedError = 0.03;
constexpr int kDistinctFrames = 16; // frames of a still ball differ by their noise only

Scene stillScene(const Eigen::Vector3d& ball) {
  Scene scene = demoScene();
  scene.balls.front().motion = Motion::Still;
  scene.balls.front().position = ball;
  return scene;
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
    (void)parameters.set(std::string("start_") + axes[axis], setup.start[axis]);
    (void)parameters.set(std::string("start_half_") + axes[axis], setup.startHalf[axis]);
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
  explicit BeliefObserver(const ConvergenceWatch& watch) : watch_(watch) {}

  Status tracked(const TrackingRun& run) override {
    watch_(static_cast<int>(run.iterations()), run, std::get<SphereEstimate>(run.estimate(0)));
    return {};
  }

private:
  const ConvergenceWatch& watch_;
};

/// The run of a still scene that is to find its ball, and the scene's frames.
struct Trial {
  TrackingRun run;
  std::vector<FrameSetPtr> frames;
  Eigen::Vector3d axis; ///< optical axis of the first camera, world
};

/// One iteration per frame, as the method does unless it is told otherwise.
Status watchRun(Trial& trial, std::uint64_t seed, int iterations, const ConvergenceWatch& watch) {
  trial.run.restart(seed);
  RepeatedFrames source(trial.frames);
  BeliefObserver observer(watch);
  const std::array<FrameObserver*, 1> observers{&observer};
  return session::trackFrames(source, {0, iterations}, trial.run, observers, [] { return true; });
}

/// The cloud's mean after each iteration.
Result<std::vector<Eigen::Vector3d>> meansOfRun(Trial& trial, std::uint64_t seed, int iterations) {
  std::vector<Eigen::Vector3d> means;
  return watchRun(trial, seed, iterations,
                  [&](int, const TrackingRun&, const SphereEstimate& estimate) {
                    means.push_back(estimate.mean);
                  })
      .map([&] { return means; });
}

/// Iterations done when the error falls below the bound for good; nothing if it is above it at the
/// end.
std::optional<int> iterationsToConverge(const std::vector<Eigen::Vector3d>& means,
                                        const Eigen::Vector3d& truth) {
  const auto isFar = [&](const Eigen::Vector3d& mean) {
    return (mean - truth).norm() >= kConvergedError;
  };
  const auto last = std::find_if(means.rbegin(), means.rend(), isFar);
  const auto iterations = static_cast<int>(means.rend() - last) + 1;
  return iterations > static_cast<int>(means.size()) ? std::nullopt : std::optional(iterations);
}

Result<Trial> prepare(const Scene& scene, const ConvergenceCase& setup) {
  auto definition = std::make_shared<RunDefinition>();
  definition->method = "barrera";
  definition->parameters = parametersOf(setup);
  definition->targets = {targetOf(scene.balls.front())};
  definition->rig = std::make_shared<const CameraRig>(scene.cameras);
  return TrackingRun::create(std::move(definition), 1).map([&](TrackingRun run) {
    return Trial{std::move(run), renderFrames(scene), scene.cameras.front().opticalAxis()};
  });
}

/// Runs with the case's seeds and what they add up to.
Result<ConvergenceResult> resultOf(const ConvergenceCase& setup, Trial& trial) {
  ConvergenceResult result{setup};
  std::vector<double> iterations;
  double squares = 0.0;
  double depth = 0.0;
  int count = 0;
  for (int run = 0; run < setup.runs; ++run) {
    const std::uint64_t seed = setup.firstSeed + static_cast<std::uint64_t>(run);
    const auto found = meansOfRun(trial, seed, setup.iterations);
    if (!found) {
      return tl::make_unexpected(found.error());
    }
    const std::vector<Eigen::Vector3d>& means = *found;
    const auto converged = iterationsToConverge(means, setup.ball);
    if (!converged) {
      continue;
    }
    ++result.converged;
    iterations.push_back(*converged);
    for (auto k = static_cast<std::size_t>(*converged); k < means.size(); ++k) {
      squares += (means[k] - setup.ball).squaredNorm();
      depth += (means[k] - setup.ball).dot(trial.axis);
      ++count;
    }
  }
  result.medianIterations = median(std::move(iterations));
  result.rmse = std::sqrt(squares / std::max(1, count));
  result.depthBias = depth / std::max(1, count);
  return result;
}

/// Meters along the optical axis after each iteration, mean over the runs, starting on the ball.
Result<std::vector<double>> driftOf(const Eigen::Vector3d& start, Trial& trial, int runs,
                                    int iterations, std::uint64_t firstSeed) {
  std::vector<double> moved(static_cast<std::size_t>(iterations), 0.0);
  for (int run = 0; run < runs; ++run) {
    const auto means = meansOfRun(trial, firstSeed + static_cast<std::uint64_t>(run), iterations);
    if (!means) {
      return tl::make_unexpected(means.error());
    }
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k] += ((*means)[k] - start).dot(trial.axis) / runs;
    }
  }
  return moved;
}

} // namespace

std::vector<ConvergenceCase> barreraConvergenceCases(int runs, std::uint64_t firstSeed) {
  const Eigen::Vector3d near(0.5, 0.5, 0.15);
  const Eigen::Vector3d far(0.8, 0.7, 0.15);
  const Eigen::Vector3d aside(0.7, 0.75, 0.15); // just outside camera 2's image in the demo's rig
  const Eigen::Vector3d paperStart(0.4, 0.1, 0.2);
  std::vector<ConvergenceCase> cases{
      {"paper start, ball at 0.5 0.5 0.15", near, paperStart, Eigen::Vector3d::Zero(), runs, 150},
      {"paper start, ball at 0.8 0.7 0.15", far, paperStart, Eigen::Vector3d::Zero(), runs, 150},
      {"paper start, ball at 0.7 0.75 0.15", aside, paperStart, Eigen::Vector3d::Zero(), runs, 150},
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

Result<ConvergenceResult> studyConvergence(const ConvergenceCase& setup) {
  return prepare(stillScene(setup.ball), setup).and_then([&](Trial trial) {
    return resultOf(setup, trial);
  });
}

Status watchConvergence(const ConvergenceCase& setup, std::uint64_t seed,
                        const ConvergenceWatch& watch) {
  return prepare(stillScene(setup.ball), setup).and_then([&](Trial trial) {
    return watchRun(trial, seed, setup.iterations, watch);
  });
}

Result<std::vector<double>> driftCurve(int runs, int iterations, std::uint64_t firstSeed) {
  Scene scene = stillScene({0.5, 0.5, 0.15});
  scene.cameras.resize(1);
  ConvergenceCase setup;
  setup.start = scene.balls.front().position;
  return prepare(scene, setup).and_then([&](Trial trial) {
    return driftOf(setup.start, trial, runs, iterations, firstSeed);
  });
}

Result<double> measureDrift(int runs, int iterations, std::uint64_t firstSeed) {
  return driftCurve(runs, iterations, firstSeed).map([&](const std::vector<double>& moved) {
    return moved.back() / iterations;
  });
}

} // namespace dewpoint::experiment
