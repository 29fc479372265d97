// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/project/color_sentences.h"

#include "core/base/units.h"
#include "core/setup/clicks/click_learning.h"

#include <fmt/format.h>

namespace dewpoint::app {
namespace {

const char* separation(int score) {
  return score >= 90   ? "The color stands out well"
         : score >= 70 ? "The color stands out"
         : score >= 40 ? "The color is hard to tell from the background"
                       : "The color hardly stands out";
}

const char* nameOf(ColorName word) {
  static constexpr const char* kNames[] = {"black",     "gray",   "white",  "brown",
                                           "red",       "orange", "yellow", "green",
                                           "turquoise", "blue",   "purple", "pink"};
  return kNames[static_cast<int>(word)];
}

std::string partOfImage(const DistractorRegion& region) {
  static constexpr const char* kParts[3][3] = {
      {"at the top left", "at the top", "at the top right"},
      {"at the left", "in the center", "at the right"},
      {"at the bottom left", "at the bottom", "at the bottom right"}};
  return kParts[static_cast<int>(region.verticalThird)][static_cast<int>(region.horizontalThird)];
}

const char* advice(ColorSuggestion suggestion) {
  switch (suggestion) {
  case ColorSuggestion::AddSamples:
    return "Much of the target does not have the learned color: add its light and its dark side "
           "with "
           "--more.";
  case ColorSuggestion::ExcludeDistractor:
    return "Other objects have this color too: exclude them with --exclude.";
  case ColorSuggestion::RemoveDistractor:
    return "Cover objects of the same color, or take them out of view.";
  case ColorSuggestion::MoreLight:
    return "The target is nearly black here: more light would help.";
  case ColorSuggestion::LessExposure:
    return "The target is nearly white here: a shorter exposure would help.";
  case ColorSuggestion::UseStrongerColor:
    return "The target is nearly gray: a stronger color would help.";
  case ColorSuggestion::UseAnotherColor:
    return "Several objects have this color: another color would help.";
  case ColorSuggestion::FollowAll:
    return "Several objects have this color and size: make each of them a target, or cover the "
           "others.";
  case ColorSuggestion::ClickObjectItself:
    return "The clicked region fills much of the image: click only the target, or give a box on "
           "it.";
  case ColorSuggestion::ClickMore:
    return "You clicked only a speck: give a box on the whole target.";
  case ColorSuggestion::None:
    break;
  }
  return "";
}

} // namespace

std::string describeRange(const ColorRange& range) {
  return fmt::format("Hue {:.0f} to {:.0f} degrees, saturation {:.2f} to {:.2f}, intensity {:.2f} "
                     "to {:.2f}.",
                     range.hueMin, range.hueMax, range.saturationMin, range.saturationMax,
                     range.intensityMin, range.intensityMax);
}

std::vector<std::string> describeAssessment(const ColorAssessment& assessment,
                                            const std::vector<std::string>& cameras) {
  std::vector<std::string> sentences{
      fmt::format("{} ({} of 100 points).", separation(assessment.score()), assessment.score()),
      fmt::format("{:.0f} % of the target and {:.2f} % of the background have this color.",
                  inPercent(assessment.targetShare), inPercent(assessment.backgroundShare))};
  if (assessment.backgroundShareOfFullRange) {
    sentences.push_back(
        fmt::format("A color range that covers the whole target would also cover {:.2f} % of the "
                    "background.",
                    inPercent(*assessment.backgroundShareOfFullRange)));
  }
  if (assessment.isSampleLeftOut) {
    sentences.emplace_back("One sample hardly matches the learned color: the sample resembles its "
                           "surroundings or shows another object.");
  }
  for (const DistractorRegion& region : assessment.distractors) {
    const cv::Point middle = (region.box.tl() + region.box.br()) / 2;
    sentences.push_back(
        fmt::format("In the image of {2}, a {0} region {1} has this color too, near pixel {3},{4}.",
                    nameOf(region.color), partOfImage(region),
                    cameras.at(static_cast<std::size_t>(region.camera)), middle.x, middle.y));
  }
  if (const std::string text = advice(assessment.suggestion); !text.empty()) {
    sentences.push_back(text);
  }
  return sentences;
}

std::string describeRadius(double given, const std::optional<double>& shown) {
  const auto fit =
      shown && given > 0.0 ? setup::compareRadius(given, *shown) : setup::RadiusFit::Differs;
  if (!shown || fit == setup::RadiusFit::Fits) {
    return {};
  }
  std::string text = fmt::format("The target's radius seems to be about {:.2g} m", *shown);
  if (given > 0.0) {
    text += fmt::format(", but {:g} m is given", given);
  }
  return text + (fit == setup::RadiusFit::IsDiameter ? ". Is the given value the diameter?" : ".");
}

} // namespace dewpoint::app
