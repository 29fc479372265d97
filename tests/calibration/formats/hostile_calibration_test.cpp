// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations that claim too much, or hold what is no number: each is one sentence, at once.
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/read_calibration.h"
#include "tests/fuzz/hostile_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// Of each format one file, and how many of its numbers matter.
struct Sample {
  const char* format;
  const char* file;
};
constexpr Sample kSamples[] = {
    {"dewpoint", "two.toml"},
    {"anipose", "anipose_mm.toml"},
    {"pose2sim", "pose2sim.toml"},
    {"caliscope", "camera_array.toml"},
    {"opencv", "opencv_sample.yml"},
    {"opencv-stereo", "both.yml"},
    {"ros", "left.yaml"},
    {"kalibr", "camchain.yaml"},
    {"mrcal", "left.cameramodel"},
    {"mc-calib", "mc_calib.yml"},
    {"qualisys", "session.qca.txt"},
    {"multical", "multical.json"},
    {"plain", "plain.json"},
};

class HostileCalibration : public testing::Test {
protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("HostileCalibration") + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string textOf(const Sample& sample) {
    return corpusText(std::string(sample.format) + "/" + sample.file);
  }
  Result<ParsedCalibration> read(const std::string& name, const std::string& text,
                                 const std::string& format = "") {
    const fs::path file = folder_ / name;
    writeBytes(file, text);
    CalibrationHints hints;
    hints.format = format;
    hints.lens = LensModel::Pinhole;
    hints.imageSize = {1280, 720};
    auto calibration = readCalibration(file, hints);
    if (!calibration && calibration.error().field == "unit") {
      hints.metersPerUnit = 0.001;
      calibration = readCalibration(file, hints);
    }
    return calibration;
  }
  /// What is wrong; empty: nothing.
  std::string problemOf(const std::string& name, const std::string& text) {
    const auto calibration = read(name, text);
    const std::string sentence = calibration ? "" : base::errorSentence(calibration.error());
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    const std::string start = (folder_ / name).string() + ": ";
    return sentence.starts_with(start) ? sentence.substr(start.size()) : sentence;
  }

  fs::path folder_;
};

TEST_F(HostileCalibration, NumbersThatAreNotFiniteAreInNoCamera) {
  for (const Sample& sample : kSamples) {
    const std::string whole = textOf(sample);
    const auto good = read(sample.file, whole, sample.format);
    ASSERT_TRUE(good) << sample.format << ": " << base::errorSentence(good.error());
    for (const NumberPlace& place : numberPlaces(whole)) {
      for (const char* number : {"nan", "1e308"}) {
        std::string text = whole;
        text.replace(place.begin, place.count, number);
        const auto calibration = read(sample.file, text, sample.format);
        for (std::size_t k = 0; calibration && k < calibration->rig.size(); ++k) {
          const Camera& camera = calibration->rig[k];
          const auto& in = camera.intrinsics;
          double sum = in.focalX + in.focalY + in.centerX + in.centerY;
          for (const double coefficient : camera.distortion) {
            sum += coefficient;
          }
          EXPECT_TRUE(std::isfinite(sum) && camera.cameraFromWorld.matrix().allFinite())
              << sample.format << ": " << whole.substr(place.begin, place.count) << " at "
              << place.begin << " is now " << number;
        }
      }
    }
  }
}

TEST_F(HostileCalibration, OursTakesNoNumberThatIsNotFinite) {
  const std::string whole = textOf(kSamples[0]);
  for (const NumberPlace& place : numberPlaces(whole)) {
    for (const char* number : {"nan", "inf", "1e400", "1e300", "9223372036854775807"}) {
      std::string text = whole;
      text.replace(place.begin, place.count, number);
      EXPECT_NE(problemOf("two.toml", text), "") << place.begin << " is now " << number;
    }
  }
}

TEST_F(HostileCalibration, OfWindowsIsTheSame) {
  for (const Sample& sample : kSamples) {
    const std::string text = textOf(sample);
    const auto calibration = read(sample.file, text);
    const auto same = read(sample.file, asOfWindows(text));
    ASSERT_TRUE(calibration) << sample.format << ": " << base::errorSentence(calibration.error());
    ASSERT_TRUE(same) << sample.format << ": " << base::errorSentence(same.error());
    EXPECT_EQ(same->rig, calibration->rig) << sample.format;
  }
}

TEST_F(HostileCalibration, ClaimsAreBounded) {
  EXPECT_EQ(problemOf("a.yml", "%YAML:1.0\n---\nnb_camera: 1000000000\n"),
            "nb_camera: not a usable value (1 to 1000 cameras are expected, found 1000000000, line "
            "3)");
  std::string text = textOf(kSamples[0]);
  text.replace(text.find("[640, 480]"), 10, "[1000000, 1000000]");
  EXPECT_EQ(problemOf("b.toml", text),
            "cam_0.size: not a usable value (1000000 is not within 1 to 100000, line 3)");
  text = corpusText("ros/left.yaml");
  const auto width = text.find("image_width:");
  text.replace(width, text.find('\n', width) - width, "image_width: 1000000");
  EXPECT_NE(problemOf("c.yaml", text).find("whole pixels, 1 to 100000, found 1000000 x"),
            std::string::npos);
  text = corpusText("kalibr/camchain.yaml");
  const auto size = text.find("resolution: [") + 13;
  text.replace(size, text.find(']', size) - size, "100000, 100000");
  EXPECT_NE(problemOf("d.yaml", text).find("100000 x 100000 pixels are more than 268435456"),
            std::string::npos);
}

TEST_F(HostileCalibration, CamerasAreCounted) {
  std::string toml;
  std::string caliscope;
  std::string xml = "<calibration><cameras><!-- focalLengthU -->";
  for (int k = 0; k <= 1000; ++k) {
    toml += fmt::format("[cam_{}]\nmatrix = 1\n", k);
    caliscope += fmt::format("[cameras.{}]\nignore = true\n", k);
  }
  EXPECT_EQ(problemOf("a.toml", toml),
            "camera 1001: not a usable value (at most 1000 cameras are possible)");
  EXPECT_EQ(problemOf("b.toml", caliscope),
            "camera 1001: not a usable value (at most 1000 cameras are possible)");
  std::string json = R"({"cameras": {)";
  for (int k = 0; k <= 1000; ++k) {
    json += fmt::format("\"c{}\": {{}}, ", k);
  }
  EXPECT_NE(problemOf("c.json", json + R"(}, "camera_poses": {}})").find("at most 1000 cameras"),
            std::string::npos);
  std::string yaml = "cam0: {intrinsics: 1}\nintrinsics: 1\n";
  for (int k = 0; k <= 2000; ++k) {
    yaml += fmt::format("k{}: 1\n", k);
  }
  EXPECT_EQ(problemOf("d.yaml", yaml),
            "key 2001: not a usable value (at most 2000 keys are possible)");
}

// Before, the first ran until the stack was full, the second until the memory was.
TEST_F(HostileCalibration, AliasesThatNeverEndAreOneSentence) {
  const std::string head = "image_width: 640\nimage_height: 480\ndistortion_model: plumb_bob\n"
                           "distortion_coefficients: [0, 0, 0, 0, 0]\n";
  EXPECT_EQ(problemOf("a.yaml", head + "camera_matrix: &a [1, *a]\n"),
            "camera_matrix: wrong type of value (numbers are expected, line 5)");
  std::string doubled = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int k = 1; k < 40; ++k) {
    doubled += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", k, k - 1);
  }
  EXPECT_NE(
      problemOf("b.yaml", head + doubled + "camera_matrix: *a39\n").find("numbers are expected"),
      std::string::npos);
  std::string empty = "a0: &a0 []\n";
  for (int k = 1; k < 40; ++k) {
    empty += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", k, k - 1);
  }
  EXPECT_NE(problemOf("c.yaml", head + empty + "camera_matrix: *a39\n"), "");
}

TEST_F(HostileCalibration, NestedDeeperThanTheStackIsOneSentence) {
  std::string deep;
  for (int k = 0; k < 100'000; ++k) {
    deep += "<a>";
  }
  EXPECT_NE(problemOf("a.xml", "<calibration><!-- focalLengthU -->" + deep), "");
  EXPECT_NE(problemOf("b.yaml", "cam0:\n intrinsics: " + std::string(100'000, '[')), "");
  EXPECT_NE(problemOf("c.json", R"({"camera_poses": )" + std::string(100'000, '{')), "");
  EXPECT_NE(problemOf("d.toml", "[a" + std::string(100'000, '.') + "]"), "");
}

TEST_F(HostileCalibration, OfMegabytesIsOneSentence) {
  const std::string long5 = textOf(kSamples[0]) + "# " + std::string(5U << 20U, 'x') + "\n";
  EXPECT_EQ(problemOf("a.toml", long5), "invalid format (too large for a calibration)");
  EXPECT_NE(problemOf("b.toml", std::string(1U << 20U, 'x')), "");
  // mrcal's files carry what they were made from.
  std::string model = corpusText("mrcal/left.cameramodel");
  model.insert(model.rfind('}'),
               "'optimization_inputs': b'" + std::string(5U << 20U, 'A') + "',\n");
  EXPECT_EQ(problemOf("c.cameramodel", model), "");
}

} // namespace
} // namespace dewpoint::tests
