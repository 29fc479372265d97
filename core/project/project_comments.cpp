// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_comments.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace dewpoint::project {
namespace {

using Lines = std::vector<std::string>;

struct Table {
  std::string path; ///< as in its header: "camera.calibration"
  std::string id;   ///< the same with the entry of each array: "camera:left.calibration"
};

/// A key or the header of a table, and the comments that belong to it.
struct Item {
  std::string id;
  std::size_t line = 0;                     ///< where it begins
  Lines above;                              ///< comments, and blank lines between and after them
  std::string behind;                       ///< the comment after the value, with its '#'
  std::size_t behindAt = std::string::npos; ///< where in the last line of the value
  std::size_t lastLine = 0;
};

struct Text {
  Lines lines;
  std::vector<Item> items;
  Lines end; ///< comments after the last item
};

constexpr auto kSpace = " \t";
constexpr auto kSpaceAndQuotes = " \t\"'";

std::string trimmed(std::string_view text, const char* what = kSpaceAndQuotes) {
  const auto first = text.find_first_not_of(what);
  return first == std::string_view::npos
             ? std::string()
             : std::string(text.substr(first, text.find_last_not_of(what) + 1 - first));
}

Lines linesOf(const std::string& text) {
  Lines lines;
  for (std::size_t from = 0; from < text.size();) {
    const auto end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    if (lines.back().ends_with('\r')) {
      lines.back().pop_back();
    }
    from = end + 1;
  }
  return lines;
}

/// Goes from `column` of the item's line to the end of its value, and keeps the comment there.
void findEnd(const Lines& lines, std::size_t column, Item& item) {
  std::string quote; // of the string that the place is in
  int depth = 0;     // of brackets
  for (item.lastLine = item.line; item.lastLine < lines.size(); ++item.lastLine, column = 0) {
    const std::string& line = lines[item.lastLine];
    for (; column < line.size(); ++column) {
      const std::string_view rest = std::string_view(line).substr(column);
      if (!quote.empty()) {
        if (rest[0] == '\\' && quote[0] == '"') {
          ++column;
        } else if (rest.starts_with(quote)) {
          column += quote.size() - 1;
          quote.clear();
        }
      } else if (rest[0] == '"' || rest[0] == '\'') {
        const std::string three(3, rest[0]);
        quote = rest.starts_with(three) ? three : three.substr(0, 1);
        column += quote.size() - 1;
      } else if (rest[0] == '#') {
        item.behind = std::string(rest);
        item.behindAt = column;
        break;
      } else {
        depth += rest[0] == '[' || rest[0] == '{' ? 1 : rest[0] == ']' || rest[0] == '}' ? -1 : 0;
      }
    }
    if (depth <= 0 && quote.size() < 3) {
      return;
    }
    item.behind.clear();
    item.behindAt = std::string::npos;
  }
  --item.lastLine;
}

/// The table whose header is `path`, below the newest entries of the arrays around it.
Table tableOf(const std::string& path, const std::vector<Table>& before) {
  const auto dot = path.rfind('.');
  if (dot == std::string::npos) {
    return {path, path};
  }
  const auto parent = std::find_if(before.rbegin(), before.rend(), [&](const Table& table) {
    return table.path == path.substr(0, dot);
  });
  return {path, parent == before.rend() ? path : parent->id + path.substr(dot)};
}

/// The name that an entry of an array of tables has, read ahead; empty: none.
std::string peekName(const Lines& lines, std::size_t header) {
  for (std::size_t k = header + 1; k < lines.size() && !trimmed(lines[k], kSpace).starts_with('[');
       ++k) {
    const auto equals = lines[k].find('=');
    if (equals != std::string::npos && trimmed(lines[k].substr(0, equals)) == "name") {
      return trimmed(lines[k].substr(equals + 1, lines[k].find('#', equals) - equals - 1));
    }
  }
  return {};
}

Text read(const std::string& text) {
  Text found{linesOf(text), {}, {}};
  std::vector<Table> tables{{}};
  std::map<std::string, int> seen; // ids, so that each is there once
  for (std::size_t k = 0; k < found.lines.size(); ++k) {
    const std::string line = trimmed(found.lines[k], kSpace);
    if (line.starts_with('#') || (line.empty() && !found.end.empty())) {
      found.end.push_back(found.lines[k]);
    }
    if (line.starts_with('#') || line.empty()) {
      continue;
    }
    Item item;
    item.line = k;
    item.above = std::exchange(found.end, {});
    const auto start = found.lines[k].find_first_not_of(" \t");
    if (line.starts_with('[')) {
      const bool isArray = line.starts_with("[[");
      const auto end = line.find(']');
      Table table = tableOf(trimmed(line.substr(isArray ? 2 : 1, end - (isArray ? 2 : 1))), tables);
      if (isArray) {
        table.id = fmt::format("{}:{}", table.id, peekName(found.lines, k));
        table.id = fmt::format("{}/{}", table.id, seen[table.id]++);
      }
      tables.push_back(table);
      item.id = fmt::format("[{}", table.id);
      findEnd(found.lines, start, item);
    } else {
      const auto equals = found.lines[k].find('=');
      item.id = fmt::format("{}={}", tables.back().id, trimmed(found.lines[k].substr(0, equals)));
      findEnd(found.lines, equals == std::string::npos ? start : equals + 1, item);
    }
    k = item.lastLine;
    found.items.push_back(std::move(item));
  }
  return found;
}

/// What was above, and what of the fresh comments was not among it.
Lines merged(Lines former, const Lines& fresh) {
  for (const std::string& line : fresh) {
    if (std::ranges::find(former, line) == former.end()) {
      former.push_back(line);
    }
  }
  return former;
}

} // namespace

std::string withComments(const std::string& fresh, const std::string& former) {
  const Text before = read(former);
  const Text now = read(fresh);
  std::map<std::string, Item> known;
  for (const Item& item : before.items) {
    known.emplace(item.id, item);
  }
  const auto stays = [&](const std::string& id) {
    return std::ranges::find(now.items, id, &Item::id) != now.items.end();
  };
  // The first lines are about the whole file, whatever they stand above.
  Lines head;
  if (!before.items.empty()) {
    Lines& above = known.at(before.items.front().id).above;
    const auto blank = std::find(above.rbegin(), above.rend(), std::string()).base();
    const auto end = stays(before.items.front().id) ? blank : above.end();
    head.assign(above.begin(), end);
    above.erase(above.begin(), end);
  }
  std::string text;
  std::size_t written = 0; // lines of `now`
  for (const Item& item : now.items) {
    const Item& old = known[item.id];
    text.append(item.line - written - item.above.size(), '\n'); // blank ones
    head.insert(head.end(), old.above.begin(), old.above.end());
    for (const std::string& line : merged(std::exchange(head, {}), item.above)) {
      text += line + "\n";
    }
    for (std::size_t k = item.line; k < item.lastLine; ++k) {
      text += now.lines[k] + "\n";
    }
    const std::string& last = now.lines[item.lastLine];
    text += old.behind.empty()            ? last
            : item.behindAt < last.size() ? last.substr(0, item.behindAt) + old.behind
                                          : last + "   " + old.behind;
    text += "\n";
    written = item.lastLine + 1;
  }
  for (const std::string& line : merged(before.end, now.end)) {
    text += line + "\n";
  }
  return text;
}

} // namespace dewpoint::project
