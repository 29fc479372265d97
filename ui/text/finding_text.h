// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::setup {
struct Finding;
} // namespace dewpoint::setup

namespace dewpoint::ui {

/// Returns a finding of the project check as a translated sentence.
QString findingText(const Finding& finding);
/// Returns the translated action that a finding recommends; empty if there is nothing to do.
QString findingAdvice(const Finding& finding);
/// Returns the file and field of a finding, for example "room.toml: camera 1.video"; may be empty.
QString findingLocationText(const Finding& finding);

} // namespace dewpoint::ui
