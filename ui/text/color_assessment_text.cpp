// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/color_assessment_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace dewpoint::ui {

namespace {

class ColorText {
  Q_DECLARE_TR_FUNCTIONS(ColorText)
};

/// Where in the image: nine whole phrases, because languages put them together differently.
QString placeName(HorizontalThird horizontal, VerticalThird vertical) {
  static constexpr const char* kPlaces[3][3] = {
      {QT_TRANSLATE_NOOP("ColorText", "at the top left"),
       QT_TRANSLATE_NOOP("ColorText", "at the top"),
       QT_TRANSLATE_NOOP("ColorText", "at the top right")},
      {QT_TRANSLATE_NOOP("ColorText", "at the left"),
       QT_TRANSLATE_NOOP("ColorText", "in the center"),
       QT_TRANSLATE_NOOP("ColorText", "at the right")},
      {QT_TRANSLATE_NOOP("ColorText", "at the bottom left"),
       QT_TRANSLATE_NOOP("ColorText", "at the bottom"),
       QT_TRANSLATE_NOOP("ColorText", "at the bottom right")}};
  return ColorText::tr(kPlaces[static_cast<int>(vertical)][static_cast<int>(horizontal)]);
}

QString separationSentence(int score) {
  const char* text =
      score >= ColorAssessment::kGoodScore
          ? QT_TRANSLATE_NOOP("ColorText", "The color stands out well (%1 of 100 points).")
      : score >= 70 ? QT_TRANSLATE_NOOP("ColorText", "The color stands out (%1 of 100 points).")
      : score >= 40
          ? QT_TRANSLATE_NOOP("ColorText",
                              "The color is hard to tell from the background (%1 of 100 points).")
          : QT_TRANSLATE_NOOP("ColorText", "The color hardly stands out (%1 of 100 points).");
  return ColorText::tr(text).arg(score);
}

QString suggestionSentence(const ColorAssessment& assessment) {
  switch (assessment.suggestion) {
  case ColorSuggestion::AddSamples:
    return ColorText::tr("Much of the target does not have the learned color: Shift-click its "
                         "light and its dark side.");
  case ColorSuggestion::ExcludeDistractor:
    return ColorText::tr(
        "Other objects have this color too: Ctrl+Shift-click them to exclude them.");
  case ColorSuggestion::RemoveDistractor:
    return ColorText::tr("Cover objects of the same color, or take them out of view.");
  case ColorSuggestion::MoreLight:
    return ColorText::tr("The target is nearly black here: more light would help.");
  case ColorSuggestion::LessExposure:
    return ColorText::tr("The target is nearly white here: a shorter exposure would help.");
  case ColorSuggestion::UseStrongerColor:
    return ColorText::tr("The target is nearly gray: a stronger color would help.");
  case ColorSuggestion::UseAnotherColor:
    return ColorText::tr("Several objects have this color: another color would help.");
  case ColorSuggestion::FollowAll:
    return ColorText::tr(
        "%n objects have this color and size: follow all of them, or cover the others.", nullptr,
        assessment.similarObjectCount);
  case ColorSuggestion::ClickObjectItself:
    return ColorText::tr("The clicked region fills much of the image: click only the target, or "
                         "drag a box around the target.");
  case ColorSuggestion::ClickMore:
    return ColorText::tr("You clicked only a speck: drag a box around the whole target.");
  case ColorSuggestion::None:
    break;
  }
  return {};
}

/// What the score is made of: the target that does not match, the background that does.
QString sharesSentence(const ColorAssessment& assessment) {
  const QString background = percentNumber(assessment.backgroundShare, 2);
  if (!assessment.missesTarget() && assessment.isGood()) {
    return background == percentNumber(0.0, 2)
               ? ColorText::tr("Almost nothing else in the images has this color.")
               : ColorText::tr("Only %1 % of the background has this color too, which is little "
                               "compared with the target.")
                     .arg(background);
  }
  if (!assessment.missesTarget()) {
    return ColorText::tr("This color also covers %1 % of the background.").arg(background);
  }
  const QString few =
      ColorText::tr("This color covers only %1 % of the target, and %2 % of the background.")
          .arg(percentNumber(assessment.targetShare, 0), background);
  const double whole = assessment.backgroundShareOfFullRange.value_or(0.0);
  return whole > assessment.backgroundShare
             ? few + QLatin1Char(' ') +
                   ColorText::tr("A color range that covers the whole target would also cover %1 % "
                                 "of the background.")
                       .arg(percentNumber(whole, 2))
             : few;
}

} // namespace

QString colorName(ColorName color) {
  static constexpr const char* kNames[] = {
      QT_TRANSLATE_NOOP("ColorText", "black"),     QT_TRANSLATE_NOOP("ColorText", "gray"),
      QT_TRANSLATE_NOOP("ColorText", "white"),     QT_TRANSLATE_NOOP("ColorText", "brown"),
      QT_TRANSLATE_NOOP("ColorText", "red"),       QT_TRANSLATE_NOOP("ColorText", "orange"),
      QT_TRANSLATE_NOOP("ColorText", "yellow"),    QT_TRANSLATE_NOOP("ColorText", "green"),
      QT_TRANSLATE_NOOP("ColorText", "turquoise"), QT_TRANSLATE_NOOP("ColorText", "blue"),
      QT_TRANSLATE_NOOP("ColorText", "purple"),    QT_TRANSLATE_NOOP("ColorText", "pink")};
  return ColorText::tr(kNames[static_cast<int>(color)]);
}

QString colorAssessmentText(const ColorAssessment& assessment,
                            const std::vector<QString>& cameras) {
  if (!assessment.isTargetKnown) {
    return ColorText::tr("%1 % of the pixels have this color. Shift-click the target to see how "
                         "well its color stands out.")
        .arg(percentNumber(assessment.backgroundShare, 2));
  }
  QStringList sentences{separationSentence(assessment.score()), sharesSentence(assessment)};
  if (assessment.isSampleLeftOut) {
    sentences << ColorText::tr("One sample hardly matches the learned color: the sample resembles "
                               "its surroundings or shows another object.");
  }
  if (!assessment.distractors.empty()) {
    const DistractorRegion& region = assessment.distractors.front();
    const auto camera = static_cast<std::size_t>(region.camera);
    sentences << ColorText::tr("Outside the target, the largest region of this color (%1) is in "
                               "the image of %3, %2.")
                     .arg(colorName(region.color),
                          placeName(region.horizontalThird, region.verticalThird),
                          camera < cameras.size() ? cameras[camera] : QString());
  }
  if (const QString suggestion = suggestionSentence(assessment); !suggestion.isEmpty()) {
    sentences << suggestion;
  }
  return sentences.join(QLatin1Char(' '));
}

} // namespace dewpoint::ui
