#include "netgen/nets/net_record.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/nets/bounds.h"

namespace epsnet {
namespace {

std::string text(std::uint64_t n) { return std::to_string(n); }

/// Seconds with the digits of microseconds; clocks are no more accurate.
std::string seconds_text(double seconds) {
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, seconds, std::chars_format::fixed, 6).ptr};
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string result = "\"";
  for (const char c : field) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

using Columns = std::vector<std::pair<const char*, std::string>>;

Columns columns(const std::string& surface, const UncertifiedNet& net, const certify::Certificate& certificate,
                const NetOptions& options, const NetSeconds& seconds) {
  const NetStatistics& s = net.statistics;
  const certify::Counts& counts = certificate.counts;
  const certify::Enclosures enclosures = certificate.enclosures.value_or(certify::Enclosures{});
  const auto& edge = enclosures.shortest_edge;
  const auto& loop = enclosures.shortest_loop;
  const double loop_or_infinity = loop ? loop->lower : std::numeric_limits<double>::infinity();
  // As a function of epsilon the bound increases and then decreases: on an interval it is least at an end.
  const double systole = std::min(systole_lower_bound(enclosures.epsilon.lower, loop_or_infinity),
                                  systole_lower_bound(enclosures.epsilon.upper, loop_or_infinity));
  return {{"surface", quoted(surface)},
          {"epsilon", net.net.epsilon},
          {"insertion", std::string(name(options.insertion))},
          {"walk", std::string(options.insertion == Insertion::flips ? name(options.walk) : "")},
          {"list", std::string(name(options.list.value_or(TriangleList::large_back)))},
          {"verdict", std::string(certify::name(certificate.verdict))},
          {"genus", text(counts.genus)},
          {"vertices", text(counts.vertices)},
          {"insertions", text(s.insertions)},
          {"flips", text(s.flips)},
          {"initial_flips", text(s.initial_flips)},
          {"removed", text(s.removed)},
          {"located", text(s.located)},
          {"located_at_start", text(s.located_at_start)},
          {"walk_steps", text(s.walk_steps)},
          {"longest_walk", text(s.longest_walk)},
          {"multiprecision", text(s.multiprecision)},
          {"largest_circumradius_upper", certify::decimal_above(enclosures.largest_circumradius.upper)},
          {"shortest_edge_lower", edge ? certify::decimal_below(edge->lower) : ""},
          {"shortest_loop_lower", loop ? certify::decimal_below(loop->lower) : ""},
          {"shortest_loop_upper", loop ? certify::decimal_above(loop->upper) : ""},
          {"systole_lower", certify::decimal_below(systole)},
          {"net_seconds", seconds_text(seconds.net)},
          {"certificate_seconds", seconds_text(seconds.certificate)}};
}

}  // namespace

std::string net_record_columns() {
  std::string result;
  for (const auto& [name, value] : columns({}, {}, {}, {}, {}))
    result += (result.empty() ? "" : ",") + std::string(name);
  return result;
}

std::string net_record(const std::string& surface, const UncertifiedNet& net, const certify::Certificate& certificate,
                       const NetOptions& options, const NetSeconds& seconds) {
  std::string result;
  for (const auto& [name, value] : columns(surface, net, certificate, options, seconds))
    result += (name == std::string_view("surface") ? "" : ",") + value;
  return result;
}

}  // namespace epsnet
