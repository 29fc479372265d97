// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/session/people/people_overlay.h"
#include "core/session/people/people_writer.h"
#include "core/trajectory/trajectory_reader.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>

namespace dewpoint::tests {
namespace {

/// Two people who stand still: bodies are cubes of 0.4 m.
class StandingPeople final : public PeopleFinding {
public:
  StandingPeople() {
    for (int k = 0; k < 2; ++k) {
      PersonEstimate& person = people_.emplace_back();
      person.identity = 3 + k;
      person.position = {static_cast<double>(k), 0.0, 1.0};
      person.seeingCameraCount = 2;
    }
    people_[1].hueAndSaturation = Eigen::Vector2d(0.25, 0.5);
  }
  const std::vector<PersonEstimate>& people() const override { return people_; }
  const std::vector<Target>& peopleAsTargets() const override { return peopleAsTargets_; }
  BodyCloud bodyOf(int identity) const override {
    BodyCloud cloud{Eigen::ArrayXXd(8, 3), Eigen::ArrayXd::Constant(8, 0.125)};
    for (int i = 0; i < 8; ++i) {
      cloud.points.row(i) << identity - 3.2 + 0.4 * (i & 1), -0.2 + 0.4 * ((i >> 1) & 1),
          0.8 + 0.4 * ((i >> 2) & 1);
    }
    return cloud;
  }
  const std::vector<PeopleCameraState>& cameraStates() const override { return states_; }
  cv::Mat foregroundMask(std::size_t) const override { return {}; }

private:
  std::vector<PersonEstimate> people_;
  std::vector<Target> peopleAsTargets_;
  std::vector<PeopleCameraState> states_;
};

std::size_t lines(const std::filesystem::path& file) {
  const auto text = readTextFile(file);
  return text ? static_cast<std::size_t>(std::ranges::count(*text, '\n')) : 0U;
}

TEST(PeopleWriter, WritesWhatIsKnownOfEverybody) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "people_writer";
  std::filesystem::remove_all(folder);
  auto writer = PeopleWriter::create(folder, {});
  ASSERT_TRUE(writer);
  const StandingPeople people;
  ASSERT_TRUE(writer->write(people, 0, 0.0));
  ASSERT_TRUE(writer->write(people, 1, 0.1));
  ASSERT_TRUE(writer->finish());
  const auto trajectory = readTrajectory(folder / "trajectory.csv");
  ASSERT_TRUE(trajectory);
  ASSERT_EQ(trajectory->samples.size(), 4U);
  EXPECT_EQ(trajectory->samples[1].target, "person 4");
  EXPECT_EQ(trajectory->samples[1].position, Eigen::Vector3d(1.0, 0.0, 1.0));
  EXPECT_EQ(lines(folder / "volumes.csv"), 5U);
  const auto volumes = *readTextFile(folder / "volumes.csv");
  EXPECT_NE(volumes.find("0.25,0.5"), std::string::npos);
  EXPECT_EQ(lines(folder / "hulls.csv"), 1U + 4 * 8); // the corners of a cube
  EXPECT_GT(lines(folder / "ground.csv"), 50U);
}

TEST(PeopleWriter, NamesAFolderThatCannotBe) {
  const auto file = std::filesystem::path(testing::TempDir()) / "people_writer_file";
  ASSERT_TRUE(writeTextFile(file, "x"));
  const auto writer = PeopleWriter::create(file / "below", {});
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().code, ErrorCode::FileUnwritable);
}

TEST(PeopleOverlay, DrawsOutlinesInTheColorsOfTheIdentities) {
  Camera camera;
  camera.intrinsics = {160, 120, 100.0, 100.0, 80.0, 60.0};
  camera.cameraFromWorld = lookAt({0.5, -3.0, 1.0}, {0.5, 0.0, 1.0});
  FrameSet frames;
  frames.frames = {std::make_shared<const Frame>(Frame{0, {}, cv::Mat::zeros(120, 160, CV_8UC3)}),
                   nullptr};
  const cv::Mat row = peopleOverlay(StandingPeople(), frames, {camera, camera}, 160);
  ASSERT_EQ(row.size(), cv::Size(320, 120));
  for (const int identity : {3, 4}) {
    cv::Mat same;
    cv::inRange(row, identityColor(identity), identityColor(identity), same);
    EXPECT_GT(cv::countNonZero(same(cv::Rect(0, 0, 160, 120))), 10);
  }
  EXPECT_EQ(identityColor(1), identityColor(13));
}

} // namespace
} // namespace dewpoint::tests
