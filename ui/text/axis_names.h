// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace dewpoint::ui {

/// Names of the world axes in fields and messages. They are not translated.
inline constexpr std::array<const char*, 3> kAxisLetters{"X", "Y", "Z"};

} // namespace dewpoint::ui
