// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_targets.h"

#include "core/base/limits.h"
#include "core/project/project_format.h"
#include "core/tracking/target_shape_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>
#include <utility>

namespace dewpoint::project {
namespace {

constexpr double kLargestSide = 1e5; ///< of an image, pixels

void readRange(TableReader& reader, const char* key, double& low, double& high) {
  double bounds[2] = {low, high};
  if (reader.readNumbers(key, bounds, 2)) {
    low = bounds[0];
    high = bounds[1];
  }
}

/// "rrggbb rrggbb ...", as in HTML.
std::vector<BgrColor> readColors(TableReader& reader, const char* key) {
  std::string text;
  reader.readText(key, text);
  std::vector<BgrColor> colors;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    unsigned value = 0;
    const auto [end, failed] =
        std::from_chars(word.data(), word.data() + word.size(), value, 16); // not locale's
    if (failed != std::errc{} || end != word.data() + word.size() || word.size() != 6) {
      reader.fail(ErrorCode::BadValue, key, "'" + word + "' is not a color as rrggbb");
      return {};
    }
    colors.push_back({std::uint8_t(value), std::uint8_t(value >> 8), std::uint8_t(value >> 16)});
  }
  if (colors.size() > ColorSample::kMaxColors) {
    reader.fail(ErrorCode::BadValue, key, fmt::format("more than {}", ColorSample::kMaxColors));
  }
  return colors;
}

ColorSample readSample(const toml::table& table, const std::string& file, std::string prefix,
                       std::optional<Error>& error) {
  TableReader reader(table, file, std::move(prefix));
  ColorSample sample;
  reader.require("camera");
  int camera = 1;
  reader.readInteger("camera", camera, 1, limits::kMaxCameras);
  sample.camera = camera - 1;
  reader.readInteger("frame", sample.frame, 0, limits::kMaxFrames);
  double place[4] = {0.0, 0.0, 0.0, 0.0};
  if (reader.has("box")) {
    reader.readNumbers("box", place, 4, 0.0, kLargestSide);
  } else {
    reader.require("pixel");
    reader.readNumbers("pixel", place, 2, 0.0, kLargestSide);
  }
  sample.x = place[0];
  sample.y = place[1];
  sample.width = place[2];
  sample.height = place[3];
  reader.readBoolean("excluded", sample.isExcluded);
  reader.readBoolean("found", sample.isFoundByGeometry);
  reader.readInteger("area", sample.areaPx, 0, std::numeric_limits<int>::max());
  sample.colors = readColors(reader, "colors");
  error = reader.finish();
  return sample;
}

std::optional<TargetBox> readBox(TableReader& target, const std::string& file,
                                 const std::string& prefix) {
  const toml::table* table = target.findTable("box");
  if (table == nullptr) {
    return std::nullopt;
  }
  TableReader reader(*table, file, prefix + "box.");
  TargetBox box;
  reader.require("camera");
  int camera = 1;
  reader.readInteger("camera", camera, 1, limits::kMaxCameras);
  box.camera = camera - 1;
  reader.readInteger("frame", box.frame, 0, limits::kMaxFrames);
  for (const auto& [key, value] : {std::pair("x", &box.box.x), std::pair("y", &box.box.y)}) {
    reader.require(key);
    reader.readNumber(key, *value, -kLargestSide, kLargestSide);
  }
  for (const auto& [key, value] :
       {std::pair("width", &box.box.width), std::pair("height", &box.box.height)}) {
    reader.require(key);
    reader.readNumber(key, *value, 1.0, kLargestSide);
  }
  target.recordError(reader.finish());
  return box;
}

TargetShape readShape(TableReader& reader) {
  std::string name = nameOf(TargetShape::Auto);
  reader.readText("shape", name);
  const auto shape = targetShapeFromName(name);
  if (!shape) {
    reader.fail(ErrorCode::BadValue, "shape", "auto, ball or any is expected");
  }
  return shape.value_or(TargetShape::Auto);
}

ColorRange readColor(TableReader& reader) {
  ColorRange color;
  readRange(reader, "hue", color.hueMin, color.hueMax);
  readRange(reader, "saturation", color.saturationMin, color.saturationMax);
  readRange(reader, "intensity", color.intensityMin, color.intensityMax);
  if (const auto good = checkColorRange(color); !good) {
    reader.fail(good.error().code, good.error().field, good.error().detail);
  }
  return color;
}

std::string sampleText(const ColorSample& sample) {
  std::string text =
      fmt::format("[[target.sample]]\ncamera = {}\nframe = {}\n", sample.camera + 1, sample.frame);
  text += sample.isBox() ? fmt::format("box = [{}, {}, {}, {}]   # x, y, width, height\n", sample.x,
                                       sample.y, sample.width, sample.height)
                         : fmt::format("pixel = [{}, {}]\n", sample.x, sample.y);
  if (sample.isExcluded) {
    text += "excluded = true\n";
  }
  if (sample.isFoundByGeometry) {
    text += "found = true   # not clicked\n";
  }
  text += fmt::format("area = {}\ncolors = \"", sample.areaPx);
  const char* space = "";
  for (const auto& [blue, green, red] : sample.colors) {
    text += fmt::format("{}{:02x}{:02x}{:02x}", space, red, green, blue);
    space = " ";
  }
  return text + "\"\n";
}

std::string boxText(const TargetBox& box) {
  return fmt::format("box = {{camera = {}, frame = {}, x = {}, y = {}, width = {}, height = {}}}"
                     "   # px\n",
                     box.camera + 1, box.frame, box.box.x, box.box.y, box.box.width,
                     box.box.height);
}

std::string colorText(const ColorRange& color) {
  return fmt::format("hue = [{}, {}]       # degrees; from > to wraps through 0\n"
                     "saturation = [{}, {}]\n"
                     "intensity = [{}, {}]\n",
                     color.hueMin, color.hueMax, color.saturationMin, color.saturationMax,
                     color.intensityMin, color.intensityMax);
}

} // namespace

Target readTarget(const toml::table& table, const std::string& file, std::size_t index,
                  std::optional<Error>& error) {
  const std::string prefix = fmt::format("target {}.", index + 1);
  TableReader reader(table, file, prefix);
  Target target;
  reader.require("name");
  reader.readText("name", target.name);
  reader.readNumber("radius", target.radius, 0.0, kLargestRadius);
  target.shape = readShape(reader);
  reader.readBoolean("shown", target.isShown);
  target.box = readBox(reader, file, prefix);
  if (!target.box) {
    reader.require("hue");
  }
  target.color = readColor(reader);
  for (const toml::table* other : reader.findTables("other_color")) {
    TableReader color(*other, file,
                      fmt::format("{}other_color {}.", prefix, target.otherColors.size() + 1));
    color.require("hue");
    target.otherColors.push_back(readColor(color));
    reader.recordError(color.finish());
  }
  for (const toml::table* sample : reader.findTables("sample")) {
    target.samples.push_back(readSample(
        *sample, file, fmt::format("{}sample {}.", prefix, target.samples.size() + 1), error));
    reader.recordError(error);
  }
  error = reader.finish();
  return target;
}

std::string targetText(const Target& target) {
  std::string text = fmt::format("\n[[target]]\n"
                                 "name = {}\n"
                                 "radius = {}          # m; 0: unknown\n",
                                 tomlQuoted(target.name), target.radius) +
                     colorText(target.color);
  if (target.shape != TargetShape::Auto) {
    text += fmt::format("shape = {}\n", tomlQuoted(nameOf(target.shape)));
  }
  if (!target.isShown) {
    text += "shown = false   # in the views\n";
  }
  if (target.box) {
    text += boxText(*target.box);
  }
  for (const ColorRange& color : target.otherColors) {
    text += "[[target.other_color]]\n" + colorText(color);
  }
  for (const ColorSample& sample : target.samples) {
    text += sampleText(sample);
  }
  return text;
}

void replaceTargets(Project& project, std::vector<Target> targets) {
  const std::vector<Target> before = std::exchange(project.targets, std::move(targets));
  std::erase_if(project.corrections, [&](PositionCorrection& correction) {
    const std::string& name = before.at(static_cast<std::size_t>(correction.target)).name;
    const auto found = std::ranges::find(project.targets, name, &Target::name);
    correction.target = static_cast<int>(found - project.targets.begin());
    return found == project.targets.end();
  });
}

} // namespace dewpoint::project
