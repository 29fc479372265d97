// SPDX-License-Identifier: GPL-3.0-or-later
// Project files that nobody would write who means well: each is one sentence, at once.
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/fuzz/hostile_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <utility>

namespace dewpoint::tests {
namespace {

class HostileProject : public testing::Test {
protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) /
            (std::string("HostileProject") + info->name() + ".toml");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Result<Project> load(const std::string& text) {
    writeBytes(file_, text);
    return loadProject(file_);
  }
  /// What is wrong, without the file; empty: nothing.
  std::string problemOf(const std::string& text) {
    const auto project = load(text);
    const std::string sentence = project ? "" : base::errorSentence(project.error());
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_LT(sentence.size(), 5000U);
    return sentence.starts_with(file_.string()) ? sentence.substr(file_.string().size() + 2)
                                                : sentence;
  }
  std::string changed(const std::string& from, const std::string& to) const {
    std::string text = whole_;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  std::filesystem::path file_;
  std::string whole_ = corpusText("project/everything.toml");
};

TEST_F(HostileProject, WithoutAnythingHostileIsRead) {
  const auto project = load(whole_);
  ASSERT_TRUE(project) << base::errorSentence(project.error());
  EXPECT_EQ(project->corrections.size(), 1U);
}

TEST_F(HostileProject, NoFieldTakesWhatIsNoFiniteNumber) {
  const auto places = numberPlaces(whole_);
  EXPECT_GT(places.size(), 100U);
  for (const NumberPlace& place : places) {
    for (const char* number : {"nan", "inf", "-inf", "1e400", "-9223372036854775808", "1e300"}) {
      std::string text = whole_;
      const std::string was = text.substr(place.begin, place.count);
      text.replace(place.begin, place.count, number);
      EXPECT_NE(problemOf(text), "") << was << " at " << place.begin << " is now " << number;
    }
  }
}

TEST_F(HostileProject, TheParticlesOfAllTargetsAreBoundedTogether) {
  std::string text = changed("particles = 500", "particles = 100000");
  EXPECT_EQ(problemOf(text), "");
  for (int target = 0; target < 250; ++target) {
    text += fmt::format("\n[[target]]\nname = \"more {}\"\nhue = [100, 120]\n"
                        "saturation = [0.3, 1]\nintensity = [0.1, 0.9]\n",
                        target);
  }
  EXPECT_NE(problemOf(text).find("parameters.particles: not a usable value (100000 for each of "),
            std::string::npos)
      << problemOf(text);
  EXPECT_NE(problemOf(text).find("at most 20000000 in all"), std::string::npos) << problemOf(text);
}

TEST_F(HostileProject, ClaimsAreBounded) {
  EXPECT_EQ(problemOf(changed("particles = 500", "particles = 1000000000000")),
            "parameters.particles: not a usable value (1000000000000 is not a whole number from 10 "
            "to 100000, line 10)");
  EXPECT_EQ(
      problemOf(changed("size = [640, 480]", "size = [1000000, 1000000]")),
      "camera 1.calibration.size: not a usable value (1000000 is not within 1 to 100000, line "
      "46)");
  EXPECT_EQ(problemOf(changed("size = [640, 480]", "size = [100000, 100000]")),
            "camera 1.calibration.size: not a usable value (100000 x 100000 pixels are more than "
            "268435456, line 46)");
  EXPECT_EQ(problemOf(changed("[[mark]]\nframe = 10", "[[mark]]\nframe = 9000000000000000000")),
            "mark 1.frame: not a usable value (9000000000000000000 is not within 0 to 10000000000, "
            "line 65)");
}

TEST_F(HostileProject, CamerasAndTargetsAreCounted) {
  std::string text = whole_;
  for (int k = 0; k < 1000; ++k) {
    text += "[[camera]]\n";
  }
  EXPECT_NE(problemOf(text).find("camera: not a usable value (1002; at most 1000 are possible"),
            std::string::npos);
  text = whole_;
  for (int k = 0; k < 1000; ++k) {
    text += "[[target]]\n";
  }
  EXPECT_NE(problemOf(text).find("target: not a usable value (1001; at most 1000 are possible"),
            std::string::npos);
}

TEST_F(HostileProject, UnderWindowsIsTheSame) {
  const auto project = load(whole_);
  const auto same = load(asOfWindows(whole_));
  ASSERT_TRUE(same) << base::errorSentence(same.error());
  EXPECT_EQ(*same, *project);
}

TEST_F(HostileProject, TextThatIsNoneIsOneSentence) {
  using namespace std::string_literals;
  for (const std::string& text :
       {""s, "\xFF\xFE"s, "format = 2\0"s, whole_ + "\xC3",
        whole_ + "a = [" + std::string(500, '['),
        "format = 2\n[a" + std::string(200'000, '.') + "]", std::string(1'000'000, 'x'),
        "format = 1e300"s, "format = 9223372036854775807"s, "\"a\nb\" = 1"s,
        whole_ + "\n[\"" + std::string(100'000, 'k') + "\"]\n",
        whole_ + "\n\"a\\u0007\\nb\" = 1\n"}) {
    EXPECT_NE(problemOf(text), "");
  }
}

TEST_F(HostileProject, CalibrationThatNeverEndsIsOneSentence) {
  EXPECT_EQ(problemOf("calibration = \"/dev/zero\"\n" + whole_),
            "/dev/zero: the file cannot be read (it is a device)");
}

TEST_F(HostileProject, NamesOfAnyCharactersComeBack) {
  auto project = load(whole_);
  project->targets.front().name = "a\x7F\"\\\n\t\xC3\xA4";
  ASSERT_TRUE(saveProject(*project, file_));
  const auto again = loadProject(file_);
  ASSERT_TRUE(again) << base::errorSentence(again.error());
  EXPECT_EQ(again->targets.front().name, project->targets.front().name);
}

} // namespace
} // namespace dewpoint::tests
