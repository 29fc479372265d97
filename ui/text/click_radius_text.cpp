// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/click_radius_text.h"

#include "core/setup/clicks/click_learning.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

namespace {

struct ClickRadiusText {
  Q_DECLARE_TR_FUNCTIONS(ClickRadiusText)
};

} // namespace

QString clickRadiusText(double given, const std::optional<double>& shown) {
  if (!shown) {
    return {};
  }
  const QString seen = lengthText(*shown, LengthForm::TwoDigits);
  if (given <= 0.0) {
    return ClickRadiusText::tr("The target's radius seems to be about %1.").arg(seen);
  }
  const QString declared = lengthText(given, LengthForm::TwoDigits);
  switch (setup::compareRadius(given, *shown)) {
  case setup::RadiusFit::Fits:
    return {};
  case setup::RadiusFit::IsDiameter:
    return ClickRadiusText::tr(
               "The target's radius seems to be about %1, but %2 was entered. Is %2 the diameter?")
        .arg(seen, declared);
  case setup::RadiusFit::Differs:
    return ClickRadiusText::tr("The target's radius seems to be about %1, but %2 was entered.")
        .arg(seen, declared);
  }
  return {};
}

QString markedPartText(double radius) {
  return ClickRadiusText::tr("The marked spot is part of a larger object of the same color. Only "
                             "this spot is tracked, as a ball with radius %1.")
      .arg(lengthText(radius, LengthForm::TwoDigits));
}

} // namespace dewpoint::ui
