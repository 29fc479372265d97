// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::base {
struct Error;
} // namespace dewpoint::base

namespace dewpoint::ui {

/// The sentence of an error for the user, in the language of the window; file, field and
/// particulars stay as they are.
QString errorSentence(const Error& error);

} // namespace dewpoint::ui
