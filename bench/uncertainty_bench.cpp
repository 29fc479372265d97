// SPDX-License-Identifier: GPL-3.0-or-later
// The rig planner's map of 30 x 24 x 12 cells and six cameras, on one core: a whole rig, and one
// camera that is being moved. It must stay above ten updates per second.
#include "core/calibration/planning/uncertainty_map.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

namespace dewpoint::bench {
namespace {

CameraRig sixCameras(LensModel lens) {
  CameraRig rig;
  for (int k = 0; k < 6; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 6;
    Camera camera;
    camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
    camera.distortion = {-0.1, 0.02, 0.001, -0.001, 0.0};
    camera.lens = lens;
    camera.cameraFromWorld =
        lookAt({4.0 * std::cos(angle), 4.0 * std::sin(angle), 2.5}, {0.0, 0.0, 1.0});
    rig.push_back(camera);
  }
  return rig;
}

const VolumeGrid kRoom{{-3.0, -2.4, 0.0}, {3.0, 2.4, 2.4}, {30, 24, 12}};

void wholeRig(benchmark::State& state, LensModel lens, bool exactPoses) {
  const CameraRig rig = sixCameras(lens);
  const std::vector<PoseCovariance> covariances(exactPoses ? 0 : 6, poseCovariance(5e-4, 2e-3));
  UncertaintyMap map(kRoom, 0.5);
  for (auto _ : state) {
    map.setRig(rig, covariances);
    benchmark::DoNotOptimize(map.largestSigmas().data());
  }
}

void oneCamera(benchmark::State& state) {
  const CameraRig rig = sixCameras(LensModel::Pinhole);
  UncertaintyMap map(kRoom, 0.5);
  map.setRig(rig);
  for (auto _ : state) {
    map.setCamera(2, rig[2]);
    benchmark::DoNotOptimize(map.largestSigmas().data());
  }
}

BENCHMARK_CAPTURE(wholeRig, pinhole, LensModel::Pinhole, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeRig, pose_errors, LensModel::Pinhole, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(wholeRig, fisheye, LensModel::Fisheye, true)->Unit(benchmark::kMillisecond);
BENCHMARK(oneCamera)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace dewpoint::bench

BENCHMARK_MAIN();
