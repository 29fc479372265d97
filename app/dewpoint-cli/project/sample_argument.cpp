// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/project/sample_argument.h"

#include "core/base/text_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace dewpoint::app {
namespace {

/// Numbers between commas; nothing when one of them is none.
std::optional<std::vector<double>> numbersIn(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const auto comma = text.find(',');
    const auto number = toNumber<double>(text.substr(0, comma));
    if (!number) {
      return std::nullopt;
    }
    numbers.push_back(*number);
    if (comma == std::string_view::npos) {
      return numbers;
    }
    text.remove_prefix(comma + 1);
  }
}

tl::unexpected<Error> expected(const char* option, const char* form, const std::string& found) {
  return failure(ErrorCode::BadValue, "", option,
                 fmt::format("expected {}, found {}", form, found));
}

} // namespace

Result<int> findCameraIndex(const Project& project, const std::string& text, const char* option) {
  const auto& cameras = project.cameras;
  const auto named = std::ranges::find(
      cameras, text, [](const ProjectCamera& camera) { return camera.camera.name; });
  if (named != cameras.end()) {
    return static_cast<int>(named - cameras.begin());
  }
  const auto number = toNumber<int>(text);
  if (number && *number >= 1 && *number <= static_cast<int>(cameras.size())) {
    return *number - 1;
  }
  return failure(ErrorCode::BadValue, "", option,
                 fmt::format("none of the {} cameras is called {}", cameras.size(), text));
}

Result<ColorSample> parseClick(const std::string& text, const char* option) {
  const auto numbers = numbersIn(text);
  if (!numbers || numbers->size() != 2) {
    return expected(option, "X,Y", text);
  }
  ColorSample sample;
  sample.x = numbers->at(0);
  sample.y = numbers->at(1);
  return sample;
}

Result<ColorSample> parseBox(const std::string& text, const char* option) {
  const auto numbers = numbersIn(text);
  if (!numbers || numbers->size() != 4 || !(numbers->at(2) > 0.0) || !(numbers->at(3) > 0.0)) {
    return expected(option, "X,Y,WIDTH,HEIGHT", text);
  }
  ColorSample sample;
  sample.x = numbers->at(0);
  sample.y = numbers->at(1);
  sample.width = numbers->at(2);
  sample.height = numbers->at(3);
  return sample;
}

Result<ColorSample> parseSample(const Project& project, const std::string& text,
                                const char* option) {
  // From the right: a camera's name may hold a colon.
  const auto second = text.rfind(':');
  const auto first =
      second == std::string::npos || second == 0 ? std::string::npos : text.rfind(':', second - 1);
  const auto frame =
      first == std::string::npos
          ? std::nullopt
          : toNumber<std::int64_t>(std::string_view(text).substr(first + 1, second - first - 1));
  if (!frame || *frame < 0) {
    return expected(option, "CAMERA:FRAME:X,Y", text);
  }
  const auto camera = findCameraIndex(project, text.substr(0, first), option);
  if (!camera) {
    return tl::make_unexpected(camera.error());
  }
  auto sample = parseClick(text.substr(second + 1), option);
  if (sample) {
    sample->camera = *camera;
    sample->frame = *frame;
  }
  return sample;
}

} // namespace dewpoint::app
