// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_pages/declared_command.h"

#include <string>

namespace dewpoint::app {

/// Returns a manual page of section 1 for man(1), as roff in UTF-8. It lists the commands of the
/// program one after the other. `seeAlso` is the name of another manual page to refer to.
std::string manPage(const DeclaredCommand& program, const std::string& version,
                    const std::string& seeAlso);

} // namespace dewpoint::app
