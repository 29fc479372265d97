// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled header: headers of other libraries that most commands include. The compiler parses
// them once per build.
#pragma once

#include "core/precompiled.h"

#include <CLI/CLI.hpp>
