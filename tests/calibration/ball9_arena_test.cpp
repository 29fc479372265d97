// SPDX-License-Identifier: GPL-3.0-or-later
// Nine real cameras and one steel ball: the points of ball9_arena, with their gaps and gross
// errors. Truth is the authors' own calibration.
#include "core/calibration/wand/wand_bundle.h"
#include "core/calibration/wand/wand_calibration.h"
#include "core/calibration/wand/wand_gauge.h"
#include "tests/calibration/moved_cameras.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>

namespace dewpoint::tests {
namespace {

std::filesystem::path folder() {
  const char* data = std::getenv("DEWPOINT_DATA");
  return std::filesystem::path(data == nullptr ? "" : data) / "ball9_arena";
}

CameraRig authorsRig() {
  std::ifstream stream(folder() / "calib.json");
  const auto json = nlohmann::json::parse(stream);
  CameraRig rig;
  for (const auto& entry : json["cameras"]) {
    Camera camera;
    camera.name = "view " + std::to_string(entry["view"].get<int>());
    const auto& k = entry["K"];
    camera.intrinsics = {1280, 800, k[0][0], k[1][1], k[0][2], k[1][2]};
    for (std::size_t i = 0; i < 5; ++i) {
      camera.distortion[i] = entry["dist_k1k2p1p2k3"][i];
    }
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        camera.cameraFromWorld.linear()(row, column) = entry["R"][row][column];
      }
      camera.cameraFromWorld.translation()[row] = 0.001 * entry["t_mm"][row].get<double>();
    }
    rig.push_back(camera);
  }
  return rig;
}

std::vector<std::vector<MarkerObservation>> detections() {
  std::vector<std::vector<MarkerObservation>> views(9);
  std::ifstream stream(folder() / "detections_single.csv");
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) {
      cells.push_back(cell);
    }
    for (std::size_t v = 0; v < 9 && 4 + 3 * v < cells.size(); ++v) {
      const std::string& u = cells[2 + 3 * v];
      if (u.empty() || u == "nan") {
        continue;
      }
      MarkerObservation view;
      view.time = std::stod(cells[0]) / 30.0;
      view.pixel = {std::stod(u), std::stod(cells[3 + 3 * v])};
      view.sigma = 1.0;
      if (view.pixel.allFinite()) {
        views[v].push_back(view);
      }
    }
  }
  return views;
}

/// Median over the views of every tenth frame, none left out, of how far each lies from the
/// projection of the point that explains its instant best (least absolute distances, cameras held).
double medianReprojection(const CameraRig& rig,
                          const std::vector<std::vector<MarkerObservation>>& views) {
  WandProblem problem;
  problem.initialRig = rig;
  problem.views = views;
  for (auto& list : problem.views) {
    std::erase_if(list,
                  [](const MarkerObservation& v) { return std::lround(v.time * 30.0) % 10 != 0; });
  }
  BundleProblem bundle = *makeWandBundle(problem);
  for (BundleCamera& camera : bundle.cameras) {
    camera.isPoseFixed = true;
  }
  bundle.loss = RobustLoss::SoftL1;
  bundle.lossWidth = 1.0;
  bundle.isDraft = true;
  const auto result = adjustBundle(bundle);
  return result ? medianResidual(bundle, *result) : -1.0;
}

TEST(Ball9Arena, WavingTheBallIsNoWorseThanTheAuthorsCalibration) {
  if (!std::filesystem::exists(folder() / "detections_single.csv")) {
    GTEST_SKIP() << "the recording ball9_arena is not in DEWPOINT_DATA";
  }
  WandProblem problem;
  const CameraRig truth = authorsRig();
  problem.views = detections();
  problem.initialRig = movedCameras(truth, 0.1, 3.0 / 180.0 * std::numbers::pi, 1);
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  const double authors = medianReprojection(truth, problem.views);
  const double ours = medianReprojection(result->cameras, problem.views);
  EXPECT_GT(ours, 0.0);
  EXPECT_LE(ours, authors);
  const Similarity back = fitRigSimilarity(result->cameras, truth, true);
  double sum = 0.0;
  double worst = 0.0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    const double off = (back * result->cameras[c].center() - truth[c].center()).norm();
    sum += off * off;
    worst = std::max(worst, off);
  }
  const double rms = std::sqrt(sum / double(truth.size()));
  EXPECT_LT(rms, 0.005);
  std::cout << "authors " << authors << " px, ours " << ours << " px; cameras " << 1000.0 * rms
            << " mm RMS, worst " << 1000.0 * worst << " mm; kept median "
            << result->medianResidualPx << " px; " << result->computationSeconds << " s\n";
}

} // namespace
} // namespace dewpoint::tests
