// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "app/dewpoint-cli/project/color_sentences.h"
#include "app/dewpoint-cli/project/sample_argument.h"
#include "app/wiring/open_project.h"
#include "core/base/text_file.h"
#include "core/color/color_learning.h"
#include "core/color/match_image.h"
#include "core/geometry/camera_name.h"
#include "core/project/project_save.h"
#include "core/setup/clicks/footage_learning.h"
#include "core/setup/follow_all.h"
#include "core/tracking/target_shape_name.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include <memory>
#include <optional>

namespace dewpoint::app {
namespace {

struct LearnColorOptions {
  std::string project;
  std::string camera = "1";
  std::int64_t frame = 0;
  std::string pixel, box;
  std::vector<std::string> more, excluded;
  std::optional<std::string> target;
  std::optional<double> radius;
  std::optional<std::string> shape;
  std::string mask, out;
  bool followAll = false;
};

/// The first place is the click itself. Their colors are not taken yet.
Result<std::vector<ColorSample>> markedSamplesOf(const LearnColorOptions& options,
                                                 const Project& project) {
  auto click =
      options.box.empty() ? parseClick(options.pixel, "--pixel") : parseBox(options.box, "--box");
  const auto camera = findCameraIndex(project, options.camera, "--camera");
  if (!click || !camera) {
    return tl::make_unexpected(click ? camera.error() : click.error());
  }
  click->camera = *camera;
  click->frame = options.frame;
  std::vector<ColorSample> markedSamples{*click};
  const auto add = [&](const std::vector<std::string>& texts, const char* option, bool excluded) {
    for (const std::string& text : texts) {
      auto marked = parseSample(project, text, option);
      if (!marked) {
        return Status(tl::make_unexpected(marked.error()));
      }
      marked->isExcluded = excluded;
      markedSamples.push_back(*marked);
    }
    return Status();
  };
  return add(options.more, "--more", false)
      .and_then([&] { return add(options.excluded, "--exclude", true); })
      .map([&] { return markedSamples; });
}

Status writeMask(const std::string& file, const cv::Mat& image, const ColorRanges& ranges) {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", matchImage(image, ColorClassifier(ranges)), png);
  return writeTextFile(file, std::string(png.begin(), png.end()));
}

/// Where the other cameras were found to show the target.
void printFound(const std::vector<ColorSample>& samples, const Project& project) {
  for (const ColorSample& sample : samples) {
    if (sample.isFoundByGeometry) {
      const auto camera = static_cast<std::size_t>(sample.camera);
      fmt::print("Found in {} at {:.0f},{:.0f}.\n",
                 geometry::nameOrNumber(project.cameras[camera].camera, camera), sample.x,
                 sample.y);
    }
  }
}

void printLearned(const Target& target, const setup::ClickLearningResult& result,
                  const Project& project) {
  std::vector<std::string> cameras;
  for (const ProjectCamera& camera : project.cameras) {
    cameras.push_back(camera.camera.name);
  }
  fmt::print("{}: the sample has {} pixels.\n", target.name, target.samples.front().areaPx);
  printFound(target.samples, project);
  for (const ColorRange& range : result.color.ranges()) {
    fmt::print("{}\n", describeRange(range));
  }
  if (!result.color.otherRanges.empty()) {
    fmt::print("The samples show {} colors: a pixel within any of their ranges counts as target.\n",
               result.color.ranges().size());
  }
  for (const std::string& text : describeAssessment(result.color.assessment, cameras)) {
    fmt::print("{}\n", text);
  }
  if (result.part) {
    fmt::print("The marked spot is part of a larger object of the same color. Only this spot is "
               "tracked, as a ball with radius {:.2g} m.\n",
               target.radius);
  }
  if (const auto text = describeRadius(target.radius, result.radius); !text.empty()) {
    fmt::print("{}\n", text);
  }
}

/// Makes a target of each of the other things that have the color and size of the one that was
/// taught, and says how many.
void addAllAlike(setup::FootageLearningResult& taught) {
  const int missing = setup::missingTargetCount(taught.project, taught.target,
                                                taught.learningResult.color.assessment);
  setup::addTargetCopies(taught.project, taught.target, missing, [](const Project& project) {
    return setup::unusedTargetName(
        project, [](std::size_t number) { return fmt::format("target {}", number); });
  });
  fmt::print("Targets added for other objects of this color and size: {}.\n", missing);
}

/// Says what was learned, and writes its mask and the project.
Status keep(const LearnColorOptions& options, setup::FootageLearningResult& taught) {
  printLearned(taught.project.targets[taught.target], taught.learningResult, taught.project);
  if (options.followAll) {
    addAllAlike(taught);
  }
  const auto drawn = options.mask.empty() ? Status()
                                          : writeMask(options.mask, taught.clickedImage,
                                                      taught.learningResult.color.ranges());
  return !drawn || options.out.empty() ? drawn : saveProject(taught.project, options.out);
}

Status checkMask(const std::string& mask) {
  const std::string ending = std::filesystem::path(mask).extension().string();
  if (!mask.empty() && ending != ".png") {
    return failure(ErrorCode::BadValue, "", "--mask",
                   fmt::format("the output is a PNG; the file name cannot end in “{}”", ending));
  }
  return {};
}

/// The error with the option that was typed in place of what the library calls it.
Error asTyped(Error error, const LearnColorOptions& options) {
  if (error.field == "pixel" || error.field == "box") { // in no file
    error.field = options.box.empty() ? "--pixel" : "--box";
  }
  if (error.field == "frame" || error.field == "target") {
    error.field = "--" + error.field;
  }
  if (error.file.empty()) {
    error.file = options.project;
  }
  return error;
}

int learn(const LearnColorOptions& options) {
  if (const auto writable = checkMask(options.mask); !writable) {
    reportError(writable.error());
    return kExitUsage;
  }
  auto project = resolveProject(options.project);
  if (!project) {
    return reportError(project.error());
  }
  auto samples = markedSamplesOf(options, *project);
  if (!samples) {
    reportError(samples.error());
    return kExitUsage;
  }
  auto inputs = openInputs(std::move(*project));
  if (!inputs) {
    return reportError(inputs.error());
  }
  setup::FootageClicks clicks{std::move(*samples), options.target, options.radius, std::nullopt};
  if (options.shape) {
    clicks.shape = targetShapeFromName(*options.shape);
  }
  auto taught = setup::learnFromFootage(std::move(inputs->project), *inputs->source,
                                        inputs->backgroundImages, std::move(clicks));
  if (!taught) {
    return reportError(asTyped(taught.error(), options));
  }
  const auto kept = keep(options, *taught);
  return kept ? static_cast<int>(kExitDone) : reportError(asTyped(kept.error(), options));
}

} // namespace

void addLearnColorCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("learn-color", "Learn a target's color from a click on it.");
  auto options = std::make_shared<LearnColorOptions>();
  command->add_option("PROJECT", options->project, "Project file (TOML), or a built-in scene: demo")
      ->required();
  command
      ->add_option("--camera", options->camera,
                   "Camera whose image you click: its name, or its number from 1")
      ->capture_default_str();
  command->add_option("--frame", options->frame, "Frame in which you click, counted from 0")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40))
      ->capture_default_str();
  auto* marked = command->add_option_group("place");
  marked->add_option("--pixel", options->pixel, "X,Y of the click on the target");
  marked->add_option("--box", options->box, "X,Y,WIDTH,HEIGHT of a box around the target");
  marked->require_option(1);
  command->add_option("--more", options->more, "Another click on the target, CAMERA:FRAME:X,Y");
  command->add_option("--exclude", options->excluded,
                      "A click on an object that is not the target, CAMERA:FRAME:X,Y");
  command->add_option("--target", options->target,
                      "Name of the target; a new target is created if there is none of this name");
  command->add_option("--radius", options->radius, "Radius of the target, meters")
      ->check(CLI::Range(0.0, 1000.0));
  command
      ->add_option("--shape", options->shape,
                   "Shape of the target: auto (determined from the images), ball or any")
      ->check(CLI::IsMember(targetShapeNames()));
  command->add_flag(
      "--follow-all", options->followAll,
      "Also add a target for each other object of this color and size, unless there are many");
  command->add_option("--mask", options->mask,
                      "PNG image to write: white where the clicked image has the learned color");
  command->add_option("--out", options->out, "Project file to write, with the learned color");
  command->callback([options, &exitCode] { exitCode = learn(*options); });
}

} // namespace dewpoint::app
