// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <functional>

class QWidget;

namespace dewpoint::ui {

/// Calls `retranslate` now and after every change of language while `widget` exists. For every
/// setText(tr(...)) of a widget that outlives a change of language.
void onRetranslate(QWidget* widget, std::function<void()> retranslate);

} // namespace dewpoint::ui
