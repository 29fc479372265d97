// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bridge/bump_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <numbers>

namespace dewpoint {

const BumpReport* bumpOf(const TrackSnapshot& snapshot, int camera) {
  const BumpReport* found = nullptr;
  for (const BumpReport& report : snapshot.bumps) {
    if (static_cast<int>(report.event.camera) == camera && !report.back) {
      found = &report;
    }
  }
  return found;
}

QString bumpText(const BumpReport* report) {
  if (report == nullptr) {
    return {};
  }
  const double degrees = report->event.turn.turn.norm() * 180.0 / std::numbers::pi;
  return QCoreApplication::translate("Bump", "turned by %1°")
      .arg(QLocale().toString(degrees, 'f', 2));
}

} // namespace dewpoint
