// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLabel;
class QWidget;

#include "core/base/floors.h"

namespace dewpoint::ui {

/// Creates an empty label for the bold heading of a part of a page.
QLabel* makePageTitle(QWidget* parent);

} // namespace dewpoint::ui
