// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled header: headers of other libraries that most files of the window include. The
// compiler parses them once per build.
#pragma once

#include "core/precompiled.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QString>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <QWidget>
