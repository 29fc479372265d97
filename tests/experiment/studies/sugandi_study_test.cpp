// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/boxes/box_follower.h"
#include "core/experiment/metrics/box_metrics.h"
#include "core/experiment/studies/sugandi_pictures.h"
#include "core/experiment/studies/sugandi_report.h"
#include "core/experiment/studies/sugandi_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(BoxMetrics, AreTheBenchmarksDefinitions) {
  const std::vector<ImageBox> truth(4, ImageBox{0, 0, 10, 10});
  const std::vector<std::optional<ImageBox>> found{
      truth[0],               // given, does not count
      ImageBox{0, 0, 10, 10}, // overlap 1: above 20 of the 21 thresholds 0, 0.05, ..., 1
      ImageBox{5, 0, 10, 10}, // overlap 50 / 150, above 0 ... 0.30: 7 thresholds; 5 px off
      std::nullopt};          // overlap 0; the last box, 5 px off, counts for the RMSE
  const BoxMetrics metrics = measureBoxes(found, truth, 4.0);
  EXPECT_NEAR(metrics.success, (20.0 + 7.0) / 21.0 / 3.0, 1e-12);
  EXPECT_NEAR(metrics.precision, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(metrics.rmse, std::sqrt(50.0 / 3.0), 1e-12);
}

TEST(BoxClips, SimulatedBoxesAreWhereTheBallIs) {
  const BoxClip clip = simulatedBoxClip(7);
  ASSERT_EQ(clip.truth.size(), 300U);
  for (const std::int64_t frame : {0, 40, 160}) {
    const auto image = clip.image(frame);
    ASSERT_TRUE(image);
    const Eigen::Vector2d center = clip.truth[std::size_t(frame)].center();
    const auto& color = image->at<cv::Vec3b>(int(center.y()), int(center.x()));
    EXPECT_GT(int(color[2]), int(color[1]) + 40) << frame; // pink: BGR 145, 85, 245 in full light
  }
}

TEST(BoxClips, ReadsABenchmarkFolder) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "box_clips";
  std::filesystem::create_directories(folder / "otb" / "Road");
  std::ofstream(folder / "otb" / "Road" / "groundtruth_rect.txt") << "5,6,7,8\n9\t10\t11\t12\n";
  const auto clips = recordedBoxClips(folder);
  ASSERT_TRUE(clips);
  ASSERT_EQ(clips->size(), 1U);
  EXPECT_EQ(clips->front().truth[0], (ImageBox{4, 5, 7, 8})); // counted from 1 there
  EXPECT_EQ(clips->front().truth[1], (ImageBox{8, 9, 11, 12}));
  const auto image = clips->front().image(0);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::FileUnreadable);
  std::filesystem::remove_all(folder);
}

TEST(SugandiStudy, ReportsEveryMethodAndBar) {
  BoxClip clip = simulatedBoxClip(7);
  clip.truth.resize(6);
  const auto study = studyBoxes({clip}, 1, [](const BoxStudyRow&) { return true; });
  ASSERT_TRUE(study);
  EXPECT_EQ(study->rows.size(), 7U);         // sugandi twice, histogram, four of OpenCV
  ASSERT_EQ(study->requirements.size(), 1U); // the paper's trend
  EXPECT_NE(boxStudyText(*study).find("csrt"), std::string::npos);
  EXPECT_NE(boxStudyCsv(*study).find("\"sugandi, 100 particles\""), std::string::npos);
  EXPECT_NE(boxStudyHtml(*study).find("</html>"), std::string::npos);
}

TEST(SugandiStudy, DrawsTracksAndFrames) {
  BoxClip clip = simulatedBoxClip(7);
  clip.truth.resize(6);
  const auto study = studyBoxes({clip}, 2, [](const BoxStudyRow&) { return true; });
  ASSERT_TRUE(study);
  ASSERT_EQ(study->figures.size(), 1U);
  EXPECT_EQ(study->figures[0].framesImage.cols, 5 * 240); // five frames, 240 pixels wide each
  EXPECT_EQ(study->figures[0].framesImage.rows, 2 * 180); // 100 and 300 particles
  // A head, then six frames of the truth and of seven methods, of one run each.
  EXPECT_EQ(std::ranges::count(boxTracksCsv(*study), '\n'), 1 + 6 * 8);
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("box_study" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(writeBoxStudy(*study, folder));
  std::ifstream file(folder / kBoxReport);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const char* part : {"clip-1.jpg", "x of the center", "Distance to the true center",
                           "Reference: the colors of the given box", "found with 300 particles"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("nan"), std::string::npos);
  // Both histograms sum to 1 over the rows of the file.
  ASSERT_EQ(study->figures[0].referenceHistogram.size(), 512U);
  ASSERT_EQ(study->figures[0].candidateHistogram.size(), 512U);
  EXPECT_EQ(study->figures[0].candidateFrame, 3U); // of six
  EXPECT_NEAR(std::accumulate(study->figures[0].candidateHistogram.begin(),
                              study->figures[0].candidateHistogram.end(), 0.0),
              1.0, 1e-9);
  EXPECT_GT(std::ranges::count(boxHistogramsCsv(*study), '\n'), 2);
  for (const char* name :
       {"clip-1.jpg", "tracks.csv", "histograms.csv", "sugandi-rmse.csv", "sugandi-rmse.txt"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  std::filesystem::remove_all(folder);
}

/// RMSE of the center (px) of method `sugandi` on a clip, mean over seeds 1 to `seeds`.
double sugandiRmse(const BoxClip& clip, const std::vector<cv::Mat>& images, int particles,
                   int seeds) {
  double sum = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto follower = makeDewpointFollower("sugandi", particles, std::uint64_t(seed));
    EXPECT_TRUE(follower);
    EXPECT_TRUE((*follower)->start(images.front(), clip.truth.front()));
    std::vector<std::optional<ImageBox>> found{clip.truth.front()};
    for (std::size_t frame = 1; frame < images.size(); ++frame) {
      found.push_back((*follower)->step(images[frame]));
    }
    sum += measureBoxes(found, clip.truth, clip.hitRadiusPx).rmse;
  }
  return sum / seeds;
}

TEST(SugandiStudy, AHundredParticlesAreWorseThanThreeHundred) {
  // The paper: 6.48 px with 100 particles, 2.28 px with 300. Measured on the rendered clip, five
  // seeds: 12.2 and 4.3 px; on four other clips, ten seeds each: 9.6 to 15.0 and 4.1 to 4.2 px.
  const BoxClip clip = simulatedBoxClip(5001); // of the tables in docs/method-sugandi.md
  const auto images = imagesOf(clip);
  ASSERT_TRUE(images);
  const double few = sugandiRmse(clip, *images, 100, 5);
  const double many = sugandiRmse(clip, *images, 300, 5);
  EXPECT_GT(few, 1.5 * many);
  EXPECT_LT(many, 6.48);
}

TEST(BoxPerturbationStudy, PerturbationsAreSharesOfTheBox) {
  const std::vector<BoxPerturbation> perturbations = boxPerturbations();
  EXPECT_EQ(perturbations.size(), 20U); // four sizes, five places
  const BoxPerturbation perturbation{1.2, -0.15, 0.1};
  const ImageBox drawn = perturbation.appliedTo({100.0, 50.0, 20.0, 40.0}); // center 110, 70
  EXPECT_NEAR(drawn.center().x(), 107.0, 1e-12);
  EXPECT_NEAR(drawn.center().y(), 74.0, 1e-12);
  EXPECT_NEAR(drawn.width, 24.0, 1e-12);
  EXPECT_NEAR(drawn.height, 48.0, 1e-12);
}

TEST(BoxPerturbationStudy, ReportsASizePerRow) {
  BoxClip clip = simulatedBoxClip(7);
  clip.truth.resize(4);
  BoxStudy study;
  auto rows = studyPerturbedBoxes({clip}, 2, [](const BoxPerturbationRow&) { return true; },
                                  {"histogram", "camshift"});
  ASSERT_TRUE(rows);
  study.perturbedRows = std::move(*rows);
  ASSERT_EQ(study.perturbedRows.size(), 8U); // two methods, four sizes
  EXPECT_EQ(study.perturbedRows.front().runCount, 10);
  EXPECT_EQ(study.perturbedRows.back().runCount, 5); // CamShift has no seeds
  EXPECT_TRUE(study.perturbedRows.front().reportsConfidence);
  EXPECT_FALSE(study.perturbedRows.back().reportsConfidence);
  EXPECT_EQ(std::ranges::count(perturbedBoxesCsv(study.perturbedRows), '\n'), 9);
  EXPECT_NE(boxStudyText(study).find("Imprecise first boxes"), std::string::npos);
  EXPECT_NE(boxStudyHtml(study).find("Imprecise first boxes"), std::string::npos);
}

TEST(BoxPerturbationStudy, HistogramStaysOnThePedestrian) {
  const char* data = std::getenv("DEWPOINT_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path(data) / "otb")) {
    GTEST_SKIP() << "the recording otb is not in DEWPOINT_DATA";
  }
  auto clips = recordedBoxClips(data);
  ASSERT_TRUE(clips);
  std::erase_if(*clips, [](const BoxClip& clip) { return clip.name != "otb, Crossing"; });
  ASSERT_EQ(clips->size(), 1U);
  const auto rows =
      studyPerturbedBoxes(*clips, 1, [](const BoxPerturbationRow&) { return true; }, {"histogram"});
  ASSERT_TRUE(rows);
  for (const BoxPerturbationRow& row : *rows) {
    EXPECT_GT(row.metrics.precision, row.scale < 1.3 ? 0.9 : 0.75) << row.scale;
    EXPECT_LT(row.confidentlyWrongShare, 0.05) << row.scale;
  }
}

TEST(SugandiStudy, HistogramStaysOnTheJuggledBalls) {
  const char* data = std::getenv("DEWPOINT_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path(data) / "juggle1")) {
    GTEST_SKIP() << "the recording juggle1 is not in DEWPOINT_DATA";
  }
  auto clips = recordedBoxClips(data);
  ASSERT_TRUE(clips);
  std::erase_if(*clips, [](const BoxClip& clip) { return !clip.name.starts_with("juggle1"); });
  ASSERT_EQ(clips->size(), 3U);
  const auto study = studyBoxes(*clips, 1, [](const BoxStudyRow&) { return true; });
  ASSERT_TRUE(study);
  for (const BoxRequirement& bar :
       study->requirements) { // within a ball's radius on at least 85 % of the frames
    EXPECT_TRUE(bar.isMet) << bar.description;
  }
}

} // namespace
} // namespace dewpoint::tests
