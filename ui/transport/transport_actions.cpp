// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/transport/transport_actions.h"

#include "ui/settings/symbolic_icon.h"

#include <QAction>
#include <QActionGroup>
#include <QGuiApplication>
#include <QPalette>

namespace dewpoint {

QString tooltipWithShortcut(const QString& sentence, const QKeySequence& shortcut) {
  return shortcut.isEmpty()
             ? sentence
             : QStringLiteral("%1 (%2)").arg(sentence, shortcut.toString(QKeySequence::NativeText));
}

TransportActions::TransportActions(QObject* parent) : QObject(parent) {
  play = add("actionPlay", tr("Play"), Qt::Key_Space, tr("Play"), "play");
  nextFrame = add("actionNextFrame", tr("Next frame"), Qt::Key_Period,
                  tr("Track one frame and pause"), "next-frame");
  nextIteration = add("actionNextIteration", tr("One iteration"), Qt::Key_I,
                      tr("One filter iteration on the frame shown, and pause"), "iteration");
  restart = add("actionRestart", tr("Restart"), Qt::Key_R,
                tr("Start over with the same random numbers"), "restart");
  restartNewSeed = add("actionRestartNewSeed", tr("Restart with a new seed"), Qt::SHIFT | Qt::Key_R,
                       tr("Start over with other random numbers"), "restart-new");
  showMask = add("actionShowMask", tr("Show mask"), Qt::Key_M,
                 tr("Show where the cameras see the target's color"), "mask");
  showMask->setCheckable(true);
  lookFromAbove = add("actionLookFromAbove", tr("Look from above"), Qt::Key_A,
                      tr("Bird's-eye view from above: the XY plane"), "above");
  lookFromFront = add("actionLookFromFront", tr("Look from the front"), Qt::Key_F,
                      tr("Bird's-eye view from the front: the XZ plane"), "front");
  lookFree = add("actionLookFree", tr("Look freely"), Qt::Key_V,
                 tr("Bird's-eye view from an oblique angle, free to orbit"), "free");
  openProject =
      add("actionOpen", tr("Open project…"), QKeySequence::Open, tr("Open a project"), "open");
  openDemo = add("actionOpenDemo", tr("Open the demo"), {}, tr("Open the simulated demo scene"));
  save = add("actionSave", tr("Save"), QKeySequence::Save, tr("Save the project"), "save");
  saveAs = add("actionSaveAs", tr("Save as…"), Qt::CTRL | Qt::SHIFT | Qt::Key_S,
               tr("Save the project under another name"));
  exportTrajectory = add("actionExportTrajectory", tr("Save trajectory as CSV…"),
                         Qt::CTRL | Qt::Key_E, tr("Save the trajectory so far as CSV"), "export");
  themeSystem = add("actionThemeSystem", tr("Like the system"), {}, tr("Colors of the system"));
  themeLight = add("actionThemeLight", tr("Light"), {}, tr("Light colors"));
  themeDark = add("actionThemeDark", tr("Dark"), {}, tr("Dark colors"));
  quit = add("actionQuit", tr("Quit"), QKeySequence::Quit, tr("Quit Dewpoint"));

  auto* themes = new QActionGroup(this);
  for (QAction* theme : {themeSystem, themeLight, themeDark}) {
    theme->setCheckable(true);
    themes->addAction(theme);
  }
}

QAction* TransportActions::add(const char* name, const QString& text, const QKeySequence& shortcut,
                               const QString& hint, const char* icon) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setShortcut(shortcut);
  action->setToolTip(tooltipWithShortcut(hint, shortcut));
  action->setStatusTip(QString());
  if (icon != nullptr) {
    icons_.emplace_back(action, QLatin1String(icon));
  }
  return action;
}

void TransportActions::adopt(QAction* action, const QString& icon, const QKeySequence& shortcut) {
  action->setShortcut(shortcut);
  icons_.emplace_back(action, icon);
}

void TransportActions::setIconName(QAction* action, const QString& icon) {
  for (auto& [known, name] : icons_) {
    if (known == action && name != icon) {
      name = icon;
      action->setIcon(symbolicIcon(icon, QGuiApplication::palette()));
    }
  }
}

void TransportActions::setPlaying(bool playing) {
  const QString text = playing ? tr("Pause") : tr("Play");
  if (play->text() == text) {
    return;
  }
  play->setText(text);
  play->setToolTip(tooltipWithShortcut(text, play->shortcut()));
  setIconName(play, playing ? QStringLiteral("pause") : QStringLiteral("play"));
}

void TransportActions::drawIcons(const QPalette& palette) {
  for (const auto& [action, name] : icons_) {
    action->setIcon(symbolicIcon(name, palette));
  }
}

} // namespace dewpoint
