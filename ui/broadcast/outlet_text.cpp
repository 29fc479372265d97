// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/broadcast/outlet_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

namespace {

class OutletText {
  Q_DECLARE_TR_FUNCTIONS(OutletText)
};

} // namespace

QString outletAddress(const broadcast::OutletReport& report) {
  const QString address = QString::fromStdString(report.address);
  switch (report.kind) {
  case broadcast::OutletKind::JsonLines:
    return OutletText::tr("JSON lines at %1").arg(address);
  case broadcast::OutletKind::WebPage:
    return OutletText::tr("Web page and WebSocket at %1").arg(address);
  case broadcast::OutletKind::OscMessages:
    return OutletText::tr("OSC messages to %1").arg(address);
  case broadcast::OutletKind::TuioCursors:
    return OutletText::tr("TUIO cursors to %1").arg(address);
  case broadcast::OutletKind::CsvLines:
    break;
  }
  return report.address == "-" ? OutletText::tr("CSV lines to the standard output")
                               : OutletText::tr("CSV lines to %1").arg(address);
}

QString outletProblem(const broadcast::OutletReport& report) {
  if (report.hasNoReader) {
    return OutletText::tr("No program is reading this pipe.");
  }
  return report.problem.empty() ? QString()
                                : OutletText::tr("Nothing can be written: %1")
                                      .arg(QString::fromStdString(report.problem));
}

} // namespace dewpoint::ui
