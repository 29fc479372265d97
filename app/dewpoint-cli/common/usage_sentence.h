// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <string>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
class ParseError;
} // namespace CLI

namespace dewpoint::app {

/// What is wrong with a command line, in one sentence: the option, what it may be, where help is.
/// What is unknown is reported before what is missing: it may be the same word misspelt.
std::string usageSentence(const CLI::App& app, const CLI::ParseError& error);

} // namespace dewpoint::app
