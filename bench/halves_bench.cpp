// SPDX-License-Identifier: GPL-3.0-or-later
// How true the stated accuracy of a calibration is: each recording is cut into halves, both are
// calibrated, and the differences are compared with what both state for 95 %. Usage: halves_bench
// [first seed] [number of simulated rigs] [rendered] [-v]; the recordings are those of
// DEWPOINT_DATA.
#include "bench/board_recording.h"
#include "core/base/units.h"
#include "core/calibration/board/view_choice.h"
#include "core/calibration/quality/board_accuracy.h"
#include "core/geometry/ray.h"
#include "core/geometry/similarity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::bench {
namespace {

constexpr double kNinetyFive = 1.96;
constexpr double kRulerSigma = 0.2e-3; ///< meters; both halves share the error of the board

/// Differences over what is stated for 95 % of them, by quantity.
using Ratios = std::map<std::string, std::vector<double>>;

/// What one half says.
struct Half {
  std::vector<std::optional<IntrinsicsResult>> lenses; ///< empty if they were given
  ExtrinsicsResult extrinsics;
  CalibrationAccuracy accuracy;
};

setup::BoardDetections partOf(const setup::BoardDetections& all, std::int64_t from,
                              std::int64_t to) {
  setup::BoardDetections part = all;
  for (auto& camera : part.cameras) {
    std::erase_if(camera.views,
                  [&](const BoardView& view) { return view.instant < from || view.instant >= to; });
  }
  return part;
}

/// As calibrateFromBoards(), without the search for faults, which takes most of the time.
Result<Half> calibrated(const BoardRecording& recording, const setup::BoardDetections& seen,
                        bool lenses) {
  const setup::BoardCalibrationRequest defaults;
  Half half;
  std::vector<std::vector<BoardView>> views;
  std::vector<int> widths;
  std::vector<const IntrinsicsResult*> estimated;
  half.lenses.resize(seen.cameras.size());
  ExtrinsicsRequest request;
  request.board = recording.board;
  for (std::size_t k = 0; k < seen.cameras.size(); ++k) {
    const auto& camera = seen.cameras[k];
    request.cameras.push_back({recording.project.cameras[k].camera, {}});
    views.push_back(camera.views);
    widths.push_back(camera.imageWidth);
    if (lenses) {
      IntrinsicsRequest lens;
      lens.board = recording.board;
      lens.views = chooseViews(recording.board, camera.views, camera.imageWidth, camera.imageHeight,
                               defaults.maxViews);
      lens.width = camera.imageWidth;
      lens.height = camera.imageHeight;
      auto result = calibrateIntrinsics(lens);
      if (!result) {
        return tl::make_unexpected(result.error());
      }
      Camera& known = request.cameras.back().camera;
      known.intrinsics = result->camera.intrinsics;
      known.distortion = result->camera.distortion;
      half.lenses[k] = std::move(*result);
    }
    estimated.push_back(half.lenses[k] ? &*half.lenses[k] : nullptr);
  }
  const auto chosen = chooseInstants(views, widths, defaults.maxInstants, std::nullopt);
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    request.cameras[k].views = chosen[k];
  }
  auto extrinsics = calibrateExtrinsics(request);
  if (!extrinsics) {
    return tl::make_unexpected(extrinsics.error());
  }
  return assessBoard(*extrinsics, recording.board, std::nullopt, estimated)
      .map([&](CalibrationAccuracy accuracy) {
        setCameraSigmas(accuracy, *extrinsics);
        half.accuracy = std::move(accuracy);
        half.extrinsics = std::move(*extrinsics);
        return std::move(half);
      });
}

CameraRig relativeToFirst(CameraRig rig) {
  const Eigen::Isometry3d worldFromFirst = rig.front().cameraFromWorld.inverse();
  for (Camera& camera : rig) {
    camera.cameraFromWorld = camera.cameraFromWorld * worldFromFirst;
  }
  return rig;
}

/// The corners that both halves see in the same images, triangulated by each.
std::pair<std::vector<Eigen::Vector3d>, std::vector<Eigen::Vector3d>>
corners(const CameraRig& a, const CameraRig& b, const setup::BoardDetections& seen) {
  std::map<std::pair<std::int64_t, int>, std::pair<std::vector<Ray>, std::vector<Ray>>> rays;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Unprojector ofA(a[k]);
    const Unprojector ofB(b[k]);
    for (const BoardView& view : seen.cameras[k].views) {
      for (std::size_t c = 0; c < view.detection.ids.size(); c += 3) {
        const auto rayA = ofA.ray(view.detection.pixels[c]);
        const auto rayB = ofB.ray(view.detection.pixels[c]);
        if (rayA && rayB) {
          auto& both = rays[{view.instant, view.detection.ids[c]}];
          both.first.push_back(*rayA);
          both.second.push_back(*rayB);
        }
      }
    }
  }
  std::pair<std::vector<Eigen::Vector3d>, std::vector<Eigen::Vector3d>> points;
  for (const auto& [key, both] : rays) {
    const auto inA = nearestPoint(both.first);
    const auto inB = nearestPoint(both.second);
    if (inA && inB && both.first.size() > 1) {
      points.first.push_back(*inA);
      points.second.push_back(*inB);
    }
  }
  return points;
}

double scaleError95(const Half& half, const BoardDescription& board) {
  const double side = board.squareSize * std::max(board.squareColumns(), board.squareRows());
  const double ruler = kNinetyFive * kRulerSigma / side;
  const double all = half.accuracy.scaleError95.value_or(0.0);
  return std::sqrt(std::max(0.0, all * all - ruler * ruler));
}

void compare(const BoardRecording& recording, const Half& a, const Half& b, bool verbose,
             Ratios& ratios) {
  const CameraRig rigA = relativeToFirst(a.extrinsics.cameras);
  const CameraRig rigB = relativeToFirst(b.extrinsics.cameras);
  const auto add = [&](const char* what, double difference, double statedA, double statedB,
                       double unit) {
    ratios[what].push_back(std::abs(difference) / std::hypot(statedA, statedB));
    if (verbose) {
      fmt::print("  {} {}: {:.3f}, stated {:.3f} and {:.3f}\n", recording.name, what,
                 difference / unit, statedA / unit, statedB / unit);
    }
  };
  for (std::size_t k = 0; k < rigA.size(); ++k) {
    const CameraFit& fitA = a.extrinsics.cameraFits[k];
    const CameraFit& fitB = b.extrinsics.cameraFits[k];
    if (fitA.centerSigma > 0.0 && fitB.centerSigma > 0.0) {
      add("camera position", (rigA[k].center() - rigB[k].center()).norm(),
          kNinetyFive * fitA.centerSigma, kNinetyFive * fitB.centerSigma, 1e-3);
      const Eigen::AngleAxisd turn(rigA[k].cameraFromWorld.linear() *
                                   rigB[k].cameraFromWorld.linear().transpose());
      add("camera rotation", turn.angle(), kNinetyFive * fitA.rotationSigma,
          kNinetyFive * fitB.rotationSigma, kDegree);
    }
    if (a.lenses[k] && b.lenses[k]) {
      const EstimatedParameter& fA = a.lenses[k]->parameters.front();
      const EstimatedParameter& fB = b.lenses[k]->parameters.front();
      add("focal length", fA.value - fB.value, kNinetyFive * fA.sigma, kNinetyFive * fB.sigma, 1.0);
    }
  }
  const auto [inA, inB] = corners(rigA, rigB, recording.seen);
  add("scale", fitSimilarity(inA, inB, true).scale - 1.0, scaleError95(a, recording.board),
      scaleError95(b, recording.board), 0.01);
  const Similarity moved = fitSimilarity(inA, inB, false);
  std::vector<double> distances;
  for (std::size_t i = 0; i < inA.size(); ++i) {
    distances.push_back((moved * inA[i] - inB[i]).norm());
  }
  std::ranges::sort(distances);
  const double stated =
      std::hypot(a.accuracy.positionErrorFromCameras95, b.accuracy.positionErrorFromCameras95);
  for (const double distance : distances) {
    ratios["position in the volume"].push_back(distance / stated);
  }
  if (verbose && !distances.empty()) {
    fmt::print("  {} position in the volume: {:.2f}, stated {:.2f} and {:.2f}\n", recording.name,
               1e3 * distances[distances.size() * 95 / 100],
               1e3 * a.accuracy.positionErrorFromCameras95,
               1e3 * b.accuracy.positionErrorFromCameras95);
  }
}

/// The errors of a half whose true cameras are known.
void compareWithTruth(const CameraRig& truth, const Half& half, Ratios& ratios) {
  if (truth.empty()) {
    return; // a real recording
  }
  const CameraRig found = relativeToFirst(half.extrinsics.cameras);
  const CameraRig real = relativeToFirst(truth);
  for (std::size_t k = 0; k < std::min(found.size(), real.size()); ++k) {
    const CameraFit& fit = half.extrinsics.cameraFits[k];
    if (fit.centerSigma > 0.0) {
      ratios["true camera position"].push_back((found[k].center() - real[k].center()).norm() /
                                               (kNinetyFive * fit.centerSigma));
      const Eigen::AngleAxisd turn(found[k].cameraFromWorld.linear() *
                                   real[k].cameraFromWorld.linear().transpose());
      ratios["true camera rotation"].push_back(turn.angle() / (kNinetyFive * fit.rotationSigma));
    }
  }
}

/// Both halves of a recording, in time.
void halve(const BoardRecording& recording, bool lenses, bool verbose, Ratios& ratios) {
  std::int64_t end = 0;
  for (const auto& camera : recording.seen.cameras) {
    end = camera.views.empty() ? end : std::max(end, camera.views.back().instant + 1);
  }
  const auto a = calibrated(recording, partOf(recording.seen, 0, end / 2), lenses);
  const auto b = calibrated(recording, partOf(recording.seen, end / 2, end), lenses);
  if (!a || !b) {
    fmt::print("{}: {}\n", recording.name, errorSentence(a ? b.error() : a.error()));
    return;
  }
  compare(recording, *a, *b, verbose, ratios);
  compareWithTruth(recording.truth, *a, ratios);
  compareWithTruth(recording.truth, *b, ratios);
}

void print(const char* title, Ratios& ratios) {
  fmt::print("{}\n{:<24} {:>6} {:>10} {:>16} {:>16}\n", title, "", "number", "within",
             "median ratio", "95 % of ratios");
  for (auto& [what, all] : ratios) {
    std::ranges::sort(all);
    const auto within = std::ranges::count_if(all, [](double ratio) { return ratio <= 1.0; });
    fmt::print("{:<24} {:>6} {:>8.1f} % {:>16.2f} {:>16.2f}\n", what, all.size(),
               100.0 * static_cast<double>(within) / static_cast<double>(all.size()),
               all[all.size() / 2], all[all.size() * 95 / 100]);
  }
}

} // namespace
} // namespace dewpoint::bench

int main(int count, char** arguments) {
  using namespace dewpoint::bench;
  const auto number = [&](int at, int otherwise) {
    return count > at ? std::atoi(arguments[at]) : otherwise;
  };
  const auto given = [&](const char* word) {
    return std::any_of(arguments, arguments + count,
                       [&](const char* argument) { return std::string_view(argument) == word; });
  };
  const bool verbose = given("-v");
  Ratios simulated;
  Ratios simulatedGiven;
  const int first = number(1, 26);
  for (int seed = first; seed < first + number(2, 50); ++seed) {
    const auto recording = simulatedRig(static_cast<std::uint64_t>(seed), given("rendered"));
    halve(recording, true, verbose, simulated);
    halve(recording, false, verbose, simulatedGiven);
  }
  print("simulated rigs", simulated);
  print("simulated rigs with given lenses that are off by 0.5 %", simulatedGiven);
  const char* data = std::getenv("DEWPOINT_DATA");
  if (data == nullptr) {
    return 0;
  }
  Ratios real;
  for (const auto& recording : {charucoRecording(data), trayRecording(data)}) {
    if (!recording) {
      fmt::print("{}\n", errorSentence(recording.error()));
      continue;
    }
    if (recording->lensesKnown) {
      halve(*recording, false, verbose, real);
    }
    halve(*recording, true, verbose, real);
  }
  print("real recordings", real);
  return 0;
}
