// SPDX-License-Identifier: GPL-3.0-or-later
// The headers of other libraries that most tests of core include: parsed once a build.
#pragma once

#include "core/precompiled.h"

#include <gtest/gtest.h>
