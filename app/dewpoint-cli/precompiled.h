// SPDX-License-Identifier: GPL-3.0-or-later
// The headers of other libraries that most commands include: parsed once a build.
#pragma once

#include "core/precompiled.h"

#include <CLI/CLI.hpp>
