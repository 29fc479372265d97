// SPDX-License-Identifier: GPL-3.0-or-later
// What a camera is called where it has no name.
#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/color/color_learner.h"
#include "ui/color/color_panel.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/document.h"
#include "ui/text/camera_names.h"

#include <QLabel>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A ball and two cameras; the second has no name.
Project twoCameras() {
  Project made;
  made.parameters = ParameterValues(methodParameters(made.method));
  made.cameras.resize(2);
  made.cameras[0].camera.name = "left";
  made.targets.push_back({"ball", 0.02, {300.0, 340.0, 0.2, 0.9, 0.1, 0.9}});
  return made;
}

TEST(CameraNames, ACameraWithoutANameHasItsNumber) {
  EXPECT_EQ(cameraName(std::string("left"), 0), QStringLiteral("left"));
  EXPECT_EQ(cameraName(std::string(), 1), QStringLiteral("camera 2"));
  EXPECT_EQ(cameraName(CameraRig(), 2), QStringLiteral("camera 3"));
}

TEST(CameraNames, WhereSomethingElseMatchesIsNamedToo) {
  Document document;
  const CameraListModel cameras(document);
  ImagePickTool pick(cameras);
  ColorPanel panel(document, pick);
  document.replaceProject(twoCameras());
  auto* learner = panel.findChild<ColorLearner*>();
  ASSERT_NE(learner, nullptr);
  ColorAssessment assessment;
  assessment.separability = 0.5;
  assessment.targetShare = 1.0;
  DistractorRegion region;
  region.camera = 1;
  region.color = ColorName::Red;
  assessment.distractors.push_back(region);
  Q_EMIT learner->colorAssessed(assessment);
  const QString text = panel.findChild<QLabel*>(QStringLiteral("colorAssessment"))->text();
  EXPECT_TRUE(text.contains(QStringLiteral("in the image of camera 2, "))) << qPrintable(text);
}

} // namespace
} // namespace dewpoint::tests
