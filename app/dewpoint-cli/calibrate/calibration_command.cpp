// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/commands.h"
#include "app/dewpoint-cli/common/exit_code.h"
#include "core/base/uncertainty_text.h"
#include "core/calibration/formats/convert_calibration.h"
#include "core/calibration/formats/format_catalog.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::app {
namespace {

struct ConvertOptions {
  std::string in;
  std::string unit;
  std::string outUnit;
  std::string size;
  std::string lens;
  std::string poses;
  std::string fit;
  std::string toSize;
  std::vector<std::string> names;
  CalibrationHints hints;
  CalibrationOutput target;
  CalibrationChanges changes;
};

/// A unit's meters, checked by the command line already.
std::optional<double> meters(const std::string& unit) {
  return unit.empty() ? std::nullopt : parseLengthUnit(unit);
}

std::string wrongSize(const std::string& text) {
  int width = 0;
  int height = 0;
  char rest = 0;
  const int count = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest);
  return count == 2 && width > 0 && height > 0 ? "" : "expected WIDTHxHEIGHT, such as 1280x720";
}

std::array<int, 2> sizeFrom(const std::string& text) {
  std::array<int, 2> size{};
  std::sscanf(text.c_str(), "%dx%d", &size[0], &size[1]);
  return size;
}

/// The text options that change the cameras.
Status takeChanges(ConvertOptions& options) {
  auto names = parseCameraRenaming(options.names);
  if (!names) {
    return tl::make_unexpected(names.error());
  }
  options.changes.adaptation = {std::move(*names), parseSizeFit(options.fit)};
  if (!options.toSize.empty()) {
    options.changes.imageSize = sizeFrom(options.toSize);
  }
  const bool isRotation = options.fit.starts_with("rotate");
  if (!options.fit.empty() && !isRotation && options.toSize.empty()) {
    return failure(ErrorCode::MissingKey, "", "--to-size",
                   fmt::format("--fit {} needs the size of the images", options.fit));
  }
  return {};
}

void takeHints(ConvertOptions& options) {
  options.hints.metersPerUnit = meters(options.unit);
  options.target.metersPerUnit = meters(options.outUnit);
  if (!options.size.empty()) {
    options.hints.imageSize = sizeFrom(options.size);
  }
  if (!options.lens.empty()) {
    options.hints.lens = options.lens == "fisheye" ? LensModel::Fisheye : LensModel::Pinhole;
  }
  if (!options.poses.empty()) {
    options.hints.posesAreWorldFromCamera = options.poses == "world-from-camera";
  }
}

std::string cameraSentence(const CameraDifference& camera) {
  std::string text = fmt::format("{}: largest difference over the image {} px{}", camera.camera,
                                 twoSignificantDigitsText(camera.maxDifferencePx),
                                 camera.isRefitted ? " (refitted)" : "");
  if (camera.unseenDirectionCount > 0) {
    text +=
        fmt::format("; {} of 81 directions no longer map to a pixel", camera.unseenDirectionCount);
  }
  return text;
}

int convert(ConvertOptions& options) {
  takeHints(options);
  if (const auto taken = takeChanges(options); !taken) {
    reportError(taken.error());
    return kExitUsage;
  }
  const auto conversion =
      convertCalibration(options.in, options.hints, options.target, options.changes);
  if (!conversion) {
    return reportError(conversion.error());
  }
  for (const std::string& decision : conversion->decisions) {
    fmt::print("{}\n", decision);
  }
  for (const std::string& notice : conversion->notices) {
    fmt::print(stderr, "dewpoint-cli: note: {}.\n", notice);
  }
  for (const CameraDifference& camera : conversion->cameraDifferences) {
    fmt::print("{}\n", cameraSentence(camera));
  }
  fmt::print("largest reprojection difference: {} px\n",
             twoSignificantDigitsText(conversion->maxDifferencePx));
  for (const auto& file : conversion->writtenFiles) {
    fmt::print("{}\n", file.string());
  }
  return kExitDone;
}

std::string formatNames() {
  std::string names;
  for (const CalibrationFormat& format : calibrationFormats()) {
    names += fmt::format("\n  {:<14} {}{}", format.name, format.title,
                         format.write == nullptr ? " (only read)" : "");
  }
  return "The formats:" + names;
}

} // namespace

void addCalibrationCommand(CLI::App& app, int& exitCode) {
  auto* command = app.add_subcommand("calibration", "Work with calibration files.");
  command->require_subcommand(1);
  auto* convertCommand = command->add_subcommand(
      "convert", "Convert calibration files between Dewpoint and other tools.");
  auto options = std::make_shared<ConvertOptions>();
  auto* add = convertCommand;
  add->add_option("IN", options->in, "File, or folder with a file per camera")->required();
  add->add_option("OUT", options->target.path, "File to write, or folder for a file per camera")
      ->required();
  add->add_option("--from", options->hints.format, "Format of IN; detected if omitted");
  add->add_option("--to", options->target.format,
                  "Format of OUT; taken from the file name extension if omitted");
  add->add_option("--unit", options->unit,
                  "Unit of IN: m, mm, cm, in, ft, or the length of one unit in meters")
      ->check(lengthUnitProblem);
  add->add_option("--out-unit", options->outUnit, "Unit of OUT, if the format does not define it")
      ->check(lengthUnitProblem);
  add->add_option("--size", options->size, "WIDTHxHEIGHT of the images, if IN does not contain it")
      ->check(wrongSize);
  add->add_option("--lens", options->lens,
                  "Lens model to which four distortion coefficients in IN belong")
      ->check(CLI::IsMember({"pinhole", "fisheye"}));
  add->add_option("--poses", options->poses,
                  "Direction of the poses in IN, if it differs from the format's default")
      ->check(CLI::IsMember({"camera-from-world", "world-from-camera"}));
  add->add_option("--map", options->names,
                  "NAME=NAME IN THE FILE: write the camera with the second name under the first "
                  "name; repeat for each camera")
      ->allow_extra_args(false);
  auto* fit =
      add->add_option(
             "--fit", options->fit,
             "How the images were changed after the calibration: cropped on all sides, trimmed at "
             "the right and below, scaled, or rotated clockwise by 90 or 270 degrees")
          ->check(CLI::IsMember({"crop", "trim", "scale", "rotate-90", "rotate-270"}));
  add->add_option("--to-size", options->toSize, "With --fit: new size of the images, WIDTHxHEIGHT")
      ->check(wrongSize)
      ->needs(fit);
  add->add_flag("--force", options->target.replacesExisting, "Replace existing files");
  convertCommand->footer(formatNames());
  convertCommand->callback([options, &exitCode] { exitCode = convert(*options); });
}

} // namespace dewpoint::app
