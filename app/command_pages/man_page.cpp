// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <regex>

namespace dewpoint::app {
namespace {

/// Plain text for roff: no escape, and no line that a program would take for a request.
std::string roff(const std::string& text) {
  std::string escaped = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  if (escaped.starts_with('.') || escaped.starts_with('\'')) {
    escaped.insert(0, "\\&");
  }
  return replaced(replaced(escaped, "\n.", "\n\\&."), "\n'", "\n\\&'");
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

/// "Dewpoint: tracks objects." as "tracks objects", as whatis(1) shows it.
std::string summaryOf(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  std::string summary = colon == std::string::npos ? sentence : sentence.substr(colon + 2);
  if (summary.ends_with('.')) {
    summary.pop_back();
  }
  if (!summary.empty()) {
    summary[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(summary[0])));
  }
  return summary;
}

std::string usageOf(const DeclaredCommand& command) {
  std::string line = bold(joined(command.path, " "));
  const auto isRequired = [](const DeclaredArgument& option) { return option.isRequired; };
  for (const DeclaredArgument& option : command.options) {
    if (isRequired(option)) {
      line += " " + bold(option.names.back()) + " " + italic(option.valueKind);
    }
  }
  if (!std::ranges::all_of(command.options, isRequired)) {
    line += " [" + italic("options") + "]";
  }
  for (const DeclaredArgument& positional : command.positionals) {
    const std::string name =
        italic(positional.names.front()) + (positional.isRepeatable ? " ..." : "");
    line += positional.isRequired ? " " + name : " [" + name + "]";
  }
  return command.subcommands.empty() ? line : line + " " + italic("command") + " ...";
}

/// "INT in [1 - 256]" as " From 1 to 256."
std::string rangeInWords(const std::string& range) {
  static const std::regex kRange(R"(.* in \[(\S+) - (\S+)\])");
  constexpr double kEndless = 1e9; // a limit that nobody reaches is none
  std::smatch part;
  if (range == "POSITIVE") {
    return " Above 0.";
  }
  if (!std::regex_match(range, part, kRange)) {
    return {};
  }
  const bool endless = std::strtod(part.str(2).c_str(), nullptr) > kEndless;
  return endless ? fmt::format(" {} or more.", part.str(1))
                 : fmt::format(" From {} to {}.", part.str(1), part.str(2));
}

/// What else is to be known of an argument, behind its sentence.
std::string detailsOf(const DeclaredArgument& argument) {
  std::string details = argument.choices.empty()
                            ? rangeInWords(argument.range)
                            : fmt::format(" One of {}.", joined(argument.choices, ", "));
  if (!argument.defaultValue.empty()) {
    details += fmt::format(" Default: {}.", argument.defaultValue);
  }
  if (argument.isRequired) {
    details += " Required.";
  }
  return details + (argument.isRepeatable ? " May be given several times." : "");
}

std::string paragraphOf(const DeclaredArgument& argument, bool isOption) {
  std::vector<std::string> names;
  for (const std::string& name : argument.names) {
    names.push_back(isOption ? bold(name) : italic(name));
  }
  std::string head = joined(names, ", ");
  if (isOption && !argument.valueKind.empty()) {
    head += " " + italic(argument.valueKind);
  }
  const bool ends = argument.description.empty() || argument.description.ends_with('.');
  return fmt::format(".TP\n{}\n{}{}{}\n", head, roff(argument.description), ends ? "" : ".",
                     roff(detailsOf(argument)));
}

std::string argumentsOf(const DeclaredCommand& command) {
  std::string text;
  for (const DeclaredArgument& positional : command.positionals) {
    text += paragraphOf(positional, false);
  }
  for (const DeclaredArgument& option : command.options) {
    text += paragraphOf(option, true);
  }
  return text;
}

} // namespace

std::string manPage(const DeclaredCommand& program, const std::string& version,
                    const std::string& seeAlso) {
  const std::string& name = program.path.front();
  std::string upper = name;
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
  std::string page =
      fmt::format(".TH {} 1 \"\" \"Dewpoint {}\" \"User Commands\"\n.ad l\n", roff(upper), version);
  page += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}\n", roff(name),
                      roff(summaryOf(program.description)), usageOf(program));
  page += fmt::format(".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}", roff(program.description),
                      argumentsOf(program));
  if (!program.subcommands.empty()) {
    page += ".SH COMMANDS\n";
    for (const DeclaredCommand* command : commandAndSubcommands(program)) {
      if (command != &program) {
        page += fmt::format(".SS {}\n{}\n.PP\n{}\n{}", roff(pathWithoutProgram(*command)),
                            usageOf(*command), roff(command->description), argumentsOf(*command));
      }
    }
  }
  if (!program.footer.empty()) {
    page += fmt::format(".SH EXIT STATUS\n{}\n", roff(program.footer));
  }
  return page + fmt::format(".SH SEE ALSO\n{}(1)\n", bold(seeAlso));
}

} // namespace dewpoint::app
