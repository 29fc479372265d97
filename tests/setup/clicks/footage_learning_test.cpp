// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/footage_learning.h"
#include "tests/setup/clicks/painted_rig.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

/// The same painted images in every frame.
class PaintedFootage final : public FrameSetSource {
public:
  PaintedFootage(std::vector<cv::Mat> images, std::optional<std::int64_t> frames)
      : images_(std::move(images)), frames_(frames) {}

  std::optional<std::int64_t> frameCount() const override { return frames_; }
  double framesPerSecond() const override { return 30.0; }
  Result<FrameSetPtr> next() override {
    auto set = std::make_shared<FrameSet>();
    set->index = next_++;
    for (const cv::Mat& image : images_) {
      set->frames.push_back(std::make_shared<const Frame>(Frame{set->index, set->time, image}));
    }
    return set;
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  std::vector<cv::Mat> images_;
  std::optional<std::int64_t> frames_;
  std::int64_t next_ = 0;
};

struct Footage {
  PaintedRig scene{2};
  Project project;

  Footage() {
    scene.paint(0, kBall, kRadius, kRed);
    scene.paint(1, kBall, kRadius, kRed);
    for (std::size_t k = 0; k < scene.rig.size(); ++k) {
      ProjectCamera& camera = project.cameras.emplace_back();
      camera.camera = scene.rig[k];
      camera.camera.name = "camera " + std::to_string(k + 1);
      camera.source = SourceKind::Video;
    }
  }
  Result<setup::FootageLearningResult> learn(setup::FootageClicks clicks,
                                             std::optional<std::int64_t> frames = 5) const {
    PaintedFootage source(scene.images, frames);
    return setup::learnFromFootage(project, source, {}, std::move(clicks));
  }
  /// A click on the ball without its colors, as a user gives it.
  ColorSample click(std::int64_t frame = 2) const {
    const ColorSample at = scene.clickOn(0, kBall, kRadius);
    ColorSample sample;
    sample.frame = frame;
    sample.x = at.x;
    sample.y = at.y;
    return sample;
  }
};

TEST(FootageLearningResult, MakesATargetOfAClick) {
  const Footage footage;
  const auto result = footage.learn({{footage.click()}, "ball", 0.1, TargetShape::Ball});
  ASSERT_TRUE(result) << errorSentence(result.error());
  ASSERT_EQ(result->project.targets.size(), 1U);
  const Target& target = result->project.targets[result->target];
  EXPECT_EQ(target.name, "ball");
  EXPECT_EQ(target.radius, 0.1);
  EXPECT_EQ(target.shape, TargetShape::Ball);
  EXPECT_FALSE(target.samples.front().colors.empty());
  EXPECT_EQ(target.samples.size(), 2U) << "the other camera shows it, too";
  EXPECT_EQ(result->clickedImage.data, footage.scene.images[0].data);
}

TEST(FootageLearningResult, TeachesTheTargetThatIsMeant) {
  Footage footage;
  EXPECT_EQ(footage.learn({{footage.click()}, {}, {}, {}})->project.targets.at(0).name, "target 1");
  footage.project.targets.resize(1);
  footage.project.targets[0].name = "ball";
  footage.project.targets[0].radius = 0.1;
  const auto again = footage.learn({{footage.click()}, {}, {}, {}});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->project.targets.size(), 1U);
  EXPECT_EQ(again->project.targets[0].radius, 0.1);
  footage.project.targets.push_back(footage.project.targets[0]);
  footage.project.targets[1].name = "cap";
  const auto either = footage.learn({{footage.click()}, {}, {}, {}});
  ASSERT_FALSE(either);
  EXPECT_EQ(either.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(either.error().field, "target");
  EXPECT_EQ(footage.learn({{footage.click()}, "cap", {}, {}})->target, 1U);
}

TEST(FootageLearningResult, SaysWhatCannotBeRead) {
  const Footage footage;
  const auto field = [&](const ColorSample& sample, std::optional<std::int64_t> frames) {
    const auto result = footage.learn({{sample}, {}, {}, {}}, frames);
    return result ? std::string() : result.error().field;
  };
  EXPECT_EQ(field(footage.click(5), 5), "frame");
  EXPECT_EQ(field(footage.click(), std::nullopt), "camera");
  ColorSample outside = footage.click();
  outside.x = 1e4;
  EXPECT_EQ(field(outside, 5), "pixel");
}

} // namespace
} // namespace dewpoint::tests
