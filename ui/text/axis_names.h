// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace dewpoint::ui {

/// The world's axes as fields and messages name them; no words, so they are not translated.
inline constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};

} // namespace dewpoint::ui
