// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_changes.h"
#include "core/project/project_check.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/project/loaded_text.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace dewpoint::tests {
namespace {

constexpr const char* kGood = R"(format = 1
name = "two cameras"
seed = 7
method = "barrera"
frames_per_second = 25
truth = "truth.csv"

[parameters]
particles = 500
motion_sigma = 0.02

[[target]]
name = "ball"
radius = 0.035
hue = [330, 20]
saturation = [0.3, 1]
intensity = [0.1, 0.9]

[[camera]]
name = "left"
video = "left.mkv"
[camera.calibration]
size = [640, 480]
matrix = [[500.0, 0, 319.5], [0, 510.0, 239.5], [0, 0, 1]]
rotation = [0, 0.1, 0]
translation = [1.0, 2.0, 3.0]
)";

Error errorOf(const std::string& from, const std::string& to) {
  const auto project = load(kGood, from, to);
  EXPECT_FALSE(project) << from << " -> " << to;
  return project ? Error{} : project.error();
}

TEST(ProjectFile, KeepsWhetherATargetIsShown) {
  EXPECT_TRUE(load(kGood)->targets.front().isShown);
  const auto hidden = load(kGood, "radius = 0.035", "radius = 0.035\nshown = false");
  ASSERT_TRUE(hidden);
  EXPECT_FALSE(hidden->targets.front().isShown);
  const auto file = fileNamed("hidden.toml");
  ASSERT_TRUE(saveProject(*hidden, file));
  EXPECT_FALSE(loadProject(file)->targets.front().isShown);
  const Error bad = errorOf("radius = 0.035", "radius = 0.035\nshown = 1");
  EXPECT_EQ(bad.field, "target 1.shown");
}

TEST(ProjectFile, KeepsTheShapeOfATarget) {
  EXPECT_EQ(load(kGood)->targets.front().shape, TargetShape::Auto);
  const auto any = load(kGood, "radius = 0.035", "radius = 0.035\nshape = \"any\"");
  ASSERT_TRUE(any);
  EXPECT_EQ(any->targets.front().shape, TargetShape::Any);
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*any, file));
  EXPECT_EQ(loadProject(file)->targets.front().shape, TargetShape::Any);
  const Error bad = errorOf("radius = 0.035", "radius = 0.035\nshape = \"round\"");
  EXPECT_EQ(bad.field, "target 1.shape");
}

TEST(ProjectFile, WhatWasSaidOfPeopleComesBackInTheOrderOfTheirFrames) {
  EXPECT_TRUE(load(kGood)->personCorrections.empty()); // as in every file before there was this
  auto project = load(std::string(kGood) + "[[person]]\nframe = 90\nplace = [1.5, -0.25]\n"
                                           "present = false\n"
                                           "[[person]]\nframe = 12\nplace = [0.5, 2]\n"
                                           "[[person]]\nframe = 12\ncamera = 1\n"
                                           "pixel = [20.5, 31]\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  std::vector<PersonCorrection> expected(3);
  expected[0] = {12, Eigen::Vector2d(0.5, 2.0), std::nullopt, true};
  expected[1] = {12, std::nullopt, PersonCorrection::Click{0, {20.5, 31.0}}, true};
  expected[2] = {90, Eigen::Vector2d(1.5, -0.25), std::nullopt, false};
  EXPECT_EQ(project->personCorrections, expected);
  const auto file = fileNamed("again.toml");
  ASSERT_TRUE(saveProject(*project, file));
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->personCorrections, expected);
  addPersonCorrection(*project, {12, Eigen::Vector2d(3.0, 3.0), std::nullopt, true});
  EXPECT_EQ(project->personCorrections.at(2).position, Eigen::Vector2d(3.0, 3.0));
  EXPECT_TRUE(changesBetween(*again, *project).personCorrectionsChanged);
  EXPECT_TRUE(changesBetween(*again, *project).hasAny());
}

TEST(ProjectFile, PersonsThatCannotBeAreRefused) {
  const auto field = [](const char* person) {
    const auto project = load(std::string(kGood) + "[[person]]\n" + person);
    return project ? std::string("none") : project.error().field;
  };
  EXPECT_EQ(field("frame = 3\n"), "person 1.place");
  EXPECT_EQ(field("place = [0, 0]\n"), "person 1.frame");
  EXPECT_EQ(field("frame = 3\ncamera = 1\n"), "person 1.pixel");
  EXPECT_EQ(field("frame = 3\ncamera = 9\npixel = [1, 1]\n"), "person 1.camera");
  EXPECT_EQ(field("frame = 3\nplace = [0, 0]\ncamera = 1\npixel = [1, 1]\n"), "person 1");
  EXPECT_EQ(field("frame = 3\ncamera = 1\npixel = [1, 1]\npresent = false\n"), "person 1.present");
  EXPECT_EQ(field("frame = 3\nplace = [0, 1e9]\n"), "person 1.place");
  EXPECT_EQ(field("frame = 3\nplace = [0, 0]\n"), "none");
}

TEST(ProjectFile, MarkersComeBackInTheOrderOfTheirFrames) {
  auto project = load(std::string(kGood) + "[[mark]]\nframe = 90\nname = \"lost\"\n"
                                           "[[mark]]\nframe = 12\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  const std::vector<ProjectMarker> expected{{12, ""}, {90, "lost"}};
  EXPECT_EQ(project->markers, expected);
  const auto file = fileNamed("again.toml");
  ASSERT_TRUE(saveProject(*project, file));
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->markers, expected);
  EXPECT_EQ(load(std::string(kGood) + "[[mark]]\nframe = -1\n").error().field, "mark 1.frame");
}

TEST(ProjectFile, ReadsEveryKey) {
  const auto project = load(kGood);
  ASSERT_TRUE(project) << errorSentence(project.error());
  EXPECT_EQ(project->name, "two cameras");
  EXPECT_EQ(project->seed, 7U);
  EXPECT_EQ(project->parameters.at("particles"), 500);
  EXPECT_EQ(project->targets.front().color.hueMin, 330);
  EXPECT_EQ(project->cameras.front().camera.name, "left");
  EXPECT_EQ(project->cameras.front().source, SourceKind::Video);
  // Relative paths count from the project's own folder.
  EXPECT_EQ(std::filesystem::path(project->cameras.front().location).parent_path(),
            project->file.parent_path());
  EXPECT_TRUE(project->truthFile->is_absolute());
}

TEST(ProjectFile, SavedTwiceItIsTheSameBytes) {
  const auto first = load(kGood);
  ASSERT_TRUE(first);
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*first, file));
  const auto text = readTextFile(file);
  const auto second = loadProject(file);
  ASSERT_TRUE(second) << errorSentence(second.error());
  ASSERT_TRUE(saveProject(*second, file));
  EXPECT_EQ(*readTextFile(file), *text);
  EXPECT_EQ(second->parameters, first->parameters);
  EXPECT_EQ(second->targets.front().color, first->targets.front().color);
  EXPECT_EQ(second->cameras.front().location, first->cameras.front().location);
}

// Else other cameras would not change where it starts.
TEST(ProjectFile, WhatComesFromTheCamerasIsNotWrittenUnlessItWasGiven) {
  const auto open = load(kGood);
  ASSERT_TRUE(open);
  EXPECT_FALSE(open->parameters.isGiven("start_x"));
  EXPECT_NE(effectiveParameters(*open).at("start_half_x"), 0.0); // the default of the method
  const std::string text = projectText(*open, "");
  EXPECT_EQ(text.find("start_"), std::string::npos);
  EXPECT_NE(text.find("motion_sigma"), std::string::npos);

  const auto given = load(kGood, "particles = 500\n", "particles = 500\nstart_x = 0.4\n");
  ASSERT_TRUE(given) << errorSentence(given.error());
  EXPECT_EQ(effectiveParameters(*given), given->parameters);
  EXPECT_EQ(effectiveParameters(*given).at("start_half_x"), 0.0);
  const auto again = load(projectText(*given, given->file.parent_path()));
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->parameters, given->parameters);
}

TEST(ProjectFile, KeepsTheBackgroundImageOfACamera) {
  const auto project = load(kGood, "video = \"left.mkv\"\n",
                            "video = \"left.mkv\"\nempty_room = \"empty/left.png\"\n");
  ASSERT_TRUE(project) << errorSentence(project.error());
  const std::filesystem::path room = project->cameras.front().backgroundImageFile;
  EXPECT_EQ(room, project->file.parent_path() / "empty/left.png");
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*project, file));
  EXPECT_NE(readTextFile(file)->find("empty_room = \"empty/left.png\""), std::string::npos);
  const auto again = loadProject(file);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(again->cameras, project->cameras);
  Project without = *project;
  without.cameras.front().backgroundImageFile.clear();
  EXPECT_TRUE(changesBetween(without, *project).backgroundImagesChanged);
  EXPECT_FALSE(changesBetween(without, *project).sourcesChanged) << "the recording is the same";
  EXPECT_EQ(projectText(without, file.parent_path()).find("empty_room"), std::string::npos);
  EXPECT_EQ(errorOf("video = \"left.mkv\"\n", "video = \"left.mkv\"\nempty_room = 3\n").field,
            "camera 1.empty_room");
}

constexpr const char* kSamples = R"([[target.sample]]
camera = 2
frame = 17
pixel = [120.5, 88]
area = 700
colors = "ff0080 0a0b0c"
found = true
[[target.sample]]
camera = 1
box = [10, 20, 30, 40]
excluded = true
)";

TEST(ProjectFile, KeepsWhatAColorWasLearnedFrom) {
  const std::string samples = std::string("intensity = [0.1, 0.9]\n") + kSamples;
  const auto project = load(kGood, "intensity = [0.1, 0.9]\n", samples);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const Target& target = project->targets.front();
  ASSERT_EQ(target.samples.size(), 2U);
  ColorSample click{
      .isFoundByGeometry = true, .camera = 1, .frame = 17, .x = 120.5, .y = 88, .areaPx = 700};
  click.colors = {{0x80, 0x00, 0xff}, {0x0c, 0x0b, 0x0a}};
  EXPECT_EQ(target.samples[0], click);
  const ColorSample box{.isExcluded = true, .x = 10, .y = 20, .width = 30, .height = 40};
  EXPECT_EQ(target.samples[1], box);
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*project, file));
  EXPECT_EQ(loadProject(file)->targets, project->targets);

  Project without = *project;
  without.targets.front().samples.pop_back();
  EXPECT_TRUE(changesBetween(*project, without).targetsChanged);
}

TEST(ProjectFile, KeepsTheColorsOfATarget) {
  const std::string others = "intensity = [0.1, 0.9]\n"
                             "[[target.other_color]]\nhue = [50, 70]\nsaturation = [0.3, 0.8]\n"
                             "[[target.other_color]]\nhue = [200, 250]\n";
  const auto project = load(kGood, "intensity = [0.1, 0.9]\n", others);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const Target& target = project->targets.front();
  EXPECT_EQ(target.otherColors, (std::vector<ColorRange>{{50.0, 70.0, 0.3, 0.8}, {200.0, 250.0}}));
  EXPECT_EQ(target.colors().size(), 3U);
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*project, file));
  EXPECT_EQ(loadProject(file)->targets, project->targets);

  Project without = *project;
  without.targets.front().otherColors.pop_back();
  EXPECT_TRUE(changesBetween(*project, without).targetsChanged);
}

TEST(ProjectFile, NamesTheColorThatIsWrong) {
  const auto noHue = load(kGood, "intensity = [0.1, 0.9]\n",
                          "intensity = [0.1, 0.9]\n[[target.other_color]]\nsaturation = [0, 1]\n");
  ASSERT_FALSE(noHue);
  EXPECT_EQ(noHue.error().field, "target 1.other_color 1.hue");
  const auto reversed = load(
      kGood, "intensity = [0.1, 0.9]\n",
      "intensity = [0.1, 0.9]\n[[target.other_color]]\nhue = [0, 9]\nsaturation = [0.9, 0.1]\n");
  ASSERT_FALSE(reversed);
  EXPECT_EQ(reversed.error().field, "target 1.other_color 1.saturation");
}

constexpr const char* kBox =
    "intensity = [0.1, 0.9]\nbox = {camera = 1, frame = 12, x = 10.5, y = -3, width = 40, "
    "height = 50}\n";

TEST(ProjectFile, KeepsTheBoxOfATarget) {
  const auto project = load(kGood, "intensity = [0.1, 0.9]\n", kBox);
  ASSERT_TRUE(project) << errorSentence(project.error());
  const TargetBox expected{0, 12, {10.5, -3.0, 40.0, 50.0}};
  EXPECT_EQ(project->targets.front().box, expected);
  const auto file = fileNamed("saved.toml");
  ASSERT_TRUE(saveProject(*project, file));
  EXPECT_EQ(loadProject(file)->targets, project->targets);

  Project other = *project;
  other.targets.front().box->box.x += 1.0;
  EXPECT_TRUE(changesBetween(*project, other).targetsChanged);
  EXPECT_TRUE(changesBetween(*project, other).boxesChanged);
  other = *project;
  other.targets.front().radius += 1.0;
  EXPECT_FALSE(changesBetween(*project, other).boxesChanged);
}

TEST(ProjectFile, NamesWhatIsWrongWithABox) {
  const auto fieldOf = [](std::string from, std::string to) {
    std::string text = kBox;
    text.replace(text.find(from), from.size(), to);
    return errorOf("intensity = [0.1, 0.9]\n", text).field;
  };
  EXPECT_EQ(fieldOf("camera = 1", "camera = 9"), "target 1.box.camera"); // there is one
  EXPECT_EQ(fieldOf("width = 40", "width = 0"), "target 1.box.width");
  EXPECT_EQ(fieldOf("width = 40, ", ""), "target 1.box.width");
  EXPECT_EQ(fieldOf("frame = 12", "frame = -1"), "target 1.box.frame");
  EXPECT_EQ(fieldOf("x = 10.5", "x = 700"), "target 1.box"); // beside the image of 640 x 480
  EXPECT_EQ(fieldOf("height = 50", "depth = 50"), "target 1.box.depth"); // no such key
}

// A camera needs no calibration, a target no color.
TEST(ProjectFile, MethodsForBoxesNeedNoCalibration) {
  const auto textFor = [](const char* method) {
    return std::string("format = 2\nname = \"one camera\"\nmethod = \"") + method +
           "\"\n[[target]]\nname = \"thing\"\nbox = {camera = 1, frame = 0, x = 1, y = 2, "
           "width = 30, height = 40}\n[[camera]]\nname = \"only\"\nvideo = \"only.mp4\"\n";
  };
  for (const char* method : {"histogram", "sugandi"}) {
    const auto project = load(textFor(method));
    ASSERT_TRUE(project) << errorSentence(project.error());
    EXPECT_EQ(project->cameras.front().camera.intrinsics.width, 0); // its images will say
    EXPECT_TRUE(checkProject(*project));
    Project late = *project;
    late.cameras.front().delay = 3601.0;
    ASSERT_FALSE(checkProject(late));
    EXPECT_EQ(checkProject(late).error().field, "camera 1.late_by");
  }
  const auto refused = load(textFor("dewpoint"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "camera 1.calibration");
}

TEST(ProjectFile, NamesTheSampleThatIsWrong) {
  const auto fieldOf = [](std::string from, std::string to) {
    std::string text = kSamples;
    text.replace(text.find(from), from.size(), to);
    return errorOf("intensity = [0.1, 0.9]\n", text).field;
  };
  EXPECT_EQ(fieldOf("0a0b0c", "0a0b0"), "target 1.sample 1.colors");
  EXPECT_EQ(fieldOf("camera = 2", "camera = 0"), "target 1.sample 1.camera");
  EXPECT_EQ(fieldOf("pixel = [120.5, 88]", ""), "target 1.sample 1.pixel");
  EXPECT_EQ(fieldOf("30, 40", "30"), "target 1.sample 2.box");
}

// kGood is of format 1, as the first versions wrote it.
TEST(ProjectFile, AnOlderFormatIsReadAndWrittenAsThePresentOne) {
  const auto old = load(kGood);
  ASSERT_TRUE(old) << errorSentence(old.error());
  const std::string text = projectText(*old, fileNamed("").parent_path());
  EXPECT_NE(text.find("format = 2"), std::string::npos);
  const auto again = load(text);
  ASSERT_TRUE(again) << errorSentence(again.error());
  EXPECT_EQ(projectText(*again, fileNamed("").parent_path()), text);
}

TEST(ProjectFile, NamesTheKeyThatIsWrong) {
  EXPECT_EQ(errorOf("video =", "vidoe =").field, "camera 1.vidoe")
      << "a typing mistake is shown, not the source that is missing because of it";
  EXPECT_EQ(errorOf("seed = 7", "sede = 7").code, ErrorCode::UnknownKey);
  EXPECT_EQ(errorOf("seed = 7", "seed = \"x\"").code, ErrorCode::WrongType);
  EXPECT_EQ(errorOf("particles = 500", "particles = 3").field, "parameters.particles");
  EXPECT_EQ(errorOf("particles = 500", "particels = 500").code, ErrorCode::UnknownKey);
  EXPECT_EQ(errorOf("[0.3, 1]", "[0.8, 0.2]").field, "target 1.saturation");
  EXPECT_EQ(errorOf("500.0", "nan").field, "camera 1.calibration.matrix");
  EXPECT_EQ(errorOf("format = 1", "format = 99").field, "format");
  EXPECT_EQ(errorOf("rotation = [0, 0.1, 0]", "").field, "camera 1.calibration.rotation");
  EXPECT_NE(errorOf("name = \"ball\"", "name = ball").field.find("line"), std::string::npos);
}

// A project without a target is one whose color is still to be learned.
TEST(ProjectFile, NeedsACameraButNotYetATarget) {
  const std::string text = kGood;
  const auto camera = text.find("[[camera]]");
  const auto target = text.find("[[target]]");
  EXPECT_EQ(load(text.substr(0, camera)).error().field, "camera");
  const auto untaught = load(text.substr(0, target) + text.substr(camera));
  ASSERT_TRUE(untaught) << errorSentence(untaught.error());
  EXPECT_TRUE(untaught->targets.empty());
  EXPECT_EQ(load(text + text.substr(camera)).error().field, "camera") << "the same name twice";
}

TEST(ProjectFile, PathsMayNameAnEnvironmentVariable) {
  setenv("DEWPOINT_TEST_FOLDER", "/some/${DEWPOINT_TEST_FOLDER}", 1); // must not go on for ever
  const auto project = load(kGood, "left.mkv", "${DEWPOINT_TEST_FOLDER}/left.mkv");
  ASSERT_TRUE(project) << errorSentence(project.error());
  EXPECT_EQ(project->cameras.front().location, "/some/${DEWPOINT_TEST_FOLDER}/left.mkv");
  EXPECT_EQ(errorOf("left.mkv", "${DEWPOINT_NOT_SET}/left.mkv").field, "camera 1.video");
}

TEST(ProjectFile, AnUnwritablePlaceIsSaid) {
  const auto project = load(kGood);
  ASSERT_TRUE(project);
  const auto saved = saveProject(*project, "/nowhere/project.toml");
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::FileUnwritable);
}

} // namespace
} // namespace dewpoint::tests
