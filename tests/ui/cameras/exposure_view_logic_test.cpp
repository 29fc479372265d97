// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sphere_image.h"
#include "core/project/project.h"
#include "tests/ui/wait.h"
#include "ui/cameras/exposure_bars.h"
#include "ui/cameras/exposure_view.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"

#include <QImage>
#include <QLabel>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <memory>

namespace dewpoint::tests {
namespace {

constexpr double kMetersOfBall = 0.1;

/// A ball of 2 m distance in the middle of the images of two cameras: well exposed in the first
/// one, white in the second one.
class ShownExposure : public testing::Test, protected test::Waiting {
protected:
  ShownExposure() {
    Project project;
    CameraRig rig;
    for (const char* name : {"left", "right"}) {
      Camera camera;
      camera.name = name;
      camera.intrinsics = {160, 120, 150.0, 150.0, 79.5, 59.5};
      camera.cameraFromWorld.translation() = Eigen::Vector3d(0.0, 0.0, 2.0);
      rig.push_back(camera);
      project.cameras.emplace_back().camera = camera;
    }
    document_.replaceProject(project);
    snapshot_.rig = std::make_shared<const CameraRig>(rig);
    auto set = std::make_shared<FrameSet>();
    for (const cv::Scalar& color : {cv::Scalar(30, 120, 200), cv::Scalar::all(255)}) {
      auto frame = std::make_shared<Frame>();
      frame->image = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(90));
      cv::circle(frame->image, {80, 60}, 12, color, cv::FILLED);
      set->frames.push_back(std::move(frame));
    }
    snapshot_.frames = std::move(set);
    TargetSnapshot& target = snapshot_.targets.emplace_back();
    target.target.name = "ball";
    SphereEstimate estimate;
    estimate.radius = kMetersOfBall;
    estimate.particleCount = 100;
    estimate.isValid = true;
    target.estimate = estimate;
    target.cameraReports.resize(2);
  }
  void show() { view_.setSnapshot(std::make_shared<const TrackSnapshot>(snapshot_)); }
  QString textOf(const char* name) const {
    return view_.findChild<QLabel*>(QLatin1String(name))->text();
  }

  Document document_;
  CameraListModel cameras_{document_};
  TrackSnapshot snapshot_;
  ExposureView view_{cameras_};
};

TEST_F(ShownExposure, NamesTheCameraWhoseTargetIsOverexposed) {
  view_.setCamera(0);
  show();
  ASSERT_TRUE(waitFor([this] { return textOf("exposureTitle").contains("ball"); }));
  EXPECT_EQ(textOf("exposureShares"), "0 % overexposed · 0 % too dark");
  EXPECT_EQ(textOf("exposureSentences"),
            "▲ right: 100 % of the target's pixels are overexposed. Lower the exposure.");
  view_.setCamera(1);
  EXPECT_EQ(textOf("exposureShares"), "100 % overexposed · 0 % too dark");
}

TEST_F(ShownExposure, SaysSoWhenACameraSeesNoTarget) {
  view_.setCamera(1);
  show();
  ASSERT_TRUE(waitFor([this] { return textOf("exposureTitle").contains("ball"); }));
  snapshot_.targets[0].cameraReports[1].status = CameraStatus::Hidden;
  show();
  ASSERT_TRUE(waitFor([this] { return textOf("exposureTitle").contains("no target"); }));
  EXPECT_TRUE(textOf("exposureSentences").isEmpty());
}

TEST_F(ShownExposure, ACameraThatMissesAnImageKeepsItsHistogram) {
  view_.setCamera(1);
  show();
  ASSERT_TRUE(waitFor([this] { return textOf("exposureTitle").contains("ball"); }));
  auto set = std::make_shared<FrameSet>(*snapshot_.frames);
  auto dark = std::make_shared<Frame>(*set->frames[0]);
  dark->image = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(3));
  set->frames = {std::move(dark), nullptr};
  snapshot_.frames = std::move(set);
  show();
  ASSERT_TRUE(waitFor([this] { return textOf("exposureSentences").contains("left"); }));
  EXPECT_TRUE(textOf("exposureSentences").contains("too dark"));
  EXPECT_TRUE(textOf("exposureSentences").contains("right"));
  EXPECT_TRUE(textOf("exposureTitle").contains("ball"));
}

TEST_F(ShownExposure, WithoutTargetsNothingIsShown) {
  show();
  EXPECT_FALSE(view_.isHidden());
  snapshot_.targets.clear();
  show();
  EXPECT_TRUE(view_.isHidden());
  show();
  view_.setSnapshot(nullptr);
  EXPECT_TRUE(view_.isHidden());
}

TEST(ExposureBars, DrawsClippedPixelsInTheColorOfText) {
  ExposureBars bars;
  bars.resize(320, 60); // 10 pixels per bar
  TargetExposure exposure;
  for (int k = 0; k < 10; ++k) {
    exposure.add({255, 255, 255});
    exposure.add({100, 100, 100});
  }
  bars.setExposure(exposure);
  const QImage drawn = bars.grab().toImage();
  EXPECT_EQ(drawn.pixel(314, 30), bars.palette().color(QPalette::WindowText).rgb());
  EXPECT_EQ(drawn.pixel(124, 30), bars.palette().color(QPalette::Mid).rgb()); // 96 to 103
}

} // namespace
} // namespace dewpoint::tests
