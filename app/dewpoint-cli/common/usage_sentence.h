// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
class ParseError;
} // namespace CLI

namespace dewpoint::app {

/// Returns one sentence that describes an error in the command line: the option, its allowed
/// values, and where to find help. An unknown word is reported rather than a missing one, because a
/// misspelled word causes both errors.
std::string describeUsageError(const CLI::App& app, const CLI::ParseError& error);

} // namespace dewpoint::app
