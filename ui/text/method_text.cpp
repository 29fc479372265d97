// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/method_text.h"

#include "core/tracking/catalog/method_catalog.h"

#include <QCoreApplication>

#include <string>
#include <string_view>

namespace dewpoint::ui {

namespace {

QString methodTranslated(std::string_view text) {
  return text.empty() ? QString()
                      : QCoreApplication::translate("Method", std::string(text).c_str());
}

QString asItIs(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

MethodTexts methodTexts(const Method& method) {
  return {methodTranslated(tracking::headingOf(method)), methodTranslated(method.text.title),
          methodTranslated(method.text.summary), asItIs(method.name), asItIs(method.text.paper)};
}

QString methodObstacleText(MethodObstacle obstacle) {
  switch (obstacle) {
  case MethodObstacle::None:
    break;
  case MethodObstacle::NoCalibration:
    return QCoreApplication::translate("MethodObstacle", "Needs calibrated cameras.");
  case MethodObstacle::TooFewCameras:
    return QCoreApplication::translate("MethodObstacle", "Needs at least two cameras.");
  }
  return {};
}

} // namespace dewpoint::ui
