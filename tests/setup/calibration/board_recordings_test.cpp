// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration from a board on real recordings. The bars are those of issue 5, the published figures
// those beside the recordings.
#include "core/base/toml_text.h"
#include "core/calibration/quality/board_accuracy.h"
#include "core/capture/recording.h"
#include "core/geometry/ray.h"
#include "core/setup/calibration/board_calibration.h"
#include "tests/calibration/board_views.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// Corner, instant.
using CornerKey = std::pair<std::int64_t, int>;
using Corners = std::map<CornerKey, Eigen::Vector3d>;

using CornerRays = std::map<CornerKey, std::vector<Ray>>;

Corners crossed(const CornerRays& rays) {
  Corners corners;
  for (const auto& [key, seen] : rays) {
    if (const auto point = nearestPoint(seen)) {
      corners[key] = *point;
    }
  }
  return corners;
}

/// Every corner that two cameras saw, from the rays of those that did.
Corners triangulated(const CameraRig& cameras, const std::vector<CameraFit>& fits) {
  CornerRays rays;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    const Unprojector unprojector(cameras[k]);
    for (const ViewFit& view : fits[k].views) {
      for (std::size_t c = 0; view.isUsed && c < view.ids.size(); ++c) {
        if (const auto ray = unprojector.ray(view.pixels[c])) {
          rays[{view.instant, view.ids[c]}].push_back(*ray);
        }
      }
    }
  }
  return crossed(rays);
}

/// How far corners are from the published ones after the best rigid alignment, meters, rising.
std::vector<double> apart(const char* what, const Corners& corners, const Corners& published) {
  std::vector<Eigen::Vector3d> from;
  std::vector<Eigen::Vector3d> to;
  for (const auto& [key, point] : corners) {
    if (const auto found = published.find(key); found != published.end()) {
      from.push_back(point);
      to.push_back(found->second);
    }
  }
  const auto count = static_cast<Eigen::Index>(from.size());
  const Eigen::Map<const Eigen::Matrix3Xd> a(from.front().data(), 3, count);
  const Eigen::Map<const Eigen::Matrix3Xd> b(to.front().data(), 3, count);
  const Eigen::Isometry3d align(Eigen::umeyama(a, b, false));
  std::vector<double> errors;
  for (std::size_t k = 0; k < from.size(); ++k) {
    errors.push_back((align * from[k] - to[k]).norm());
  }
  std::ranges::sort(errors);
  std::printf("%s: %zu corners, median %.2f mm, 95 %% %.2f mm, most %.2f mm\n", what, errors.size(),
              1e3 * errors[errors.size() / 2], 1e3 * errors[errors.size() * 95 / 100],
              1e3 * errors.back());
  return errors;
}

/// The numbers of a CSV file, below its line of names.
std::vector<std::vector<double>> rowsOf(const fs::path& file) {
  std::vector<std::vector<double>> rows;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream numbers(line);
    auto& row = rows.emplace_back();
    for (double number = 0.0; numbers >> number;) {
      row.push_back(number);
    }
  }
  return rows;
}

/// Distances between neighbors along rows and columns, meters.
std::vector<double> spacings(const Corners& corners, const BoardDescription& board) {
  std::vector<double> result;
  for (const auto& [key, point] : corners) {
    const auto [instant, id] = key;
    for (const int next :
         {(id + 1) % board.cornerColumns() != 0 ? id + 1 : -1, id + board.cornerColumns()}) {
      if (const auto found = corners.find({instant, next}); found != corners.end()) {
        result.push_back((found->second - point).norm());
      }
    }
  }
  return result;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

std::vector<fs::path> picturesIn(const fs::path& folder, const std::string& prefix) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".jpg" &&
        entry.path().filename().string().starts_with(prefix)) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

/// Intrinsics from stills of one camera.
Result<IntrinsicsResult> lensFrom(const std::vector<fs::path>& files,
                                  const BoardDescription& board) {
  BoardCalibrationRequest wish;
  wish.board = board;
  return findBoards(files, board, DetectionEffort::Exact)
      .and_then([&](const BoardDetections& seen) { return intrinsicsFromBoards(seen, wish); })
      .map([](const LensesFromBoards& lenses) { return lenses.cameras.front().value(); });
}

TEST(BoardRecordings, Charuco4) {
  const auto folder = dataFolder("charuco4");
  if (folder.empty()) {
    GTEST_SKIP() << "DEWPOINT_DATA has no charuco4";
  }
  BoardCalibrationRequest wish;
  wish.board = boardOf("charuco:4x5:0.054:0.0405:DICT_4X4_1000:inverted");
  Project project;
  std::vector<RecordedCamera> recorded;
  const auto table = readTomlFile(folder / "camera_array.toml");
  ASSERT_TRUE(table);
  for (int k = 0; k < 4; ++k) {
    // Published lenses; the poses are to be found.
    const auto& values = *(*table)["cameras"][std::to_string(k)].as_table();
    ProjectCamera camera;
    camera.camera.name = "camera " + std::to_string(k);
    auto& in = camera.camera.intrinsics;
    in = {1280,
          720,
          *values["matrix"][0][0].value<double>(),
          *values["matrix"][1][1].value<double>(),
          *values["matrix"][0][2].value<double>(),
          *values["matrix"][1][2].value<double>()};
    for (std::size_t c = 0; c < 5; ++c) {
      camera.camera.distortion[c] = *values["distortions"][c].value<double>();
    }
    project.cameras.push_back(camera);
    RecordedCamera video;
    video.name = camera.camera.name;
    video.path = (folder / ("cam_" + std::to_string(k) + ".mp4")).string();
    recorded.push_back(video);
  }
  const auto source = openRecording(recorded, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  const auto seen = findBoards(project, **source, wish);
  ASSERT_TRUE(seen) << errorSentence(seen.error());
  const auto result = extrinsicsFromBoards(project, *seen, wish);
  ASSERT_TRUE(result) << errorSentence(result.error());

  // Published corners in space and in the images; the recording's first frame is instant 35.
  Corners published;
  for (const auto& row : rowsOf(folder / "CHARUCO_xyz_CHARUCO.csv")) {
    published[{static_cast<int>(row[0]) - 35, static_cast<int>(row[2])}] = {row[3], row[4], row[5]};
  }
  CornerRays rays;
  for (const auto& row : rowsOf(folder / "CHARUCO_xy_CHARUCO.csv")) {
    const Unprojector unprojector(result->cameras[static_cast<std::size_t>(row[1])]);
    rays[{static_cast<int>(row[0]) - 35, static_cast<int>(row[3])}].push_back(
        *unprojector.ray({row[4], row[5]}));
  }
  // The published image points through our cameras: what is judged is the calibration alone.
  const auto theirs = apart("charuco4, published image points", crossed(rays), published);
  EXPECT_LE(theirs[theirs.size() / 2], 0.0025);
  EXPECT_LE(theirs.back(), 0.005);
  // And our own, which come from further cameras too: at instants 9, 23 and 41 one of them was
  // late.
  const Corners ours = triangulated(result->cameras, result->cameraFits);
  const auto own = apart("charuco4, own image points", ours, published);
  EXPECT_LE(own[own.size() / 2], 0.0025);
  const double spacing = meanOf(spacings(ours, wish.board));
  std::printf("charuco4: rms %.3f px, %zu instants, spacing %.2f mm\n", result->rmsPx,
              result->boardPoses.size(), 1e3 * spacing);
  EXPECT_NEAR(spacing, 0.054, 0.0005);
  const auto accuracy = assessBoard(*result, wish.board, {});
  ASSERT_TRUE(accuracy) << errorSentence(accuracy.error());
  std::printf("charuco4: %s\n", accuracySummary(*accuracy).c_str());
  EXPECT_TRUE(result->faults.empty()) << result->faults.front().sentence;
}

TEST(BoardRecordings, StereoTray) {
  const auto folder = dataFolder("stereo_tray/640x480");
  if (folder.empty()) {
    GTEST_SKIP() << "DEWPOINT_DATA has no stereo_tray";
  }
  ExtrinsicsRequest request;
  request.board = boardOf("chessboard:7x5:1"); // meters stand for squares
  for (const char* side : {"left", "right"}) {
    const auto files = picturesIn(folder, side);
    const auto lens = lensFrom(files, request.board);
    ASSERT_TRUE(lens) << errorSentence(lens.error());
    std::printf("stereo_tray %s: rms %.3f px, f %.1f %.1f\n", side, lens->rmsPx,
                lens->camera.intrinsics.focalX, lens->camera.intrinsics.focalY);
    EXPECT_LE(lens->rmsPx, 0.5);
    const auto seen = findBoards(files, request.board, DetectionEffort::Exact);
    request.cameras.push_back({lens->camera, seen->cameras[0].views});
    request.cameras.back().camera.name = side;
  }
  // OpenCV's stereoCalibrate on the same corners: 0.515 px with the lenses held, 0.504 px without.
  const auto held = calibrateExtrinsics(request);
  ASSERT_TRUE(held) << errorSentence(held.error());
  EXPECT_LE(held->rmsPx, 0.516);
  request.refinesIntrinsics = true;
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (const std::string& notice : result->notices) {
    std::printf("stereo_tray: %s\n", notice.c_str());
  }
  const Eigen::Vector3d shift =
      (result->cameras[1].cameraFromWorld * result->cameras[0].cameraFromWorld.inverse())
          .translation();
  std::printf("stereo_tray: rms %.3f px (lenses held: %.3f px), T %.3f %.3f %.3f squares\n",
              result->rmsPx, held->rmsPx, shift.x(), shift.y(), shift.z());
  EXPECT_LE(result->rmsPx, 0.505);
  EXPECT_NEAR(std::abs(shift.x()), 1.046, 0.06); // published, by OpenCV's stereo_calib
}

TEST(BoardRecordings, Ball9Arena) {
  const auto folder = dataFolder("ball9_arena");
  if (folder.empty()) {
    GTEST_SKIP() << "DEWPOINT_DATA has no ball9_arena";
  }
  ExtrinsicsRequest request;
  request.board = boardOf("chessboard:11x8:0.020");
  request.worldDefiningInstant = 0;
  for (int k = 0; k < 9; ++k) {
    const auto floor = findBoards({folder / ("board_view" + std::to_string(k) + ".jpg")},
                                  request.board, DetectionEffort::Exact);
    ASSERT_TRUE(floor);
    const auto lens =
        lensFrom(picturesIn(folder / "intrinsic_boards" / std::to_string(k), ""), request.board);
    ASSERT_TRUE(lens) << errorSentence(lens.error());
    std::printf("ball9_arena view %d: rms %.3f px, f %.1f, floor board %s\n", k, lens->rmsPx,
                lens->camera.intrinsics.focalX,
                floor->cameras[0].views.empty() ? "not seen" : "seen");
    if (!floor->cameras[0].views.empty()) {
      request.cameras.push_back({lens->camera, floor->cameras[0].views});
      request.cameras.back().camera.name = "view " + std::to_string(k);
    }
  }
  ASSERT_GE(request.cameras.size(), 5U);
  const auto result = calibrateExtrinsics(request);
  ASSERT_TRUE(result) << errorSentence(result.error());
  const auto distances = spacings(triangulated(result->cameras, result->cameraFits), request.board);
  const auto [least, most] = std::ranges::minmax(distances);
  std::printf("ball9_arena: %zu views, rms %.3f px, spacing mean %.3f mm, %.3f to %.3f mm\n",
              request.cameras.size(), result->rmsPx, 1e3 * meanOf(distances), 1e3 * least,
              1e3 * most);
  EXPECT_NEAR(meanOf(distances), 0.020, 0.00015);
}

} // namespace
} // namespace dewpoint::tests
