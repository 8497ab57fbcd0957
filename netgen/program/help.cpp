#include "netgen/program/help.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace epsnet::program {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kColumnOfTexts = 30;  // CLI11's.

/// The column in which a line goes on that is too long.
std::size_t continued_at(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const bool is_row = begin == 2 && line[kColumnOfTexts - 1] == ' ';
  return is_row ? kColumnOfTexts : begin;
}

std::string wrapped_line(std::string_view line) {
  if (line.size() <= kColumns) return std::string(line);
  const std::size_t indent = continued_at(line);
  std::string result(line.substr(0, indent));
  std::size_t column = indent;
  std::istringstream words{std::string(line.substr(indent))};
  for (std::string word; words >> word; column += word.size()) {
    if (column == indent) {
      result += word;
    } else if (column + 1 + word.size() <= kColumns) {
      result += ' ' + word;
      ++column;
    } else {
      result += '\n' + std::string(indent, ' ') + word;
      column = indent;
    }
  }
  return result;
}

}  // namespace

std::string wrapped_help(std::string_view help) {
  std::string result;
  bool in_examples = false;
  std::istringstream lines{std::string(help)};
  for (std::string line; std::getline(lines, line);) {
    in_examples = line.starts_with("Example") || (in_examples && !line.empty());
    result += (in_examples ? line : wrapped_line(line)) + '\n';
  }
  return result;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  return wrapped_help(CLI::Formatter::make_help(app, std::move(name), mode));
}

}  // namespace epsnet::program
