// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/broadcast/page_text.h"

#include "ui/text/language.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {

namespace {

class PageText {
  Q_DECLARE_TR_FUNCTIONS(PageText)
};

/// How a time is written, with a place for the number.
QString secondsPattern() {
  const QString zero = numberText(0.0, 0);
  return secondsText(0.0, 0).replace(zero, QStringLiteral("%1"));
}

} // namespace

broadcast::PageTexts pageTexts() {
  broadcast::PageTexts texts;
  texts.language = currentLanguageTag().toStdString();
  texts.title = PageText::tr("Dewpoint live").toStdString();
  texts.viewDescription = PageText::tr("Cameras, targets and their tracks in 3D").toStdString();
  texts.help =
      PageText::tr("Drag: rotate · Wheel or two fingers: zoom · Double click: reset").toStdString();
  texts.connecting = PageText::tr("Connecting…").toStdString();
  texts.waiting = PageText::tr("Connected. Waiting for images…").toStdString();
  texts.disconnected = PageText::tr("Not connected. Trying again…").toStdString();
  //: %1 is the number of a frame, %2 its time
  texts.frame = PageText::tr("Frame %1, %2").toStdString();
  texts.seconds = secondsPattern().toStdString();
  texts.states = {{"held", PageText::tr("tracking").toStdString()},
                  {"ambiguous", PageText::tr("ambiguous").toStdString()},
                  {"hidden", PageText::tr("hidden").toStdString()},
                  {"searching", PageText::tr("searching").toStdString()},
                  {"lost", PageText::tr("lost").toStdString()},
                  {"gone", PageText::tr("not present").toStdString()}};
  texts.otherSiteRefused =
      PageText::tr("Only pages from this server can read the results.").toStdString();
  texts.onlyGetSupported = PageText::tr("Only GET requests are supported.").toStdString();
  texts.pageNotFound = PageText::tr("This server has only one page: /.").toStdString();
  return texts;
}

} // namespace dewpoint::ui
